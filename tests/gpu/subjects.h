// SPDX-License-Identifier: Apache-2.0
// Scenes for tests that need no right answer written down: random ones, and ours at a small size; how they are
// pictured, and how two pictures' masks compare.
#pragma once

#include <string>
#include <vector>

#include "judge/judge.h"
#include "judge/verify.h"
#include "oracle/formulas.h"
#include "techniques.h"

namespace umbrage::test {

using oracle::Corners;

/// By which means to picture.
struct How {
    Technique technique = {"compute", "z-pass"};
    bool halve = true, skipOutOfReach = true, skipOutOfView = true, endVolumes = true, shadows = true, counts = false;
};

/// Something to picture.
struct Subject {
    std::string name;
    Scene scene;
    std::vector<Index> animations;
    double timeSeconds = 0.0;
    PlacedCamera camera;
    int width = 0, height = 0;
    bool tied = false;       // coordinates are on a grid: depths tie, lights lie in planes
    std::uint64_t seed = 0;  // 0: one of ours

    FrameSettings settings(const How& how = {}) const;
    Moment moment() const { return evaluate(scene, animations, timeSeconds); }
};

/// A sequence of ours, half a second in.
Subject ours(const std::string& name, int width, int height);

/// With nothing missing from the depth buffer.
Subject solid(Subject subject);

/// Random scenes (more with UMBRAGE_RANDOM_SCENES=number, others with UMBRAGE_RANDOM_SEED=first) and two of ours.
const std::vector<Subject>& subjects();

FramePixels picture(const Subject& subject, const Moment& moment, const How& how = {});
inline FramePixels picture(const Subject& subject, const How& how = {}) {
    return picture(subject, subject.moment(), how);
}

/// Samples, summed over lights, that are dark for no other reason than a shadow.
std::size_t shadowed(const Subject& subject, const FramePixels& pixels);

/// Samples, summed over lights, whose masks differ. The lights may come in another order.
std::size_t maskDifferences(const FramePixels& a, const FramePixels& b);

/// Pictures by the default technique, and judges that.
/// @return hard errors of all lights
std::uint64_t hardErrors(const Subject& subject, const Moment& moment, FramePixels& pixels);

/// In the world: triangles of opaque meshes that do not deform.
std::vector<Corners> castersOf(const Subject& subject, const Moment& moment);

}  // namespace umbrage::test
