// SPDX-License-Identifier: Apache-2.0
// FLIP as the papers define it, in double and with whole two-dimensional filters: slow, straight, and nothing of it
// shared with what it tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "golden/flip.h"

namespace umbrage::test {

using Triple = std::array<double, 3>;
using Triples = std::vector<Triple>;

constexpr double kReferencePi = 3.14159265358979323846;

// The matrix of IEC 61966-2-1, as printed there to four digits, and D65's white as the sum of its rows: an error of
// 1e-4 in its entries is the price of independence from how the tested code makes its own.
inline Triple referenceXyz(const Triple& c) {
    return {0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2], 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2],
            0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]};
}

inline Triple relativeXyz(const Triple& c) {
    const Triple xyz = referenceXyz(c), white = referenceXyz({1, 1, 1});
    return {xyz[0] / white[0], xyz[1] / white[1], xyz[2] / white[2]};
}

/// Solves relativeXyz(c) = xyz by Cramer's rule.
inline Triple linearFromRelativeXyz(const Triple& xyz) {
    const Triple r = relativeXyz({1, 0, 0}), g = relativeXyz({0, 1, 0}), b = relativeXyz({0, 0, 1});
    const auto determinant = [](const Triple& p, const Triple& q, const Triple& s) {
        return p[0] * (q[1] * s[2] - q[2] * s[1]) - q[0] * (p[1] * s[2] - p[2] * s[1]) +
               s[0] * (p[1] * q[2] - p[2] * q[1]);
    };
    const double whole = determinant(r, g, b);
    return {determinant(xyz, g, b) / whole, determinant(r, xyz, b) / whole, determinant(r, g, xyz) / whole};
}

inline Triple referenceHuntLab(const Triple& linear) {
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const Triple xyz = relativeXyz(linear);
    const double lightness = 116.0 * f(xyz[1]) - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (f(xyz[0]) - f(xyz[1])),
            0.01 * lightness * 200.0 * (f(xyz[1]) - f(xyz[2]))};
}

inline double referenceHyab(const Triple& a, const Triple& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

inline double referenceColorError(double hyab) {
    const double most = std::pow(referenceHyab(referenceHuntLab({0, 1, 0}), referenceHuntLab({0, 0, 1})), 0.7);
    const double power = std::pow(hyab, 0.7);
    return power < 0.4 * most ? power * 0.95 / (0.4 * most) : 0.95 + 0.05 * (power - 0.4 * most) / (most - 0.4 * most);
}

/// Sum over a square of neighbours; outside lies what lies at the edge.
template <class Weight>
double filtered(const std::vector<double>& plane, int width, int height, int x, int y, int radius, Weight weight) {
    double sum = 0.0;
    for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) {
            const int px = std::clamp(x + i, 0, width - 1), py = std::clamp(y + j, 0, height - 1);
            sum += weight(i, j) * plane[std::size_t(py) * width + px];
        }
    }
    return sum;
}

/// The whole square of weights, so that it can be made to add up: all of it to 1, or each sign by itself.
class Square {
public:
    template <class Function>
    Square(int radius, Function function, bool eachSign) : radius_(radius) {
        double positive = 0.0, negative = 0.0;
        for (int j = -radius; j <= radius; ++j) {
            for (int i = -radius; i <= radius; ++i) {
                values_.push_back(function(i, j));
                (values_.back() > 0.0 ? positive : negative) += values_.back();
            }
        }
        for (double& value : values_) {
            value /= eachSign ? (value > 0.0 ? positive : -negative) : positive + negative;
        }
    }
    std::vector<double> of(const std::vector<double>& plane, int width, int height) const {
        std::vector<double> result;
        const int side = 2 * radius_ + 1;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                result.push_back(filtered(plane, width, height, x, y, radius_, [&](int i, int j) {
                    return values_[std::size_t(j + radius_) * side + i + radius_];
                }));
            }
        }
        return result;
    }

private:
    int radius_;
    std::vector<double> values_;
};

