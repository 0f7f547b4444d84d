// SPDX-License-Identifier: Apache-2.0
// One way to make the pictures of one sequence, timed: the renderer by a technique, by
// shadow maps or without shadows, or the tracer.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bench/bench_scene.h"
#include "bench/shadow_map.h"
#include "diagnostics/counters.h"

namespace umbrage {

class Contender {
public:
    Contender(const BenchScene& scene, std::string name) : scene_(scene), name_(std::move(name)) {}
    virtual ~Contender() = default;

    /// All frames once.
    virtual void run(bool counted) = 0;

    const BenchScene& scene() const { return scene_; }
    const std::string& name() const { return name_; }
    /// Of all counted frames.
    const std::vector<double>& milliseconds() const { return milliseconds_; }
    /// Set-up and the first frame.
    double coldMilliseconds() const { return coldMilliseconds_; }
    /// Why something was not done as its name says, each once; empties itself.
    std::set<std::string> takeNotes() { return std::exchange(notes_, {}); }

    /// A frame with samples, for the judge; not timed.
    virtual FramePixels samples(int frame) = 0;
    /// That made the last samples; null: not a renderer.
    virtual const FrameRenderer* renderer() const { return nullptr; }

    // Medians; none where there is no such thing.
    virtual std::optional<double> pass(Counter) const { return std::nullopt; }  // milliseconds
    virtual std::optional<double> edges() const { return std::nullopt; }        // looked at in a frame
    virtual std::optional<double> buildMilliseconds() const { return std::nullopt; }
    virtual std::optional<double> refitMilliseconds() const { return std::nullopt; }

protected:
    const BenchScene& scene_;
    std::string name_;
    double coldMilliseconds_ = 0.0;
    std::vector<double> milliseconds_;
    std::set<std::string> notes_;
};

/// @param technique  null: without shadows
/// @param passes  also times passes, in frames of their own
std::unique_ptr<Contender> makeRenderer(const BenchScene& scene, const BenchTechnique* technique, bool passes,
                                        const gpu::Context& context);

/// The renderer with masks by shadow maps.
std::unique_ptr<Contender> makeShadowMapped(const BenchScene& scene, const ShadowMapSettings& settings,
                                            const gpu::Context& context);

/// The tracer without shadows and, after it, with each of the offsets (TracerSettings), or with its own where there are
/// none. They share what they trace.
std::vector<std::unique_ptr<Contender>> makeTracers(const BenchScene& scene, const std::vector<double>& offsets);

}  // namespace umbrage
