// SPDX-License-Identifier: Apache-2.0
// Which technique counts each light of a frame: the chosen one, or z-pass where that one is not exact and says so.
#pragma once

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "frame/frame.h"
#include "shadow/counts.h"
#include "shadow/masks.h"

namespace umbrage {

class LightCounts {
public:
    explicit LightCounts(const FrameSettings& settings);

    double ledge() const { return chosen_->ledge(); }
    bool byParts() const { return chosen_->byParts(); }
    bool byTiles() const { return chosen_->byTiles(); }

    /// Before the silhouettes of a frame are found.
    /// @param ids  of the frame's lights
    /// @throws Error(Input) where a light cannot be counted exactly and that is refused
    void begin(const CountFrame& frame, int number, std::vector<std::string> ids);

    /// Whether a caster must not be halved in this frame.
    bool countsWhole(std::uint32_t instance) const { return chosen_->countsWhole(instance); }

    /// Bits of a group's lights whose casters are counted from infinity, and of those whose counts have an eye
    /// constant.
    std::uint32_t fromInfinity(const LightGroup& group) const;
    std::uint32_t withEyeConstant(const LightGroup& group) const;

    /// Whether volumes of a light of the frame end behind all that it shines on.
    /// @param skips  where that is left to the skip (T2)
    bool endsVolumes(std::uint32_t light, bool skips) const {
        return of(light).endMetres() == 0.0 && (skips || of(light).endsVolumes()) && !byTiles();
    }

    /// Of a light of the group that was swept last.
    /// @throws Error(Input) as begin()
    std::vector<CountPlan> plan(const CountInput& input, Masks& masks, VolumeRenderer& volumes,
                                const Geometry& geometry);

    /// Why lights were not counted as chosen, each once; empties itself.
    std::vector<std::string> takeNotes() { return std::exchange(notes_, {}); }
    /// Of the frame's lights.
    std::size_t fellBackCount() const { return std::size_t(std::ranges::count(fellBack_, true)); }

private:
    const CountTechnique& of(std::uint32_t light) const { return fellBack_[light] ? *fallback_ : *chosen_; }
    template <class Holds>
    std::uint32_t bitsOf(const LightGroup& group, Holds holds) const;
    void notExact(std::uint32_t light, const std::string& why);

    std::string name_;
    WhenInexact whenInexact_;
    std::unique_ptr<CountTechnique> chosen_, fallback_ = makeCountTechnique("z-pass");
    std::set<std::string> said_;
    std::vector<std::string> notes_, ids_;
    std::vector<bool> fellBack_;  // per light of the frame
    int frame_ = 0;
};

}  // namespace umbrage
