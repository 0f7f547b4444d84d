// SPDX-License-Identifier: Apache-2.0
// What stress cases are made of: meshes whose floats are stored as they are, and sequence files whose numbers keep
// every bit.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "document.h"

namespace generator::stress {

using glm::dmat3;
using glm::vec3;

/// Triangles as they will be stored: nothing is snapped, nothing welded. Shaded flat unless there are normals.
struct Mesh {
    std::vector<vec3> positions{};
    std::vector<vec3> normals{};
    std::vector<std::uint32_t> indices{};

    /// Vertices of its own, counter-clockwise seen from the front.
    Mesh& triangle(const vec3& a, const vec3& b, const vec3& c);
    Mesh& quad(const vec3& a, const vec3& b, const vec3& c, const vec3& d);
    Mesh& add(const Mesh& other);
};

/// A parallelogram from `corner` along u and v, cut into cells; its front is where u x v points. Indexed.
Mesh grid(const dvec3& corner, const dvec3& u, const dvec3& v, int cellsU, int cellsV);
/// Faces outward, each cut cuts x cuts; neighbours share the bits of their positions, not their vertices.
Mesh box(const dvec3& low, const dvec3& high, int cuts = 1);
/// 20 * 4^levels triangles around a centre, indexed.
Mesh icosphere(const dvec3& centre, double radius, int levels);
/// A torus about the axis y; quads cut in two.
Mesh torus(double radius, double thickness, int around, int sides);

/// Four triangles whose corners are multiples of 2^-3 and lie along no axis.
Mesh oddTetrahedron();

Mesh flipped(Mesh mesh);
/// The nearest floats.
inline dvec3 rounded(const dvec3& value) {
    return dvec3(vec3(value));
}
/// Each position computed in double and rounded once.
Mesh moved(Mesh mesh, const std::function<dvec3(const dvec3&)>& place);

/// A rotation that aligns nothing with anything: Euler angles (0.3721, 0.9134, 0.5178) rad about x, then y, then z.
dmat3 oddRotation();

Part partOf(const Mesh& mesh, int material, Mode mode = Mode::Triangles, bool indexed = true);
int paint(Document& document, const std::string& name, const dvec3& color, bool doubleSided = false);
/// A mesh of one material on a node of its own; the result is the mesh's index, for further nodes.
int place(Document& document, const std::string& name, const Mesh& mesh, int material, Kind kind = Kind::Closed);
/// A light grey square in the plane y = height, facing up: a receiver.
void addGround(Document& document, double halfSize, int cells = 1, double height = 0);
inline constexpr dvec3 kCasterColor{0.8, 0.45, 0.2};
/// A box, a sphere and a torus above the ground around x = z = 0, up to 5 m high.
void addCasters(Document& document);
/// Ground, a wall across z = -7, and addCasters().
void addStage(Document& document);
/// A directional light of the glTF file, 3 lux; a unit `direction` is kept bit by bit.
void addSun(Document& document, const std::string& name, const dvec3& direction);
/// Six light grey walls seen from inside: a receiver.
void addRoom(Document& document, const dvec3& low, const dvec3& high);

// Pieces of sequence files. Positions are texts: at() or keyed().

/// The shortest decimals that give the same double back.
std::string at(const dvec3& position);
/// Values at seconds; linear between them.
std::string keyed(const std::vector<std::pair<double, dvec3>>& keys);

inline constexpr const char* kSweepFrames = "1-1001";
inline constexpr double kSweepMiddle = 501, kSweepEnd = 1001;  // seconds, and frames
/// A straight path over a sweep's frames from middle - reach to middle + reach, slow about its middle, where it is
/// exactly at the middle frame.
std::string pathThrough(const dvec3& middle, const dvec3& reach);

std::string eye(const std::string& position, const std::string& target, double yfovDegrees = 45, double znear = 0.05);
std::string orthographicEye(const std::string& position, const std::string& target, double ymag, double znear,
                            double zfar);
/// Bright at `reachMetres`: 3 lux there.
std::string pointLight(const std::string& name, const std::string& position, double reachMetres);
/// 3 lux from `from` towards `to`.
std::string sun(const std::string& name, const std::string& from, const std::string& to);

/// A sequence file below its scene: one frame of 256 x 192 with a little light from everywhere.
struct Shot {
    std::string camera{};               // what stands after `camera:`
    std::vector<std::string> lights{};  // mappings; besides those of the glTF file
    std::string frames = "1";           // at one a second: frame f is at f seconds
    int width = 256, height = 192, samples = 1;
    std::string more{};  // further lines
};
std::string sequence(const Shot& shot);

}  // namespace generator::stress
