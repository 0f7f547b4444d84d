// SPDX-License-Identifier: Apache-2.0
// FLIP's filters (sections 4.1 and 4.2 of the paper). All of them are sums of products of a function of x and one of y,
// so that each is applied along rows and then along columns.
#pragma once

#include <vector>

namespace umbrage::flip {

/// One channel, rows from the top.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;
};

/// Weights of an odd number of neighbours, the middle one the pixel itself.
using Kernel = std::vector<float>;

/// A filter is applied in two steps, to what lies beside a pixel and to what lies above and below it. Outside the
/// picture is what lies at its edge.
Plane alongRows(const Plane& plane, const Kernel& kernel);
Plane alongColumns(const Plane& plane, const Kernel& kernel);

/// One of the eye's contrast sensitivities as a filter: a weighted sum of Gaussians, each of which is a kernel in both
/// directions. All weights of the sum's products together are 1.
struct Sensitivity {
    std::vector<Kernel> gaussians;
    std::vector<float> weights;

    Plane applied(const Plane& plane) const;
};

struct Sensitivities {
    Sensitivity achromatic, redGreen, blueYellow;

    explicit Sensitivities(double pixelsPerDegree);
};

/// A Gaussian as wide as the smallest feature that is looked for, with its first and second derivative. The Gaussian's
/// weights add up to 1, the derivatives' positive ones to 1 and their negative ones to -1.
struct FeatureKernels {
    Kernel gaussian, first, second;

    explicit FeatureKernels(double pixelsPerDegree);
};

/// How far a difference of two pictures can be felt in their map, in pixels.
int reach(double pixelsPerDegree);

}  // namespace umbrage::flip
