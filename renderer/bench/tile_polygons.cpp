// SPDX-License-Identifier: Apache-2.0
#include "bench/tile_polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "error.h"

namespace umbrage {
namespace {

using glm::cross;
using glm::dot;
using glm::dvec3;
using glm::dvec4;

constexpr double kRounding = 1e-14;  // of a sum of three terms, generously

double signOf(double value) {
    return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0;
}

/// The side a pixel's centre on the line itself is on: that of a place moved a little to the right, then down.
double sideOfZero(const PixelLine& line) {
    for (const double k : {line.a, line.b, line.c}) {
        if (k != 0.0) return signOf(k);
    }
    return 0.0;
}

double errorOf(const PixelLine& line, const TileView& view) {
    return kRounding * (std::abs(line.a) * view.width() + std::abs(line.b) * view.height() + std::abs(line.c));
}

/// The triangles turned to the light, their edges, and what they leave to infinity.
class Builder {
public:
    Builder(const dvec4& light, const TileView& view)
        : light_(view.toEye(light)), towards_(light_), isPoint_(light_.w != 0.0), view_(view) {}

    void add(const CastingTriangle& triangle);
    std::vector<TilePolygon> finish();

private:
    using Key = std::array<double, 3>;
    static Key keyOf(const dvec3& p) { return {p.x, p.y, p.z}; }

    /// The plane of a side: n out of the volume, and n . p = k of its points.
    struct SidePlane {
        dvec3 n;
        double k;
    };
    SidePlane sidePlane(const dvec3& a, const dvec3& b) const {
        return {isPoint_ ? cross(a - towards_, b - towards_) : cross(b - a, towards_), dot(cross(a, b), towards_)};
    }
    /// Where view rays meet the near plane, on which side of a plane that is.
    PixelLine nearLine(const SidePlane& plane) const { return view_.line(view_.near() * plane.n, -plane.k); }

    void keep(TilePolygon polygon, double side, std::initializer_list<PixelLine> lines);
    void setDepth(TilePolygon& polygon, const SidePlane& plane, std::initializer_list<dvec3> corners) const;
    void addLightCap(const std::array<dvec3, 3>& v, const SidePlane& plane, bool mayBeUnseen);
    void addDarkCap(const std::array<dvec3, 3>& v);
    void addNearPart(const std::array<dvec3, 3>& v, const SidePlane& plane);
    void addSide(const dvec3& a, const dvec3& b, int times);

