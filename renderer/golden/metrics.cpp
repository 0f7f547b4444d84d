// SPDX-License-Identifier: Apache-2.0
#include "golden/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <type_traits>

#include "error.h"
#include "golden/perception.h"

namespace umbrage {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool isInteger(const StoredChannel& channel) {
    return std::holds_alternative<std::vector<std::uint32_t>>(channel.values);
}

/// @param steps  the values are whole numbers of 1 / steps, rounded to float; 0: they are not
double differenceOf(double golden, double output, double steps) {
    if (golden == output || (std::isnan(golden) && std::isnan(output))) return 0.0;
    if (!std::isfinite(golden) || !std::isfinite(output)) return kInfinity;
    const double difference = std::abs(output - golden);
    return steps > 0.0 ? std::round(difference * steps) / steps : difference;
}

/// What a byte or two can hold besides 0, so that a difference of one of them is 1/255 or 1/65535 wherever it lies.
double stepsOf(PixelType type) {
    return type == PixelType::UInt8 ? 255.0 : type == PixelType::UInt16 ? 65535.0 : 0.0;
}

/// What one pass over all samples finds.
struct Sums {
    double largest = 0.0, sum = 0.0, squares = 0.0;            // of all channels
    double floatSquares = 0.0, peak = 1.0;                     // of float channels
    double largestRelative = 0.0, sumRelative = 0.0;           // the same
    std::size_t samples = 0, floatSamples = 0, different = 0;  // different: integer ones
    std::size_t worst = 0;
    std::vector<std::uint8_t> over;  // pixels beyond the tolerance
};

template <class Value>
void addChannel(Sums& sums, const std::vector<Value>& golden, const std::vector<Value>& output, double steps,
                const MeasureSettings& settings) {
    constexpr bool kFloat = std::is_same_v<Value, float>;
    double sum = 0.0, squares = 0.0, sumRelative = 0.0;
    for (std::size_t i = 0; i < golden.size(); ++i) {
        if constexpr (kFloat) {
            if (std::isfinite(golden[i])) sums.peak = std::max(sums.peak, std::abs(double(golden[i])));
        }
        if (golden[i] == output[i]) continue;
        const double difference = differenceOf(golden[i], output[i], steps);
        if (difference == 0.0) continue;
        sum += difference;
        squares += difference * difference;
        if (difference > sums.largest) sums.largest = difference, sums.worst = i;
        if constexpr (kFloat) {
            const double scale = std::max(std::abs(double(golden[i])), settings.relativeFloor);
            const double relative = std::isfinite(difference) ? difference / scale : kInfinity;
            sumRelative += relative;
            sums.largestRelative = std::max(sums.largestRelative, relative);
        } else {
            ++sums.different;
        }
        if (!kFloat || difference > settings.tolerance) sums.over[i] = 1;
    }
    sums.sum += sum;
    sums.squares += squares;
    sums.samples += golden.size();
    if constexpr (kFloat) {
        sums.floatSquares += squares;
        sums.sumRelative += sumRelative;
        sums.floatSamples += golden.size();
    }
}

Sums sumsOf(const StoredImage& golden, const StoredImage& output, const MeasureSettings& settings) {
    Sums sums;
    sums.over.resize(golden.pixelCount());
    for (const StoredChannel& channel : golden.channels) {
        const StoredChannel& other = *output.channel(channel.name);
        std::visit(
            [&](const auto& values) {
                using Values = std::decay_t<decltype(values)>;
                addChannel(sums, values, std::get<Values>(other.values), stepsOf(channel.type), settings);
            },
            channel.values);
    }
    if (golden.displayEncoded) sums.peak = 1.0;
    return sums;
}

/// Share of marked pixels in the window that holds most of them, by a table of sums over all that lies above and left.
double densestShare(const std::vector<std::uint8_t>& marked, int width, int height, int window) {
    const int across = std::min(window, width), down = std::min(window, height);
    const std::size_t pitch = std::size_t(width) + 1;
    std::vector<std::uint32_t> table(pitch * (height + 1));
    std::uint32_t most = 0;
    for (int y = 0; y < height; ++y) {
        std::uint32_t row = 0;
        for (int x = 0; x < width; ++x) {
            row += marked[std::size_t(y) * width + x];
            const std::size_t at = (y + 1) * pitch + x + 1;
            table[at] = table[at - pitch] + row;
            if (x + 1 < across || y + 1 < down) continue;
            const std::size_t above = at - down * pitch;
            most = std::max(most, table[at] - table[at - across] - table[above] + table[above - across]);
        }
    }
    return double(most) / (double(across) * down);
}

void checkComparable(const StoredImage& golden, const StoredImage& output) {
    const auto refused = [](const std::string& why) {
        return Error(ErrorKind::Input, "", "the pictures cannot be compared: " + why);
    };
    if (golden.data.width != output.data.width || golden.data.height != output.data.height) {
        throw refused(fmt::format("{}x{} against {}x{} pixels", golden.data.width, golden.data.height,
                                  output.data.width, output.data.height));
    }
    if (golden.channels.size() != output.channels.size()) throw refused("they have other channels");
    for (const StoredChannel& channel : golden.channels) {
        const StoredChannel* other = output.channel(channel.name);
        if (!other || other->values.index() != channel.values.index()) {
            throw refused(fmt::format("channel {} is missing or of another kind", channel.name));
        }
    }
}

double psnrOf(const Sums& sums) {
    const double rms = std::sqrt(sums.floatSquares / double(sums.floatSamples));
    return rms > 0.0 ? 20.0 * std::log10(sums.peak / rms) : kInfinity;
}

}  // namespace

