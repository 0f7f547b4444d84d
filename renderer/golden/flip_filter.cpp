// SPDX-License-Identifier: Apache-2.0
#include "golden/flip_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace umbrage::flip {
namespace {

constexpr double kPi = std::numbers::pi;

/// A term of a contrast sensitivity: height and width b of the Gaussian in the frequency's domain, exp(-b f^2)
/// (table 1 of the paper; the second terms of the first two are 0).
struct Term {
    double height, width;
};
constexpr Term kAchromatic{1.0, 0.0047}, kRedGreen{1.0, 0.0053};
constexpr Term kBlueYellow[]{{34.1, 0.04}, {13.5, 0.025}};
constexpr double kWidest = 0.04;

constexpr double kFeatureWidthDegrees = 0.082;

/// All sensitivities have the radius of three standard deviations of the widest term.
int sensitivityRadius(double pixelsPerDegree) {
    return int(std::ceil(3.0 * std::sqrt(kWidest / (2.0 * kPi * kPi)) * pixelsPerDegree));
}

double featureDeviation(double pixelsPerDegree) {
    return 0.5 * kFeatureWidthDegrees * pixelsPerDegree;
}

int featureRadius(double pixelsPerDegree) {
    return int(std::ceil(3.0 * featureDeviation(pixelsPerDegree)));
}

/// In the image's domain the term is height * sqrt(pi / b) * exp(-pi^2 d^2 / b), d in degrees.
Sensitivity sensitivityOf(std::initializer_list<Term> terms, double pixelsPerDegree) {
    const int radius = sensitivityRadius(pixelsPerDegree);
    Sensitivity result;
    std::vector<double> weights;
    for (const Term& term : terms) {
        std::vector<double> values;
        for (int i = -radius; i <= radius; ++i) {
            const double degrees = i / pixelsPerDegree;
            values.push_back(std::exp(-kPi * kPi * degrees * degrees / term.width));
        }
        const double sum = std::accumulate(values.begin(), values.end(), 0.0);
        weights.push_back(term.height * std::sqrt(kPi / term.width) * sum * sum);
        // Neighbours that float's sum could not tell from none are left out: the narrow ones' radius is far too large.
        while (values.size() > 1 && values.front() < 1e-9 * sum) values.erase(values.begin()), values.pop_back();
        Kernel& kernel = result.gaussians.emplace_back();
        for (const double value : values) kernel.push_back(float(value / sum));
    }
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (const double weight : weights) result.weights.push_back(float(weight / total));
    return result;
}

/// Positive weights are made to add up to 1, negative ones to -1.
Kernel balanced(const std::vector<double>& values) {
    double positive = 0.0, negative = 0.0;
    for (const double value : values) (value > 0.0 ? positive : negative) += std::abs(value);
    Kernel kernel;
    for (const double value : values) kernel.push_back(float(value / (value > 0.0 ? positive : negative)));
    return kernel;
}

void addScaled(float* sum, const float* values, float weight, int count) {
    for (int i = 0; i < count; ++i) sum[i] += weight * values[i];
}

}  // namespace

Plane alongRows(const Plane& plane, const Kernel& kernel) {
    const int radius = int(kernel.size() / 2), width = plane.width;
    Plane result{width, plane.height, std::vector<float>(plane.values.size())};
    std::vector<float> row(std::size_t(width) + 2 * radius);
    for (int y = 0; y < plane.height; ++y) {
        const float* values = &plane.values[std::size_t(y) * width];
        std::fill_n(row.begin(), radius, values[0]);
        std::copy_n(values, width, row.begin() + radius);
        std::fill_n(row.end() - radius, radius, values[width - 1]);
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            addScaled(&result.values[std::size_t(y) * width], &row[k], kernel[k], width);
        }
    }
    return result;
}

Plane alongColumns(const Plane& plane, const Kernel& kernel) {
    const int radius = int(kernel.size() / 2), width = plane.width;
    Plane result{width, plane.height, std::vector<float>(plane.values.size())};
    for (int y = 0; y < plane.height; ++y) {
        for (int k = -radius; k <= radius; ++k) {
            const int from = std::clamp(y + k, 0, plane.height - 1);
            addScaled(&result.values[std::size_t(y) * width], &plane.values[std::size_t(from) * width],
                      kernel[k + radius], width);
        }
    }
    return result;
}

Plane Sensitivity::applied(const Plane& plane) const {
    Plane sum{plane.width, plane.height, std::vector<float>(plane.values.size())};
    for (std::size_t i = 0; i < gaussians.size(); ++i) {
        const Plane filtered = alongColumns(alongRows(plane, gaussians[i]), gaussians[i]);
        addScaled(sum.values.data(), filtered.values.data(), weights[i], int(sum.values.size()));
    }
    return sum;
}

Sensitivities::Sensitivities(double pixelsPerDegree)
    : achromatic(sensitivityOf({kAchromatic}, pixelsPerDegree)),
      redGreen(sensitivityOf({kRedGreen}, pixelsPerDegree)),
      blueYellow(sensitivityOf({kBlueYellow[0], kBlueYellow[1]}, pixelsPerDegree)) {}

FeatureKernels::FeatureKernels(double pixelsPerDegree) {
    const double deviation = featureDeviation(pixelsPerDegree), variance = deviation * deviation;
    const int radius = featureRadius(pixelsPerDegree);
    std::vector<double> values, firsts, seconds;
    for (int i = -radius; i <= radius; ++i) {
        values.push_back(std::exp(-i * i / (2.0 * variance)));
        firsts.push_back(-i * values.back());
        seconds.push_back((i * i / variance - 1.0) * values.back());
    }
    gaussian = balanced(values);
    first = balanced(firsts);
    second = balanced(seconds);
}

int reach(double pixelsPerDegree) {
    return std::max(sensitivityRadius(pixelsPerDegree), featureRadius(pixelsPerDegree));
}

}  // namespace umbrage::flip
