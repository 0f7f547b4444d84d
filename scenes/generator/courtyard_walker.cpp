// SPDX-License-Identifier: Apache-2.0
// The courtyard's skinned figure: eleven joints, closed pieces, a walk that repeats every second on a circle that
// closes after two.
#include "courtyard.h"
#include "stage.h"

namespace generator {
namespace {

enum Joint { kHips, kSpine, kHead, kThighL, kShinL, kThighR, kShinR, kArmL, kForearmL, kArmR, kForearmR, kJointCount };

struct JointSpec {
    const char* name;
    int parent;
    dvec3 place;  // of the bind pose, in the figure's space; it looks along +Z, its left is +X
};

constexpr JointSpec kJoints[kJointCount] = {
    {"Hips", kNone, {0, 0.95, 0}},          {"Spine", kHips, {0, 1.12, 0}},        {"Head", kSpine, {0, 1.5, 0.01}},
    {"ThighL", kHips, {0.1, 0.9, 0}},       {"ShinL", kThighL, {0.1, 0.49, 0.01}}, {"ThighR", kHips, {-0.1, 0.9, 0}},
    {"ShinR", kThighR, {-0.1, 0.49, 0.01}}, {"ArmL", kSpine, {0.2, 1.4, 0}},       {"ForearmL", kArmL, {0.23, 1.12, 0}},
    {"ArmR", kSpine, {-0.2, 1.4, 0}},       {"ForearmR", kArmR, {-0.23, 1.12, 0}},
};

/// From `upper` above the height `at` to `lower` below it, blended over `reach` on both sides.
Influence hinge(const dvec3& p, int upper, int lower, double at, double reach) {
    const double t = (at + reach - p.y) / (2 * reach);
    if (t <= 0) return {upper, upper, 0};
    if (t >= 1) return {lower, lower, 0};
    return {upper, lower, std::round(smooth(t) * 64) / 64};
}

Shape legs() {
    const std::vector<dvec3> path{{0.1, 0.93, 0},     {0.1, 0.75, 0},     {0.1, 0.58, 0.01},
                                  {0.1, 0.53, 0.015}, {0.1, 0.49, 0.015}, {0.1, 0.45, 0.01},
                                  {0.1, 0.4, 0},      {0.1, 0.25, -0.01}, {0.1, 0.08, -0.01}};
    Shape left = tube(ringsAlong(path, {0.09, 0.09, 0.072, 0.066, 0.064, 0.062, 0.064, 0.055, 0.045}), 10);
    left.add(bevelledBox({0.045, 0, -0.08}, {0.155, 0.11, 0.18}, 0.03).bent([](const dvec3& p) {
        return p.z > 0.1 ? dvec3(p.x, p.y * 0.7, p.z) : p;
    }));
    const auto bend = [](int thigh, int shin) {
        return [=](const dvec3& p) { return hinge(p, thigh, shin, 0.49, 0.07); };
    };
    Shape result = left.influencedBy(bend(kThighL, kShinL));
    return result.add(left.mirrored().influencedBy(bend(kThighR, kShinR)));
}

Shape arms() {
    const std::vector<dvec3> path{{0.17, 1.43, 0},  {0.2, 1.36, 0},      {0.215, 1.24, 0},
                                  {0.225, 1.17, 0}, {0.23, 1.12, 0},     {0.235, 1.07, 0},
                                  {0.24, 0.98, 0},  {0.245, 0.87, 0.01}, {0.245, 0.83, 0.01}};
    const Shape left = tube(ringsAlong(path, {0.05, 0.065, 0.06, 0.055, 0.052, 0.052, 0.055, 0.06, 0.045}), 8);
    const auto bend = [](int upper, int lower) {
        return [=](const dvec3& p) { return hinge(p, upper, lower, 1.12, 0.06); };
    };
    Shape result = left.influencedBy(bend(kArmL, kForearmL));
    return result.add(left.mirrored().influencedBy(bend(kArmR, kForearmR)));
}

Shape handsAndFace() {
    const Shape hand = sphere(0.05, 8, 6).scaled({0.8, 1.2, 0.9}).moved({0.247, 0.8, 0.01});
    Shape result = hand.influencedBy([](const dvec3&) { return Influence{kForearmL, kForearmL, 0}; });
    result.add(hand.mirrored().influencedBy([](const dvec3&) { return Influence{kForearmR, kForearmR, 0}; }));
    const Shape face = sphere(0.105, 12, 9).scaled({0.9, 1.15, 1}).moved({0, 1.63, 0.035});
    return result.add(face.influencedBy([](const dvec3&) { return Influence{kHead, kHead, 0}; }));
}

/// Tunic, skirt and hood. The skirt follows the thighs, left and right, more towards its hem.
Shape clothes() {
    Shape tunic = lathe({{0, 0.98},
                         {0.155, 0.98},
                         {0.15, 1.08},
                         {0.16, 1.18},
                         {0.19, 1.32},
                         {0.2, 1.4},
                         {0.16, 1.46},
                         {0.07, 1.5},
                         {0, 1.51}},
                        16)
                      .scaled({1.1, 1, 0.72})
                      .influencedBy([](const dvec3& p) { return hinge(p, kSpine, kHips, 1.08, 0.09); });
    const Shape skirt =
        lathe({{0.12, 0.95},
               {0.26, 0.56},
               {0.27, 0.55},
               {0.28, 0.56},
               {0.22, 0.8},
               {0.165, 1.02},
               {0.15, 1.03},
               {0.12, 0.95}},
              20)
            .scaled({1, 1, 0.85})
            .influencedBy([](const dvec3& p) {
                const double low = std::clamp((0.98 - p.y) / 0.42, 0.0, 1.0), side = std::min(1.0, std::abs(p.x) / 0.2);
                return Influence{kHips, p.x > 0 ? kThighL : kThighR, std::round(0.75 * low * side * 64) / 64};
            });
    const Shape hood =
        lathe({{0, 1.46}, {0.15, 1.43}, {0.13, 1.5}, {0.135, 1.62}, {0.115, 1.74}, {0.05, 1.8}, {0, 1.81}}, 14)
            .bent([](const dvec3& p) {
                return p.z > 0.04 && p.y > 1.52 && p.y < 1.73 ? dvec3(p.x, p.y, 0.04)
                                                              : dvec3(p.x, p.y, p.z * 1.1 - 0.01);
            })
            .influencedBy([](const dvec3& p) { return hinge(p, kHead, kSpine, 1.48, 0.04); });
    return tunic.add(skirt).add(hood);
}

void animateWalk(Document& document, int root, const std::vector<int>& joints, const dvec3& centre) {
    constexpr int kKeys = 33;
    const auto times = evenly(kSequenceSeconds, kKeys);
    std::vector<dvec3> places;
    std::vector<dquat> headings;
    for (const double time : times) {
        const double around = 180 * time;  // once in two seconds
        places.push_back(centre + dvec3(sinDegrees(around), 0, cosDegrees(around)) * 0.62 +
                         dvec3(0, 0.018 * cosDegrees(720 * time) - 0.03, 0));
        headings.push_back(turn(around + 90, {0, 1, 0}) * turn(-7, {0, 0, 1}));  // leaning into the bend
    }
    document.translate(root, times, places);
    document.rotate(root, times, headings);

    const auto joint = [&](int index, const dvec3& axis, const std::function<double(double)>& degreesAt) {
        swing(document, joints[index], axis, kKeys, [&](double t) { return degreesAt(2 * t * 360); });  // two cycles
    };
    const dvec3 x{1, 0, 0}, y{0, 1, 0};
    const auto thigh = [](double phase) { return -3 - 30 * sinDegrees(phase); };
    const auto knee = [](double phase) { return 12 + 38 * std::max(0.0, cosDegrees(phase + 10)); };
    joint(kHips, y, [](double a) { return 7 * sinDegrees(a); });
    joint(kSpine, y, [](double a) { return -14 * sinDegrees(a); });
    joint(kHead, y, [](double a) { return 7 * sinDegrees(a); });
    joint(kThighL, x, [&](double a) { return thigh(a); });
    joint(kShinL, x, [&](double a) { return knee(a); });
    joint(kThighR, x, [&](double a) { return thigh(a + 180); });
    joint(kShinR, x, [&](double a) { return knee(a + 180); });
    joint(kArmL, x, [](double a) { return 26 * sinDegrees(a); });
    joint(kForearmL, x, [](double a) { return -28 + 10 * sinDegrees(a); });
    joint(kArmR, x, [](double a) { return -38 + 6 * sinDegrees(a); });
    joint(kForearmR, x, [](double a) { return -52 - 4 * sinDegrees(a); });
}

}  // namespace

void addWalker(Document& document, const CourtyardMaterials& m, const dvec3& centre) {
    const int root = document.node({.name = "WalkerRoot", .translation = centre});
    std::vector<int> joints;
    std::vector<dvec3> places;
    for (const JointSpec& spec : kJoints) {
        const dvec3 above = spec.parent == kNone ? dvec3(0) : kJoints[spec.parent].place;
        joints.push_back(document.node({.name = spec.name,
                                        .parent = spec.parent == kNone ? root : joints[spec.parent],
                                        .translation = spec.place - above}));
        places.push_back(spec.place);
    }
    const GeometryOptions options{.creaseDegrees = 60, .texCoords = false, .joints = true};
    const int mesh = document.mesh("Walker", {{geometryOf(clothes().add(arms()), options), m.tunic},
                                              {geometryOf(handsAndFace(), options), m.skin},
                                              {geometryOf(legs(), options), m.leather}});
    document.node({.name = "Walker", .mesh = mesh, .skin = document.skin("Walker", joints, places)});
    addHangingLamp(document, m, {.name = "HandLamp", .color = {1, 0.68, 0.36}, .intensity = 12}, joints[kForearmR],
                   {-0.015, -0.34, 0.02}, turn(90, {1, 0, 0}));
    animateWalk(document, root, joints, centre);
}

}  // namespace generator
