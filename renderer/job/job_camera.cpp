// SPDX-License-Identifier: Apache-2.0
// camera: by name, or described.
#include "job/job_types.h"

namespace umbrage {
namespace {

void checkCamera(const JobCamera& camera, const YamlNode& node) {
    const auto only = [&](const char* key, bool meaningful, const char* type) {
        if (const YamlNode* value = node.find(key); value && !meaningful)
            refuse(*value, fmt::format("\"{}\" is only for {} cameras", key, type));
    };
    only("yfov", camera.perspective, "perspective");
    only("ymag", !camera.perspective, "orthographic");
    const YamlNode* far = node.find("zfar");
    if (!camera.perspective && camera.zfar == 0)
        refuse(far ? *far : node, "an orthographic camera needs a zfar",
               "add zfar: metres to the farthest visible point");
    if (camera.zfar != 0 && camera.zfar <= camera.znear)
        refuse(*far, fmt::format("zfar must be greater than znear, which is {}", camera.znear));
}

}  // namespace

Type<JobCamera> camera() {
    const auto byName = converted<JobCamera>(nameOrIndex(), [](const std::string& name, const YamlNode& node) {
        return JobCamera{.node = {name, node.place}};
    });
    const auto described = converted<JobCamera>(
        mapping<JobCamera>(
            "camera", "A camera of the sequence's own. +Y is up.",
            {
                field<JobCamera>("type", choiceOf<bool>({{"perspective", true}, {"orthographic", false}}),
                                 &JobCamera::perspective, "Kind of projection"),
                field<JobCamera>("position", sampled<3>(point()), &JobCamera::position, "Where the eye is")
                    .in("metres"),
                field<JobCamera>("target", sampled<3>(point()), &JobCamera::target, "The point it looks at")
                    .in("metres"),
                field<JobCamera>("yfov", number({0, 180, true, true}), &JobCamera::yfovDegrees,
                                 "Perspective: the vertical field of view")
                    .in("degrees"),
                field<JobCamera>("ymag", number(above(0)), &JobCamera::ymag, "Orthographic: half the visible height")
                    .in("metres"),
                field<JobCamera>("znear", number(above(0)), &JobCamera::znear, "Distance of the near plane")
                    .in("metres"),
                field<JobCamera>("zfar", number(atLeast(0)), &JobCamera::zfar,
                                 "Distance of the far plane; 0: infinite, for perspective cameras")
                    .in("metres"),
                field<JobCamera>("interpolation", interpolation(), &JobCamera::interpolation,
                                 "Between the time samples"),
            },
            checkCamera),
        [](JobCamera camera, const YamlNode& node) {
            camera.described = true;
            camera.node.place = node.place;
            return camera;
        });
    return either(byName, described, [](const YamlNode& node) { return node.isScalar(); });
}

}  // namespace umbrage