const MetricInfo* findMetric(std::string_view name) {
    const auto found = std::find_if(kMetrics.begin(), kMetrics.end(), [&](const auto& m) { return m.name == name; });
    return found == kMetrics.end() ? nullptr : &*found;
}

bool applies(std::string_view metric, const StoredImage& image) {
    const bool integers = std::any_of(image.channels.begin(), image.channels.end(), isInteger);
    const bool floats = !std::all_of(image.channels.begin(), image.channels.end(), isInteger);
    if (metric == "uint-different") return integers;
    if (metric == "psnr" || metric.ends_with("-relative")) return floats;
    if (metric.starts_with("hdr-flip")) return !image.displayEncoded && hasColours(image);
    if (metric.starts_with("flip") || metric == "yee") return hasColours(image);
    return findMetric(metric) != nullptr;
}

Measured measure(const StoredImage& golden, const StoredImage& output, const MeasureSettings& settings,
                 std::span<const std::string> wanted) {
    checkComparable(golden, output);
    const Sums sums = sumsOf(golden, output, settings);
    const int width = golden.data.width, height = golden.data.height;
    Perception perception(golden, output, settings.pixelsPerDegree);

    Measured measured;
    if (sums.largest > 0.0) measured.worst = {int(sums.worst % width), int(sums.worst / width)};
    const std::map<std::string_view, std::function<double()>> figures{
        {"max-abs", [&] { return sums.largest; }},
        {"mean-abs", [&] { return sums.sum / double(sums.samples); }},
        {"rmse", [&] { return std::sqrt(sums.squares / double(sums.samples)); }},
        {"psnr", [&] { return psnrOf(sums); }},
        {"max-relative", [&] { return sums.largestRelative; }},
        {"mean-relative", [&] { return sums.sumRelative / double(sums.floatSamples); }},
        {"fraction",
         [&] { return double(std::count(sums.over.begin(), sums.over.end(), 1)) / double(sums.over.size()); }},
        {"densest", [&] { return densestShare(sums.over, width, height, settings.window); }},
        {"uint-different", [&] { return double(sums.different); }},
        {"flip", [&] { return meanError(perception.flip()); }},
        {"flip-median", [&] { return weightedPercentile(perception.flip(), 0.5); }},
        {"flip-max", [&] { return largestError(perception.flip()); }},
        {"hdr-flip", [&] { return meanError(perception.hdrFlip()); }},
        {"hdr-flip-max", [&] { return largestError(perception.hdrFlip()); }},
        {"yee", [&] { return perception.yeeShare(); }},
    };
    for (const std::string& name : wanted) {
        const auto figure = figures.find(name);
        if (figure == figures.end()) throw Error(ErrorKind::Input, name, "there is no metric of this name");
        if (applies(name, golden)) measured.figures.push_back({name, figure->second()});
    }
    return measured;
}

}  // namespace umbrage
