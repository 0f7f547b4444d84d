// SPDX-License-Identifier: Apache-2.0
// How often which value occurs, in bins that are the same for every distribution, so that any two can be added.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace umbrage {

/// Of values from 0 up. Bins are 1 wide below 256; above there are 128 of them an octave, each at most 0.8 % wide. Sum
/// and maximum are kept beside them, so mean and maximum are exact.
class Distribution {
public:
    Distribution() = default;

    /// What histogram(), sum() and max() once said. @throws std::invalid_argument where they contradict each other
    Distribution(const std::vector<std::pair<double, std::uint64_t>>& histogram, double sum, double max);

    /// @param value  finite, not negative
    void add(double value, std::uint64_t times = 1);
    void add(const Distribution& other);

    std::uint64_t pixels() const { return pixels_; }
    double sum() const { return sum_; }
    double mean() const { return pixels_ ? sum_ / static_cast<double>(pixels_) : 0.0; }
    double max() const { return max_; }

    /// The smallest value with at least `percent` % of the pixels at or below it: the start of the bin it is in, which
    /// is the value itself for whole numbers below 256. 0 without pixels.
    /// @param percent  above 0, at most 100
    double percentile(double percent) const;

    /// (start of the bin, pixels), ascending, without empty bins.
    std::vector<std::pair<double, std::uint64_t>> histogram() const;

    bool operator==(const Distribution&) const = default;

private:
    std::vector<std::uint64_t> bins_;  // as many as needed; the last is not empty
    std::uint64_t pixels_ = 0;
    double sum_ = 0.0, max_ = 0.0;
};

}  // namespace umbrage