struct ReferencePercept {
    Triples colors;
    std::vector<double> edges, points;
};

inline ReferencePercept referencePercept(const LinearPicture& picture, double pixelsPerDegree) {
    const int width = picture.width, height = picture.height;
    std::array<std::vector<double>, 3> opponent;
    std::vector<double> grey;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
        Triple linear;
        for (std::size_t c = 0; c < 3; ++c) linear[c] = std::clamp(double(picture.rgb[i + c]), 0.0, 1.0);
        const Triple xyz = relativeXyz(linear);
        opponent[0].push_back(116.0 * xyz[1] - 16.0);
        opponent[1].push_back(500.0 * (xyz[0] - xyz[1]));
        opponent[2].push_back(200.0 * (xyz[1] - xyz[2]));
        grey.push_back(xyz[1]);
    }

    const auto sensitivity = [&](double a1, double b1, double a2, double b2) {
        const int radius =
            int(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kReferencePi * kReferencePi)) * pixelsPerDegree));
        return Square(
            radius,
            [=](int i, int j) {
                const double d2 = (i * i + j * j) / (pixelsPerDegree * pixelsPerDegree);
                const auto term = [&](double a, double b) {
                    return a * std::sqrt(kReferencePi / b) * std::exp(-kReferencePi * kReferencePi * d2 / b);
                };
                return term(a1, b1) + term(a2, b2);
            },
            false);
    };
    opponent[0] = sensitivity(1.0, 0.0047, 0.0, 1e-5).of(opponent[0], width, height);
    opponent[1] = sensitivity(1.0, 0.0053, 0.0, 1e-5).of(opponent[1], width, height);
    opponent[2] = sensitivity(34.1, 0.04, 13.5, 0.025).of(opponent[2], width, height);

    ReferencePercept percept;
    for (std::size_t i = 0; i < grey.size(); ++i) {
        const double y = (opponent[0][i] + 16.0) / 116.0;
        Triple linear = linearFromRelativeXyz({y + opponent[1][i] / 500.0, y, y - opponent[2][i] / 200.0});
        for (double& value : linear) value = std::clamp(value, 0.0, 1.0);
        percept.colors.push_back(referenceHuntLab(linear));
    }

    const double deviation = 0.5 * 0.082 * pixelsPerDegree, variance = deviation * deviation;
    const int radius = int(std::ceil(3.0 * deviation));
    const auto gaussian = [=](int i, int j) { return std::exp(-(i * i + j * j) / (2.0 * variance)); };
    const auto first = [=](int i, int j) { return -i * gaussian(i, j); };
    const auto second = [=](int i, int j) { return (i * i / variance - 1.0) * gaussian(i, j); };
    const auto bothWays = [&](const auto& function) {
        const auto across = Square(radius, function, true).of(grey, width, height);
        const auto down = Square(
                              radius, [&](int i, int j) { return function(j, i); }, true)
                              .of(grey, width, height);
        std::vector<double> result;
        for (std::size_t i = 0; i < across.size(); ++i) result.push_back(std::hypot(across[i], down[i]));
        return result;
    };
    percept.edges = bothWays(first);
    percept.points = bothWays(second);
    return percept;
}

inline std::vector<double> referenceFlip(const LinearPicture& a, const LinearPicture& b, double pixelsPerDegree) {
    const ReferencePercept p = referencePercept(a, pixelsPerDegree), q = referencePercept(b, pixelsPerDegree);
    std::vector<double> map;
    for (std::size_t i = 0; i < p.colors.size(); ++i) {
        const double color = referenceColorError(referenceHyab(p.colors[i], q.colors[i]));
        const double feature =
            std::max(std::abs(p.edges[i] - q.edges[i]), std::abs(p.points[i] - q.points[i])) / std::sqrt(2.0);
        map.push_back(std::pow(color, 1.0 - std::sqrt(feature)));
    }
    return map;
}

}  // namespace umbrage::test
