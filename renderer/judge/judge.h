// SPDX-License-Identifier: Apache-2.0
// Judges masks of one frame sample by sample: right, explained by what the rasteriser may round, or hard.
//
// In two stages: all samples are compared with the oracle's answer at the exact place; only what differs is looked at
// again (explain.h). The oracle's answers are found once a frame and serve all techniques.
#pragma once

#include <memory>
#include <vector>

#include "frame/frame.h"
#include "image/image.h"
#include "judge/tolerance.h"
#include "judge/verdict.h"

namespace umbrage {

class Judge {
public:
    /// @param threads  0: as many as processors
    Judge(const Scene& scene, int width, int height, const Tolerance& tolerance, int threads);
    ~Judge();

    /// Goes to a frame, as rendered by `renderer` right before. Later calls of judge() are about it.
    /// @param pixels  with samples asked for: what it claims is seen decides where alpha textures have holes
    void setFrame(const Moment& moment, const PlacedCamera& camera, const FrameRenderer& renderer,
                  const FramePixels& pixels);

    /// Per light of the moment and sample: 1 where the light reaches the surface.
    const std::vector<std::vector<std::uint8_t>>& exact() const;

    /// Fills all of the verdict but its frame, technique and radiance. Toggles are counted against the frame judged
    /// before by the same technique.
    FrameVerdict judge(const FramePixels& pixels, const std::string& technique, VerdictPlanes& planes);

    double oracleMilliseconds() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// @param display  8-bit codes are those it shows
RadianceError compareRadiance(const std::vector<float>& radiance, const std::vector<float>& exact,
                              const DisplayTransform& display);

}  // namespace umbrage
