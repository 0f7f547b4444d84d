// SPDX-License-Identifier: Apache-2.0
// Renders a sequence by several techniques and judges every frame and light against the oracle.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "frame/settings.h"
#include "gpu/context.h"
#include "image/image.h"
#include "job/job.h"
#include "judge/verdict.h"

namespace umbrage {

/// "compute:z-pass,cpu:z-fail" or "all". @throws Error(Usage) that lists the names
std::vector<Technique> parseTechniques(const std::string& text);

struct VerifyOptions {
    std::vector<Technique> techniques;
    int othersEvery = 1;  // techniques after the first judge only every n-th of the frames, from the first on
    bool counts = false;  // judge integer counts too: a second picture, without the skips that change counts
    bool allowExternalFiles = false;
    int threads = 0;  // of the oracle; 0: as many as processors
    Fault fault = Fault::None;
};

class VerifyObserver {
public:
    virtual ~VerifyObserver() = default;
    virtual void note(const std::string& text) = 0;
    virtual void started(std::size_t verdictCount) = 0;
    /// @param radiance  the picture judged, RGBA linear
    virtual void judged(const FrameVerdict& verdict, const VerdictPlanes& planes,
                        const std::vector<float>& radiance) = 0;
};

/// Random scenes (random_scene.h) instead of a sequence: verdicts of seeds `seed` to `seed + count - 1`, one frame
/// each, with the seed's place as its frame number, from 1.
void verifyRandom(std::uint64_t seed, int count, const gpu::Context& context, const DisplayTransform& display,
                  const VerifyOptions& options, VerifyObserver& observer, const std::atomic<bool>& interrupted);

/// @param display  for errors in display codes
/// @throws Error
void verify(const Job& job, const gpu::Context& context, const DisplayTransform& display, const VerifyOptions& options,
            VerifyObserver& observer, const std::atomic<bool>& interrupted);

}  // namespace umbrage
