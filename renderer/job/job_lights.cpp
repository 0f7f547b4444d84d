// SPDX-License-Identifier: Apache-2.0
// lights: of the sequence's own, and what over: says about those of the files.
#include <glm/trigonometric.hpp>

#include "job/job_types.h"

namespace umbrage {
namespace {

Type<Sampled<1>> sampledDegrees(const Limits& limits) {
    return converted<Sampled<1>>(sampledNumber(limits), [](Sampled<1> angle, const YamlNode&) {
        for (Single& value : angle.values) value[0] = glm::radians(value[0]);
        return angle;
    });
}

/// What lights: and over: say about a light, as keys of S; `part` finds the opinion in S.
template <class S, class Part>
std::vector<Field<S>> lightFields(Part part, bool isNew) {
    const auto otherwise = [isNew](const char* ofNew) { return isNew ? ofNew : "as it is"; };
    const auto member = [part](auto pointer) {
        return [=](S & s) -> auto& {
            return part(s).*pointer;
        };
    };
    std::vector<Field<S>> fields;
    fields.push_back(field<S>("intensity", opinion(sampledNumber(atLeast(0))), member(&LightOpinion::intensity),
                              "Luminous intensity; of a directional light the illuminance")
                         .in("candela; lux")
                         .unset(otherwise("1")));
    fields.push_back(
        field<S>("color", opinion(sampled<3>(color())), member(&LightOpinion::color), "Colour of the light")
            .unset(otherwise("white")));
    fields.push_back(field<S>("range", opinion(sampledNumber(atLeast(0))), member(&LightOpinion::rangeMetres),
                              "Where a point or spot light ends; 0: nowhere")
                         .in("metres")
                         .unset(otherwise("0")));
    fields.push_back(field<S>("innerConeAngle", opinion(sampledDegrees({.least = 0, .most = 90, .mostExcluded = true})),
                              member(&LightOpinion::innerConeAngle),
                              "Spot lights: from the axis to where the light begins to fall off")
                         .in("degrees")
                         .unset(otherwise("0")));
    fields.push_back(field<S>("outerConeAngle",
                              opinion(sampledDegrees({.least = 0, .most = 90, .leastExcluded = true})),
                              member(&LightOpinion::outerConeAngle),
                              "Spot lights: from the axis to where it ends; wider than the inner cone")
                         .in("degrees")
                         .unset(otherwise("45")));
    fields.push_back(field<S>("interpolation", interpolation(), member(&LightOpinion::interpolation),
                              "Between the time samples; they are held at both ends"));
    return fields;
}

void checkLight(const JobLight& light, const YamlNode& node) {
    if (light.name.value.find('/') != std::string::npos)
        refuse(*node.find("name"), "a light's name cannot have a '/'", "its path will be /lights/NAME");
    const auto only = [&](const char* key, bool meaningful, const char* types) {
        if (const YamlNode* value = node.find(key); value && !meaningful)
            refuse(*value, fmt::format("\"{}\" is only for {} lights", key, types));
    };
    only("innerConeAngle", light.type == JobLightType::Spot, "spot");
    only("outerConeAngle", light.type == JobLightType::Spot, "spot");
    only("target", light.type != JobLightType::Point, "spot and directional");
    only("range", light.type != JobLightType::Directional, "point and spot");
}

Type<JobLight> extraLight() {
    std::vector<Field<JobLight>> fields = {
        field<JobLight>("type",
                        choiceOf<JobLightType>({{"point", JobLightType::Point},
                                                {"spot", JobLightType::Spot},
                                                {"directional", JobLightType::Directional}}),
                        &JobLight::type, "Kind of light, as in KHR_lights_punctual")
            .required(),
        field<JobLight>("name", located(text()), &JobLight::name, "Unique among these lights; its path is /lights/NAME")
            .required(),
        field<JobLight>("position", sampled<3>(point()), &JobLight::position, "Where it is").in("metres"),
        field<JobLight>("target", sampled<3>(point()), &JobLight::target,
                        "Spot and directional lights: shines from the position towards this point")
            .in("metres"),
    };
    for (auto& f : lightFields<JobLight>(
             [](JobLight & l) -> auto& { return l.light; }, true))
        fields.push_back(std::move(f));
    return mapping<JobLight>("light", "A light of the sequence's own.", std::move(fields), checkLight);
}

void checkLightNames(const std::vector<JobLight>& lights, const YamlNode& node) {
    for (std::size_t i = 0; i < lights.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (lights[i].name.value == lights[j].name.value)
                refuse(*node.items[i].find("name"), fmt::format("two lights are named \"{}\"", lights[i].name.value),
                       "the other one is at " + lights[j].name.place.text());
}

}  // namespace

Type<LightOpinion> lightOpinion() {
    return mapping<LightOpinion>("over light", "Changes to the light on a node; what is not named stays as it is.",
                                 lightFields<LightOpinion>(
                                     [](LightOpinion & l) -> auto& { return l; }, false));
}

Type<std::vector<JobLight>> extraLights() {
    return converted<std::vector<JobLight>>(listOf(extraLight(), "a list of lights"),
                                            [](std::vector<JobLight> made, const YamlNode& node) {
                                                checkLightNames(made, node);
                                                return made;
                                            });
}

}  // namespace umbrage
