// SPDX-License-Identifier: Apache-2.0
// scene: - generated.
#include "job/job_types.h"

namespace umbrage {

Type<GeneratedLayer> generatedLayer() {
    using Made = GeneratedLayer;
    struct Generated {
        Made layer;
    };
    const auto layer = mapping<Made>(
        "generated",
        "Bodies over a ground, lights above them and a camera that glides past: the same for the same numbers. Every "
        "body is a closed mesh of its own, a sphere that noise pushes in and out. To see how cost grows.",
        {
            field<Made>("triangles", integer(between(8, 64e6)), &Made::triangles,
                        "Of all bodies, as near as can be; no body has fewer than 8"),
            field<Made>("columns", integer(between(1, 1e5)), &Made::columns, "Columns of bodies, on a square grid"),
            field<Made>("layers", integer(between(1, 1e4)), &Made::layers,
                        "Bodies above each other in a column, the flatter the more there are"),
            field<Made>("roughness", number(between(0, 1)), &Made::roughness,
                        "How far noise pushes the surface, in parts of a body's size"),
            field<Made>("moving", number(between(0, 100)), &Made::moving, "How many of the bodies move").in("per cent"),
            field<Made>("lights", integer(between(1, 1e4)), &Made::lights,
                        "Point lights; together they are as bright however many there are"),
            field<Made>("movingLights", boolean(), &Made::movingLights, "Whether the lights move"),
            field<Made>("lightRange", number(atLeast(0)), &Made::lightRangeMetres, "Where lights end; 0: nowhere")
                .in("metres"),
        });
    return converted<Made>(
        mapping<Generated>(
            "generated layer", "A scene that is made when it is asked for.",
            {field<Generated>("generated", layer, &Generated::layer, "What is in it, see generated").required()}),
        [](const Generated& generated, const YamlNode&) { return generated.layer; });
}

}  // namespace umbrage
