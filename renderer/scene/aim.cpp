// SPDX-License-Identifier: Apache-2.0
#include "scene/aim.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "error.h"

namespace umbrage {
namespace {

glm::dvec3 vectorOf(const std::array<double, 3>& value) {
    return {value[0], value[1], value[2]};
}

// In double, unlike sample() of tracks: the rotation should not carry the rounding of both ends.
glm::dvec3 valueAt(const Sampled<3>& sampled, double timeSeconds, KeyInterpolation interpolation) {
    const auto& times = sampled.timesSeconds;
    const auto next = std::upper_bound(times.begin(), times.end(), timeSeconds);
    if (next == times.begin()) return vectorOf(sampled.values.front());
    if (next == times.end()) return vectorOf(sampled.values.back());
    const auto after = static_cast<std::size_t>(next - times.begin());
    const glm::dvec3 left = vectorOf(sampled.values[after - 1]), right = vectorOf(sampled.values[after]);
    if (interpolation == KeyInterpolation::Step) return left;
    return glm::mix(left, right, (timeSeconds - times[after - 1]) / (times[after] - times[after - 1]));
}

glm::dquat rotationAt(const Sampled<3>& position, const Sampled<3>& target, double timeSeconds,
                      KeyInterpolation interpolation) {
    const glm::dvec3 direction =
        valueAt(target, timeSeconds, interpolation) - valueAt(position, timeSeconds, interpolation);
    if (glm::length(direction) == 0.0)
        throw Error(ErrorKind::Input, target.place.file.empty() ? position.place.text() : target.place.text(),
                    position.animated() || target.animated()
                        ? fmt::format("at {} seconds position and target are the same point", timeSeconds)
                        : std::string("position and target are the same point"),
                    "it looks from the one towards the other");
    return lookRotation(direction);
}

void addChannel(Animation& driver, Index node, Target target, Track track) {
    driver.channels.push_back({node, target, static_cast<Index>(driver.tracks.size())});
    driver.tracks.push_back(std::move(track));
}

}  // namespace

glm::dquat lookRotation(const glm::dvec3& direction) {
    const glm::dvec3 forward = glm::normalize(direction);
    constexpr double kVertical = 1.0 - 1e-9;
    const bool vertical = std::abs(forward.y) > kVertical;
    return glm::quatLookAt(forward,
                           vertical ? glm::dvec3(0.0, 0.0, forward.y > 0.0 ? 1.0 : -1.0) : glm::dvec3(0.0, 1.0, 0.0));
}

void aim(Scene& scene, Index node, const Sampled<3>& position, const Sampled<3>* target,
         KeyInterpolation interpolation) {
    Node& placed = scene.nodes[static_cast<std::size_t>(node)];
    Animation driver{.name = placed.path, .tracks = {}, .channels = {}};
    placed.translation = vectorOf(position.values.front());
    if (position.animated()) addChannel(driver, node, Target::Translation, trackOf(position, interpolation));

    if (target) {
        std::set<double> times(position.timesSeconds.begin(), position.timesSeconds.end());
        times.insert(target->timesSeconds.begin(), target->timesSeconds.end());
        placed.rotation = rotationAt(position, *target, times.empty() ? 0.0 : *times.begin(), interpolation);
        Track track;
        track.width = 4;
        track.interpolation = interpolation == KeyInterpolation::Step ? Interpolation::Step : Interpolation::Linear;
        for (const double time : times) {
            const auto time32 = static_cast<float>(time);
            // Samples of position and target less than a float apart are one key.
            if (!track.timesSeconds.empty() && track.timesSeconds.back() == time32) continue;
            const glm::dquat rotation = rotationAt(position, *target, time, interpolation);
            track.timesSeconds.push_back(time32);
            for (const double component : {rotation.x, rotation.y, rotation.z, rotation.w})
                track.values.push_back(static_cast<float>(component));
        }
        if (!times.empty()) addChannel(driver, node, Target::Rotation, std::move(track));
    }
    if (!driver.channels.empty()) scene.drivers.push_back(std::move(driver));
}

}  // namespace umbrage
