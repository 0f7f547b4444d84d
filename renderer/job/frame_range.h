// SPDX-License-Identifier: Apache-2.0
// Frame ranges: "1-48", "1-100x2", "-5-5", "1-10,20,30-40". Negative frames are allowed; overlaps are errors that name
// both terms; ':' is refused because tools disagree about it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbrage {

class FrameRange {
public:
    static FrameRange single(int frame);

    /// @param where  prefix for the error, e.g. "seq.yaml:4:10" or "--frames"
    /// @throws Error(Input)
    static FrameRange parse(std::string_view text, const std::string& where);

    /// Ascending, without duplicates, never empty; at most a million.
    const std::vector<int>& frames() const { return frames_; }

    /// The shortest list of terms, none begun before the one in front has ended, that parse() reads back as the same
    /// frames; paste it into --frames.
    std::string text() const;
    /// @param frames  ascending, without duplicates; none gives ""
    static std::string textOf(const std::vector<int>& frames);

private:
    std::vector<int> frames_;
};

}  // namespace umbrage
