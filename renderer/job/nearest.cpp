// SPDX-License-Identifier: Apache-2.0
#include "job/nearest.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace umbrage {
namespace {

// A slip or two in a short name, one letter in three of a long one; more than that is another word.
std::size_t farthestSlip(std::size_t length) {
    return std::max<std::size_t>(2, length / 3);
}

constexpr std::size_t kMostListed = 12;
constexpr std::size_t kLongestCompared = 256;  // the cost is quadratic, and names from files can be anything

}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

std::string hintForName(std::string_view name, std::span<const std::string> known) {
    if (known.empty()) return {};
    std::vector<std::pair<std::size_t, std::string>> byDistance;
    for (const std::string& candidate : known)
        byDistance.emplace_back(
            editDistance(name.substr(0, kLongestCompared), std::string_view(candidate).substr(0, kLongestCompared)),
            candidate);
    const auto nearest = std::min_element(byDistance.begin(), byDistance.end(),
                                          [](const auto& a, const auto& b) { return a.first < b.first; });
    if (nearest->first <= farthestSlip(name.size()) && nearest->first < nearest->second.size())
        return fmt::format("did you mean \"{}\"?", nearest->second);

    const bool all = byDistance.size() <= kMostListed;
    if (!all) std::stable_sort(byDistance.begin(), byDistance.end());
    std::vector<std::string> listed;
    for (const auto& [distance, candidate] : byDistance)
        if (listed.size() < kMostListed) listed.push_back(candidate);
    return fmt::format("known: {}{}", fmt::join(listed, ", "), all ? "" : ", ...");
}

}  // namespace umbrage
