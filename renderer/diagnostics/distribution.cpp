// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/distribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace umbrage {
namespace {

constexpr int kUnitBins = 256, kBinsOfAnOctave = 128, kFirstOctave = 8;  // 256 = 2^8

std::size_t binOf(double value) {
    if (value < kUnitBins) return static_cast<std::size_t>(value);
    const int octave = std::ilogb(value);
    const double within = std::ldexp(value, -octave) - 1.0;  // [0, 1)
    return static_cast<std::size_t>(kUnitBins + (octave - kFirstOctave) * kBinsOfAnOctave) +
           static_cast<std::size_t>(within * kBinsOfAnOctave);
}

double startOf(std::size_t bin) {
    if (bin < kUnitBins) return static_cast<double>(bin);
    const std::size_t above = bin - kUnitBins;
    const double within = static_cast<double>(above % kBinsOfAnOctave) / kBinsOfAnOctave;
    return std::ldexp(1.0 + within, kFirstOctave + static_cast<int>(above / kBinsOfAnOctave));
}

}  // namespace

Distribution::Distribution(const std::vector<std::pair<double, std::uint64_t>>& histogram, double sum, double max)
    : sum_(sum), max_(max) {
    for (const auto& [start, pixels] : histogram) {
        const bool isStart = std::isfinite(start) && start >= 0.0 && startOf(binOf(start)) == start;
        if (!isStart) throw std::invalid_argument("no bin starts there");
        const std::size_t bin = binOf(start);
        if (bin < bins_.size()) throw std::invalid_argument("bins are not in ascending order");
        if (pixels == 0) throw std::invalid_argument("a bin is empty");
        bins_.resize(bin + 1);
        bins_[bin] = pixels;
        pixels_ += pixels;
    }
    const bool holdsMax =
        bins_.empty() ? max == 0.0 : max >= 0.0 && std::isfinite(max) && binOf(max) + 1 == bins_.size();
    if (!holdsMax) throw std::invalid_argument("the largest value is not in the last bin");
    constexpr double kRounding = 1.0 + 1e-9;  // of a sum of many
    if (!(sum >= 0.0 && sum <= max * static_cast<double>(pixels_) * kRounding)) {
        throw std::invalid_argument("the sum is not one of so many values");
    }
}

void Distribution::add(double value, std::uint64_t times) {
    assert(std::isfinite(value) && value >= 0.0);
    if (times == 0) return;
    const std::size_t bin = binOf(value);
    if (bin >= bins_.size()) bins_.resize(bin + 1);
    bins_[bin] += times;
    pixels_ += times;
    sum_ += value * static_cast<double>(times);
    max_ = std::max(max_, value);
}

void Distribution::add(const Distribution& other) {
    bins_.resize(std::max(bins_.size(), other.bins_.size()));
    for (std::size_t i = 0; i < other.bins_.size(); ++i) bins_[i] += other.bins_[i];
    pixels_ += other.pixels_;
    sum_ += other.sum_;
    max_ = std::max(max_, other.max_);
}

double Distribution::percentile(double percent) const {
    assert(percent > 0.0 && percent <= 100.0);
    const double wanted = percent * static_cast<double>(pixels_) / 100.0;  // exact where it is a whole number
    std::uint64_t below = 0;
    for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
        below += bins_[bin];
        if (static_cast<double>(below) >= wanted) return startOf(bin);
    }
    return 0.0;
}

std::vector<std::pair<double, std::uint64_t>> Distribution::histogram() const {
    std::vector<std::pair<double, std::uint64_t>> pairs;
    for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
        if (bins_[bin] > 0) pairs.emplace_back(startOf(bin), bins_[bin]);
    }
    return pairs;
}

}  // namespace umbrage
