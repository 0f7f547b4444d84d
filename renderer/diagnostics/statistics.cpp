// SPDX-License-Identifier: Apache-2.0
#include "diagnostics/statistics.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cassert>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "diagnostics/csv_field.h"

namespace umbrage {
namespace {

// Counts are whole numbers and should look like it.
nlohmann::ordered_json jsonNumber(double value) {
    constexpr double kExactIntegers = 9007199254740992.0;  // 2^53
    if (value == std::floor(value) && std::abs(value) <= kExactIntegers) return static_cast<std::int64_t>(value);
    return value;
}

}  // namespace

void Statistics::record(int frame, std::string_view light, Counter counter, double value) {
    assert(std::isfinite(value));
    values_[Key{frame, std::string(light), counter.index()}] = value;
}

std::string Statistics::csv() const {
    std::string text = "frame,light,counter,unit,value\n";
    for (const auto& [key, value] : values_) {
        const CounterInfo& counter = kCounters[key.counter];
        text += fmt::format("{},{},{},{},{}\n", key.frame, csvField(key.light), counter.name, counter.unit, value);
    }
    return text;
}

std::string Statistics::json(const StatisticsHeader& header) const {
    using Json = nlohmann::ordered_json;
    Json document = Json::object();
    for (const auto& [name, value] : header) document[name] = value;
    for (const CounterInfo& counter : kCounters) {
        document["counters"][std::string(counter.name)] = {{"unit", counter.unit}, {"doc", counter.doc}};
    }
    Json& frames = document["frames"] = Json::array();
    for (const auto& [key, value] : values_) {
        if (frames.empty() || frames.back()["frame"] != key.frame) {
            frames.push_back({{"frame", key.frame}, {"values", Json::object()}, {"lights", Json::object()}});
        }
        Json& frame = frames.back();
        Json& place = key.light.empty() ? frame["values"] : frame["lights"][key.light];
        place[std::string(kCounters[key.counter].name)] = jsonNumber(value);
    }
    // A light's name is whatever the scene says: bytes that are not UTF-8 become U+FFFD rather than an exception.
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

double peakHostMemoryMebibytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts in KiB
}

}  // namespace umbrage