    dvec4 light_;
    dvec3 towards_;
    bool isPoint_;
    const TileView& view_;
    std::map<std::array<Key, 2>, int> edges_;  // lesser end first: traversals that way less those the other way
    std::vector<TilePolygon> polygons_;
};

void Builder::keep(TilePolygon polygon, double side, std::initializer_list<PixelLine> lines) {
    if (side == 0.0) return;
    for (const PixelLine& line : lines) {
        const PixelLine inward{side * line.a, side * line.b, side * line.c};
        const std::size_t i = std::size_t(polygon.lineCount++);
        polygon.lines[i] = inward;
        polygon.thresholds[i] = sideOfZero(inward) > 0.0 ? 0.0 : std::numeric_limits<double>::denorm_min();
        polygon.errors[i] = errorOf(inward, view_);
    }
    const PixelBox all{0, 0, view_.width() - 1, view_.height() - 1};
    if (polygon.cover(all) != TilePolygon::Cover::None) polygons_.push_back(polygon);
}

void Builder::setDepth(TilePolygon& polygon, const SidePlane& plane, std::initializer_list<dvec3> corners) const {
    const double nearest = 1.0 / view_.near();
    for (const dvec3& corner : corners) {
        polygon.nearestInverseDepth =
            std::max(polygon.nearestInverseDepth, corner.z > view_.near() ? 1.0 / corner.z : nearest);
    }
    polygon.inverseDepth = view_.line(plane.n / plane.k);
    polygon.inverseDepthError = errorOf(polygon.inverseDepth, view_);
}

void Builder::add(const CastingTriangle& triangle) {
    std::array<dvec3, 3> v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = dvec3(view_.toEye(dvec4(triangle.corners[i], 1.0)));
    const auto normal = [&] { return cross(v[1] - v[0], v[2] - v[0]); };
    const double facing = dot(normal(), isPoint_ ? towards_ - v[0] : towards_);
    if (facing == 0.0 || (facing < 0.0 && triangle.oneSided)) return;
    if (facing < 0.0) std::swap(v[1], v[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        const Key a = keyOf(v[i]), b = keyOf(v[(i + 1) % 3]);
        if (a < b) {
            ++edges_[{a, b}];
        } else if (b < a) {
            --edges_[{b, a}];
        }
    }
    const SidePlane plane{normal(), dot(normal(), v[0])};
    addLightCap(v, plane, triangle.mayBeUnseen);
    if (isPoint_) addDarkCap(v);
    addNearPart(v, plane);
}

void Builder::addLightCap(const std::array<dvec3, 3>& v, const SidePlane& plane, bool mayBeUnseen) {
    const double side = signOf(plane.k);  // the eye is behind it: view rays leave through it
    TilePolygon polygon;
    polygon.kind = TilePolygon::Kind::LightCap;
    polygon.entering = std::int8_t(-side);
    // Else it is in the depth buffer wherever it is the nearest, so it is never before what is seen.
    if (mayBeUnseen && side != 0.0) setDepth(polygon, plane, {v[0], v[1], v[2]});
    const PixelLine beyondNear = nearLine(plane);
    keep(polygon, side,
         {view_.line(cross(v[0], v[1])),
          view_.line(cross(v[1], v[2])),
          view_.line(cross(v[2], v[0])),
          {-beyondNear.a, -beyondNear.b, -beyondNear.c}});
}

void Builder::addDarkCap(const std::array<dvec3, 3>& v) {
    TilePolygon polygon;
    polygon.kind = TilePolygon::Kind::DarkCap;
    polygon.entering = -1;
    const auto border = [&](std::size_t i) { return view_.line(sidePlane(v[i], v[(i + 1) % 3]).n); };
    keep(polygon, -1.0, {border(0), border(1), border(2)});
}

void Builder::addNearPart(const std::array<dvec3, 3>& v, const SidePlane& plane) {
    TilePolygon polygon;
    polygon.kind = TilePolygon::Kind::NearPart;
    polygon.entering = 1;
    const auto border = [&](std::size_t i) { return nearLine(sidePlane(v[i], v[(i + 1) % 3])); };
    keep(polygon, -1.0, {border(0), border(1), border(2), nearLine(plane)});
}

void Builder::addSide(const dvec3& a, const dvec3& b, int times) {
    const SidePlane plane = sidePlane(a, b);
    const double side = -signOf(plane.k);
    if (side == 0.0) return;  // the eye is in its plane
    TilePolygon polygon;
    polygon.entering = std::int8_t(side);
    polygon.times = std::int16_t(times);
    setDepth(polygon, plane, {a, b});
    // A side that runs towards the eye comes nearer than its edge.
    if (isPoint_ ? std::min(a.z, b.z) < towards_.z : towards_.z > 0.0) {
        polygon.nearestInverseDepth = 1.0 / view_.near();
    }
    const PixelLine edge = view_.line(cross(a, b)), atB = view_.line(cross(towards_, b)),
                    atA = view_.line(cross(a, towards_)), beyondNear = nearLine(plane);
    if (isPoint_) {
        keep(polygon, side, {edge, atB, view_.line(-plane.n), atA, beyondNear});
    } else {
        keep(polygon, side, {edge, atB, atA, beyondNear});
    }
}

std::vector<TilePolygon> Builder::finish() {
    for (const auto& [ends, times] : edges_) {
        const dvec3 a(ends[0][0], ends[0][1], ends[0][2]), b(ends[1][0], ends[1][1], ends[1][2]);
        if (times > 0) addSide(a, b, times);
        if (times < 0) addSide(b, a, -times);
    }
    return std::move(polygons_);
}

}  // namespace

TilePolygon::Cover TilePolygon::cover(const PixelBox& box) const {
    bool all = true;
    for (int i = 0; i < lineCount; ++i) {
        const PixelLine& line = lines[std::size_t(i)];
        const double x0 = line.a * box.left, x1 = line.a * box.right, y0 = line.b * box.top, y1 = line.b * box.bottom;
        const double error = errors[std::size_t(i)];
        if (std::max(x0, x1) + std::max(y0, y1) + line.c < -error) return Cover::None;
        all = all && std::min(x0, x1) + std::min(y0, y1) + line.c > error;
    }
    return all ? Cover::All : Cover::Some;
}

bool TilePolygon::covers(int x, int y) const {
    for (std::size_t i = 0; i < std::size_t(lineCount); ++i) {
        if (!(lines[i].at(x, y) >= thresholds[i])) return false;
    }
    return true;
}

std::array<double, 2> TilePolygon::inverseDepths(const PixelBox& box) const {
    const double x0 = inverseDepth.a * box.left, x1 = inverseDepth.a * box.right;
    const double y0 = inverseDepth.b * box.top, y1 = inverseDepth.b * box.bottom;
    const double least = std::min(x0, x1) + std::min(y0, y1) + inverseDepth.c - inverseDepthError;
    const double most = std::max(x0, x1) + std::max(y0, y1) + inverseDepth.c + inverseDepthError;
    return {std::max(least, -inverseDepthError), std::min(most, nearestInverseDepth + inverseDepthError)};
}

TileView::TileView(const Eye& eye, int width, int height)
    : fromWorld_(eye.viewFromWorld), rayScale_(eye.rayScale), near_(eye.znear), width_(width), height_(height) {
    if (!eye.perspective) {
        throw Error(ErrorKind::Input, "camera", "tiles are counted for perspective cameras only",
                    "choose another camera, or leave tiles out of measure");
    }
    for (int column = 0; column < 4; ++column) {
        fromWorld_[column].y = -fromWorld_[column].y;
        fromWorld_[column].z = -fromWorld_[column].z;
    }
}

PixelLine TileView::line(const dvec3& n, double k) const {
    PixelLine line;
    line.a = n.x * (2.0 * rayScale_.x / width_);
    line.b = n.y * (2.0 * rayScale_.y / height_);
    line.c = n.x * (rayScale_.x * (1.0 / width_ - 1.0)) + n.y * (rayScale_.y * (1.0 / height_ - 1.0)) + n.z + k;
    return line;
}

std::array<dvec3, 4> TileView::nearCorners() const {
    const glm::dmat4 toWorld = glm::inverse(fromWorld_);
    std::array<dvec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 ray = rayScale_ * glm::dvec2(i % 2 != 0 ? 1.0 : -1.0, i / 2 != 0 ? 1.0 : -1.0);
        corners[i] = dvec3(toWorld * dvec4(near_ * dvec3(ray, 1.0), 1.0));
    }
    return corners;
}

dvec3 TileView::ray(int x, int y) const {
    return {line({1, 0, 0}).at(x, y), line({0, 1, 0}).at(x, y), 1.0};
}

std::vector<TilePolygon> volumePolygons(const TileCaster& caster, const dvec4& light, const TileView& view) {
    Builder builder(light, view);
    for (const CastingTriangle& triangle : caster.triangles) builder.add(triangle);
    return builder.finish();
}

}  // namespace umbrage
