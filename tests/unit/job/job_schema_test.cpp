// SPDX-License-Identifier: Apache-2.0
// The schema and the reference say what the parser does.
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "../json_schema.h"
#include "expect_error.h"
#include "job/job_fields.h"
#include "job/yaml_tree.h"

namespace umbrage {
namespace {

Json asJson(const YamlNode& node) {
    Json json;
    if (const auto integer = integerOf(node)) return *integer;
    if (const auto number = numberOf(node)) return *number;
    if (node.isScalar() && node.plain && (node.scalar == "true" || node.scalar == "false"))
        return node.scalar == "true";
    if (node.isScalar()) return node.scalar;
    if (node.isSequence()) json = Json::array();
    if (node.isMapping()) json = Json::object();
    for (std::size_t i = 0; i < node.items.size(); ++i) {
        if (node.isSequence())
            json.push_back(asJson(node.items[i]));
        else
            json[node.keys[i].scalar] = asJson(node.items[i]);
    }
    return json;
}

bool parserAccepts(const std::string& yaml) {
    try {
        read(yaml);
        return true;
    } catch (const Error&) {
        return false;
    }
}

TEST(JobSchema, AgreesWithTheParser) {
    const Json schema = Json::parse(jobSchema());
    const std::string start = "umbrage: 1\nscene: [{gltf: a.glb}]\n";
    const std::vector<std::string> parts = {
        // accepted
        "", "lights: []", "lights: [{type: spot, name: a, intensity: 3, color: {0: [1, 1, 1], .5: [0, 0, 0]}}]",
        "lights: [{type: point, name: a, intensity: {-1: 3, 1e1: 4}, interpolation: step}]", "camera: /A", "camera: 0",
        "camera: {}", "camera: {type: perspective, yfov: 30, position: {0: [1, 2, 3]}}", "animations: [0, walk]",
        "displace: {/A: {kind: noise}, \"/B*\": {amplitude: 2}}", "time: {fps: 29.97, frames: 1-10x2}",
        "time: {frames: [1, 2-3]}", "time: {frames: \"-5--2, 7\"}", "time: {frames: 12}",
        "image: {size: [1, 2], samples: 8, background: [0, 0, 0], ambient: {sky: [1, 1, 1]}}",
        "shadow: {enabled: off, count: auto, skips: {halve: true, range: no}}", "color: {view: x, exposure: -1}",
        "diagnostics: {overlays: [stencil], profile: true}",
        "output: {aovs: {depth: exr}, pngBits: 16, exrHalf: false}", "statistics: {path: a.json, page: a.html}",
        // refused
        "shadwo: {}", "lights: {}", "lights: [{type: point}]", "lights: [{type: disk, name: a}]",
        "lights: [{type: point, name: a, intensity: -1}]", "lights: [{type: point, name: a, intensity: {}}]",
        "lights: [{type: point, name: a, intensity: {soon: 1}}]", "lights: [{type: point, name: a, color: [1, 1]}]",
        "camera: -1", "camera: {yfov: 0}", "camera: {yfov: 180}", "camera: [0]", "camera: \"\"", "animations: 0",
        "animations: [-1]", "displace: [/A]", "displace: {/A: {kind: waves}}", "time: {fps: 0}", "time: {frames: 1:3}",
        "time: {frames: 1.5}", "time: {frames: []}", "time: 3", "image: {size: [1]}", "image: {size: [0, 1]}",
        "image: {size: [1, 1.5]}", "image: {samples: 3}", "image: {background: 1}", "image: {ambient: {up: [0, 0, 0]}}",
        "shadow: {enabled: 1}", "shadow: {count: x}", "color: {view: 1}", "color: {exposure: x}",
        "diagnostics: {overlays: [x]}", "diagnostics: {overlays: stencil}", "output: {aovs: {x: png}}",
        "output: {aovs: {depth: tiff}}", "output: {aovs: {depth: png}}", "shadow: {skips: {haze: no}}",
        "output: {pngBits: 9}", "output: {path: 3}", "statistics: x"};
    int accepted = 0;
    for (const std::string& part : parts) {
        SCOPED_TRACE(part);
        const std::string yaml = start + part + "\n";
        const bool accepts = parserAccepts(yaml);
        accepted += accepts;
        EXPECT_EQ(validates(schema, asJson(parseYaml(yaml, "s.yaml"))), accepts);
    }
    EXPECT_EQ(accepted, 20);
    for (const std::string scene :
         {"[]", "{}", "[{glb: a}]", "[{gltf: 1}]", "[{gltf: a, scale: [1, 1]}]", "[{over: {}, at: /A}]",
          "[{gltf: a}, {over: {/A: {light: {intensity: x}}}}]", "[{gltf: a}, {over: {/A: {}}}]"}) {
        SCOPED_TRACE(scene);
        const std::string yaml = "umbrage: 1\nscene: " + scene + "\n";
        EXPECT_FALSE(parserAccepts(yaml));
        // That a scene is not empty is the one thing here that the schema leaves to the parser.
        EXPECT_EQ(validates(schema, asJson(parseYaml(yaml, "s.yaml"))), scene == "[]");
    }
}

/// Calls `visit` on every schema of a mapping in `schema`.
void forEachMapping(const Json& schema, const std::function<void(const Json&)>& visit) {
    if (schema.is_object() && schema.contains("properties")) visit(schema);
    if (schema.is_structured())
        for (const auto& [key, inner] : schema.items()) forEachMapping(inner, visit);
}

TEST(JobSchema, EveryKeyIsDescribedAndEveryDefaultIsValid) {
    int mappingCount = 0, defaultCount = 0;
    forEachMapping(Json::parse(jobSchema()), [&](const Json& mapping) {
        ++mappingCount;
        EXPECT_EQ(mapping["additionalProperties"], false);
        for (const auto& [key, property] : mapping["properties"].items()) {
            SCOPED_TRACE(key);
            EXPECT_FALSE(property["description"].get<std::string>().empty());
            if (!property.contains("default")) continue;
            ++defaultCount;
            EXPECT_TRUE(validates(property, property["default"])) << property["default"];
        }
    });
    EXPECT_GE(mappingCount, 15);
    EXPECT_GE(defaultCount, 30);
}

TEST(JobSchema, EveryKeyOfTheTableIsInTheReference) {
    const std::string reference = jobReference();
    int keyCount = 0;
    forEachMapping(Json::parse(jobSchema()), [&](const Json& mapping) {
        for (const auto& [key, property] : mapping["properties"].items()) {
            ++keyCount;
            EXPECT_THAT(reference, testing::HasSubstr("| `" + key + "` |"));
        }
    });
    EXPECT_GE(keyCount, 60);
}

TEST(JobSchema, TheReferenceInTheRepositoryIsTheOneOfTheTable) {
    std::ifstream file(UMBRAGE_SOURCE_DIR "/docs/sequence.md", std::ios::binary);
    const std::string written{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(written == jobReference()) << "run: umbrage schema --markdown > docs/sequence.md";
}

TEST(JobSchema, OfDraft2020) {
    EXPECT_EQ(Json::parse(jobSchema())["$schema"], "https://json-schema.org/draft/2020-12/schema");
}

}  // namespace
}  // namespace umbrage
