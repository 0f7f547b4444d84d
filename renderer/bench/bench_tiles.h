// SPDX-License-Identifier: Apache-2.0
// Laine's experiment on a sequence: what a rasteriser that culls tiles processes, frame by frame.
#pragma once

#include "bench/bench_run.h"
#include "bench/bench_scene.h"
#include "bench/tile_casters.h"
#include "bench/tile_counter.h"
#include "judge/truth.h"

namespace umbrage {

/// A frame whose volumes can be counted.
struct TileFrame {
    PlacedMoment placed;
    Eye eye;
    TileView view;
    FramePixels pixels;
    std::vector<double> inverseDepths;
    std::vector<TileCaster> casters;
    std::vector<glm::dvec4> lights;  // that are on
};

class TileBench {
public:
    /// Scene and context must outlive it.
    TileBench(const BenchScene& scene, const gpu::Context& context, int threads);

    /// @param radiance  with the picture
    TileFrame frame(int frame, bool radiance = false);
    /// All lights' counts added up. @param planes  with how often each pixel is processed
    TileCounts count(const TileFrame& frame, bool planes = false) const;
    const BenchScene& scene() const { return scene_; }

private:
    const BenchScene& scene_;
    int threads_;
    std::unique_ptr<FrameRenderer> renderer_;
    Truth truth_;
};

/// Laine's Table 1, and a plot like his Figure 6 for each sequence.
void measureTiles(const BenchScenes& scenes, const gpu::Context& context, int threads, BenchObserver& observer,
                  const std::atomic<bool>& interrupted, BenchResult& result);

}  // namespace umbrage
