// SPDX-License-Identifier: Apache-2.0
// The registry of counters: what a frame reports about itself. A new counter is one line here; CSV, JSON and whoever
// documents them read this table.
#pragma once

#include <array>
#include <string_view>

#include "diagnostics/table_row.h"

namespace umbrage {

/// How values of several frames become the sequence's, and where a light or caster has parts, theirs the whole's. Mean:
/// the ratio of two combined counters where the table names them; otherwise frames are averaged, and a whole has no
/// value from its parts.
enum class Combine { Sum, Largest, Mean };

struct CounterInfo {
    std::string_view name, unit, doc;
    Combine combine = Combine::Sum;
    std::string_view numerator{}, denominator{};  // counters, of a Mean that is their ratio
};

// clang-format off
inline constexpr std::array kCounters{
    // scene
    CounterInfo{"scene.fragments", "count", "fragments of opaque surfaces, whatever is in front of them"},
    CounterInfo{"scene.shaded", "count", "fragments of opaque surfaces that passed the depth test when they were drawn"},
    CounterInfo{"scene.covered", "pixels", "pixels with at least one of them"},
    CounterInfo{"scene.depthComplexity", "fragments/pixel", "scene.fragments / scene.covered", Combine::Mean, "scene.fragments", "scene.covered"},
    CounterInfo{"scene.overdraw", "fragments/pixel", "scene.shaded / scene.covered", Combine::Mean, "scene.shaded", "scene.covered"},
    // casters
    CounterInfo{"triangles", "count", "triangles of the shadow casters", Combine::Largest},
    CounterInfo{"triangles.facing", "count", "triangles whose front the light sees"},
    CounterInfo{"edges", "count", "welded edges of the shadow casters", Combine::Largest},
    CounterInfo{"edges.silhouette", "count", "edges that become sides of a shadow volume"},
    CounterInfo{"edges.silhouette.once", "count", "of them, those that count one"},
    CounterInfo{"edges.silhouette.twice", "count", "of them, those that count two or more"},
    CounterInfo{"quads", "count", "sides of shadow volumes that are drawn, multiplicities included"},
    CounterInfo{"quads.halved", "count", "of them, those that stand for two"},
    CounterInfo{"caps.light", "count", "triangles drawn as light caps"},
    CounterInfo{"caps.dark", "count", "triangles drawn as dark caps"},
    CounterInfo{"caps.near.trivial", "count", "triangles of casters with near caps, none of whose rays from the light meets the plane of caps"},
    CounterInfo{"caps.near.easy", "count", "of the same casters, triangles all of whose rays do"},
    CounterInfo{"caps.near.hard", "count", "of the same casters, the others"},
    // fill
    CounterInfo{"overdraw.fragments", "count", "fragments of shadow volumes"},
    CounterInfo{"overdraw.sides", "count", "of them, those of sides"},
    CounterInfo{"overdraw.lightCaps", "count", "of them, those of light caps"},
    CounterInfo{"overdraw.darkCaps", "count", "of them, those of dark caps"},
    CounterInfo{"overdraw.passed", "count", "of them, those that passed the depth test; by split-plane, those that change a count"},
    CounterInfo{"overdraw.failed", "count", "of them, the others"},
    CounterInfo{"overdraw.queried", "count", "all of them by the device's own query: the same number"},
    CounterInfo{"overdraw.updates", "count", "stencil updates: fragments of shadow volumes that count"},
    CounterInfo{"overdraw.entered", "count", "of them, those that enter a volume"},
    CounterInfo{"overdraw.left", "count", "of them, those that leave one"},
    CounterInfo{"count.net", "count", "counts of all samples added up: overdraw.entered - overdraw.left + eye.constant for each sample"},
    CounterInfo{"overdraw.depthComplexity", "fragments/pixel", "overdraw.fragments / pixels of the picture and samples of each", Combine::Mean},
    CounterInfo{"tiles", "count", "tiles of 8 x 8 pixels of the picture", Combine::Largest},
    CounterInfo{"tiles.touched", "count", "tiles with a fragment of the light's volumes"},
    CounterInfo{"tiles.processed", "count", "of them, those in which one changed a count"},
    CounterInfo{"tiles.culled", "count", "of them, the others"},
    CounterInfo{"eye.constant", "count", "shadow volumes that hold the eye"},
    CounterInfo{"casters", "count", "placed meshes", Combine::Largest},
    CounterInfo{"casters.zfail", "count", "casters counted by z-fail because the eye is near their volumes"},
    CounterInfo{"casters.outOfReach", "count", "casters skipped because they are out of the light's range or cone"},
    CounterInfo{"casters.outOfView", "count", "casters skipped because no view ray meets them or their volumes"},
    CounterInfo{"casters.ended", "count", "casters whose volumes end behind all that the light can shine on"},
    CounterInfo{"lights.fellBack", "count", "lights counted by z-pass where the chosen technique is not exact"},
    CounterInfo{"lights.skipped", "count", "lights that provably change no pixel of the frame"},
    // reuse
    CounterInfo{"frames.reused", "count", "frames that are an earlier one of the run, which was not rendered again"},
    CounterInfo{"channels.idle", "count", "animation channels that play and are left out, for they move nothing", Combine::Largest},
    // device
    CounterInfo{"device.draws", "count", "draw calls"},
    CounterInfo{"device.dispatches", "count", "compute dispatches"},
    CounterInfo{"device.stateChanges", "count", "changes of raster state, program or framebuffer"},
    CounterInfo{"device.uploaded", "bytes", "written to buffers"},
    CounterInfo{"device.readBack", "bytes", "read from buffers and pictures"},
    CounterInfo{"memory.device", "bytes", "buffers and textures allocated at the end of the frame", Combine::Largest},
    CounterInfo{"memory.peak", "MiB", "largest resident memory of the process so far", Combine::Largest},
    // time
    CounterInfo{"time.position", "ms", "skinning, morphing and displacement of positions"},
    CounterInfo{"time.gbuffer", "ms", "depth and surface attributes"},
    CounterInfo{"time.silhouettes", "ms", "facing and edge lists"},
    CounterInfo{"time.counts", "ms", "shadow volumes into counts, counts into the lights' mask bits"},
    CounterInfo{"time.resolve", "ms", "lighting of all lights"},
    CounterInfo{"time.blended", "ms", "blended surfaces"},
    CounterInfo{"time.readback", "ms", "pixels from the device to the host"},
    CounterInfo{"time.encode", "ms", "display colour, encoding and writing of files"},
    CounterInfo{"time.frame", "ms", "the whole frame"},
    // ratio
    CounterInfo{"time.picture", "ms", "the frame's picture alone, again, its passes not waited for"},
    CounterInfo{"time.unshadowed", "ms", "the same without shadows"},
    CounterInfo{"time.frame.ratio", "ratio", "time.picture / time.unshadowed", Combine::Mean, "time.picture", "time.unshadowed"},
};
// clang-format on

/// Neighbours in kCounters that are shown together.
struct CounterGroup {
    std::string_view name, first, doc;
};

// clang-format off
inline constexpr std::array kCounterGroups{
    CounterGroup{"scene", "scene.fragments", "What is drawn of the scene. Counted a sample at a time; with several samples a pixel divided by their number."},
    CounterGroup{"casters", "triangles", "The geometry that casts shadows, and what becomes of it for a light."},
    CounterGroup{"fill", "overdraw.fragments", "What rasterising the shadow volumes costs. Fragments are counted before the depth test, one for each sample."},
    CounterGroup{"reuse", "frames.reused", "What did not need to be made again."},
    CounterGroup{"device", "device.draws", "What the device was asked to do, and the memory it took."},
    CounterGroup{"time", "time.position", "Only with diagnostics.profile. The clock is named at the head of the file."},
    CounterGroup{"ratio", "time.picture", "What shadows cost. Only with diagnostics.profile and a budget on one of these, for each frame is rendered twice more, in turn."},
};
// clang-format on

/// @param index  of kCounters
constexpr const CounterGroup& groupOf(std::size_t index) {
    std::size_t group = 0, begun = 0;
    for (std::size_t i = 0; i <= index; ++i) {
        if (begun < kCounterGroups.size() && kCounters[i].name == kCounterGroups[begun].first) group = begun++;
    }
    return kCounterGroups[group];
}

/// A counter by its name: record(frame, place, "quads", 4).
class Counter : public TableRow<kCounters, Counter> {
public:
    using TableRow::TableRow;
    template <std::size_t N>
    consteval Counter(const char (&name)[N]) : TableRow(find({name, N - 1})) {}
};

}  // namespace umbrage
