// SPDX-License-Identifier: Apache-2.0
// Stress family G: thin things, sample positions, tiles. Most look straight at a wall in the plane z = 0 so that all
// coordinates are exact: 8 or 16 pixels a metre.
#include "stress/floating.h"

namespace generator::stress {
namespace {

void addWall(Document& document) {
    place(document, "Wall", grid({-32, -24, 0}, {64, 0, 0}, {0, 48, 0}, 1, 1), paint(document, "Wall", dvec3(0.6)),
          Kind::Receiver);
}

/// Closed bars of square section, `widths` wide, a little off the horizontal, one above the other.
Mesh wires(double pixelMetres, double length, double spacing, double height) {
    Mesh result;
    for (int i = 0; i < 10; ++i) {
        const double half = 0.025 * (i + 1) * pixelMetres;
        const dquat slope = turn(2 + 1.5 * i, {0, 0, 1});
        result.add(moved(box({-length / 2, -half, -half}, {length / 2, half, half}),
                         [&](const dvec3& p) { return slope * p + dvec3(0, spacing * (i - 4.5), height); }));
    }
    return result;
}

Case wiresOnWall(const std::string& id, int samples) {
    const auto fill = [](Document& document) {
        addWall(document);
        place(document, "Wires", wires(1.0 / 16, 9, 0.9, 2), paint(document, "Wires", kCasterColor));
    };
    return {
        id,
        samples == 1 ? "wires 0.05 to 0.5 pixels wide before a wall, and their shadows of two lights"
                     : "the wires of G1-1 with four samples a pixel",
        "dotted lines: as with rays through the sample positions",
        "thin things lost or widened",
        fill,
        sequence({.camera = orthographicEye("[0, 0, 16]", "[0, 0, 0]", 6, 1, 64),
                  .lights = {pointLight("Lamp", at({-3.3, 4.1, 11}), 12), sun("Sun", at({2.1, 1.3, 4}), at({0, 0, 0}))},
                  .samples = samples})};
}

Case wiresOnGround() {
    const auto fill = [](Document& document) {
        addGround(document, 9);
        const Mesh upright = wires(0.035, 7, 0.55, 0);
        place(document, "Wires", moved(upright, [](const dvec3& p) { return dvec3(p.x, 1.2 + p.z, 0.4 - p.y); }),
              paint(document, "Wires", kCasterColor));
    };
    return {"G1-2",
            "wires about 0.05 to 0.5 pixels wide above the ground",
            "dotted lines: as with rays",
            "thin things lost or widened",
            fill,
            lookDown()};
}

// Eight pixels a metre: sample positions are the odd multiples of 1/16 m. With this light, casters at z = 4 throw
// shadows twice as large and casters at z = 6 four times; odd multiples of 1/16 stay such.
constexpr double kPixel = 0.125, kSample = kPixel / 2;
constexpr dvec3 kLamp{8 + kSample, 4 + kSample, 8};

std::string lampOnSamples() {
    return pointLight("Lamp", at(kLamp), 14);
}

/// The point at z = 4 whose shadow on the wall is (x, y).
vec3 towards(double x, double y) {
    return vec3((x + kLamp.x) / 2, (y + kLamp.y) / 2, 4);
}

/// Shapes whose corners, and those of their shadows, lie on sample positions; pieces that share edges are nodes of
/// their own.
void addOnSamples(Document& document) {
    addWall(document);
    const int material = paint(document, "Caster", kCasterColor, true);
    const double o = kSample;
    int count = 0;
    const auto add = [&](const Mesh& mesh) {
        place(document, "Piece" + std::to_string(count++), mesh, material, Kind::Open);
    };
    // A square of 4 x 4 squares, each a caster.
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const double x = o - 6 + i, y = o + 1 + j;
            add(Mesh().quad(towards(x, y), towards(x + 1, y), towards(x + 1, y + 1), towards(x, y + 1)));
        }
    // A disc of eight casters, whose edges run along rows, columns and diagonals of samples.
    const double ring[8][2] = {{3, 0}, {2, 2}, {0, 3}, {-2, 2}, {-3, 0}, {-2, -2}, {0, -3}, {2, -2}};
    for (int i = 0; i < 8; ++i) {
        const auto rim = [&](int k) { return towards(o - 11 + ring[k % 8][0], o - 5 + ring[k % 8][1]); };
        add(Mesh().triangle(towards(o - 11, o - 5), rim(i), rim(i + 1)));
    }
    // A diamond in one mesh, a row of pixels, a column of pixels.
    add(Mesh().quad(towards(o - 2, o - 6), towards(o, o - 4), towards(o - 2, o - 2), towards(o - 4, o - 4)));
    for (int i = 0; i < 8; ++i) {
        const double x = o - 13 + 2 * kPixel * i, y = o + 9;
        add(Mesh().quad(towards(x, y), towards(x + kPixel, y), towards(x + kPixel, y + kPixel),
                        towards(x, y + kPixel)));
        add(Mesh().quad(towards(x, y - 1), towards(x + kPixel, y - 1), towards(x + kPixel, y - 2), towards(x, y - 2)));
    }
    // A closed box from z = 4 to z = 6.
    place(document, "Box", box({o + 6.5, o + 1.5, 4}, {o + 7.5, o + 2.5, 6}), material);
}

const std::string kConsistent =
    "every sample on a shared edge belongs to one side alone: counts are 0 or 1 (closed: even)";

std::vector<Case> onSamples() {
    const char* catches = "quads that meet on a sample and count it twice or never";
    // A shift by which corners come to lie on the positions of four samples a pixel, in sixteenths of a pixel.
    const auto shifted = [](const dvec3& origin) {
        std::vector<std::pair<double, dvec3>> keys;
        double seconds = 0;
        for (const auto& [x, y] : {std::pair{2, 6}, {2, -6}, {-6, 2}, {-6, -2}})
            keys.emplace_back(seconds++, origin + kPixel / 16 * dvec3(x, y, 0));
        return keyed(keys);
    };
    return {
        {"G2-1", "an orthographic look at a wall: corners and edges of casters and shadows exactly on pixel centres",
         kConsistent, catches, addOnSamples,
         sequence({.camera = orthographicEye("[0, 0, 16]", "[0, 0, 0]", 12, 1, 64), .lights = {lampOnSamples()}})},
        {"G2-2",
         "the scene of G2-1 seen with a field of view of 90 degrees from 12 m: shadows exactly on pixel centres",
         kConsistent, catches, addOnSamples,
         sequence({.camera = eye("[0, 0, 12]", "[0, 0, 0]", 90), .lights = {lampOnSamples()}})},
        {"G2-3", "G2-1 with four samples a pixel, moved so that corners lie on the usual positions of samples",
         kConsistent, catches, addOnSamples,
         sequence({.camera = orthographicEye(shifted({0, 0, 16}), shifted({0, 0, 0}), 12, 1, 64),
                   .lights = {lampOnSamples()},
                   .frames = "0-3",
                   .samples = 4})}};
}

/// Pixels (64 i, 64 j) lie at multiples of 8 m, counted from the upper left corner (-16, 12).
Case acrossTiles() {
    const auto fill = [](Document& document) {
        addWall(document);
        const int material = paint(document, "Caster", kCasterColor, true);
        const int root = document.node({.name = "Mover"});
        const auto add = [&](const char* name, double left, double bottom, double right, double top) {
            const Mesh plate =
                Mesh().quad(towards(left, bottom), towards(right, bottom), towards(right, top), towards(left, top));
            document.node(
                {.name = name, .parent = root, .mesh = document.mesh(name, {partOf(plate, material)}, Kind::Open)});
        };
        add("RightOnColumn", -10, -2, -8, 3);
        add("CornerOnCorner", 0, 4, 3, 8);
        add("LowerOnRow", -6, -4, -1, -2);
        add("WholeTile", -8, -12, 0, -4.5);
        add("OnePixel", -12, -4, -12 + kPixel, -4 + kPixel);
        add("SmallTile", -13, 5, -12, 6);

        std::vector<double> seconds;
        std::vector<dvec3> places;
        for (int frame = 1; frame <= static_cast<int>(kSweepEnd); ++frame) {
            seconds.push_back(frame);
            places.push_back(kPixel / 512 * (frame - kSweepMiddle) * dvec3(1, 1, 0));
        }
        document.translate(root, seconds, places);
    };
    return {"G3",
            "plates move by 1/512 pixel a frame in x and y, their shadows by 2/512; at frame 501 these lie exactly "
            "on the borders of tiles of 8 and 64 pixels",
            "no error the shape of a tile; a pixel changes when an edge passes its centre",
            "tiles classified off by one",
            fill,
            sequence({.camera = orthographicEye("[0, 0, 16]", "[0, 0, 0]", 12, 1, 64),
                      .lights = {lampOnSamples()},
                      .frames = kSweepFrames})};
}

}  // namespace

std::vector<Case> rasterCases() {
    std::vector<Case> cases{wiresOnWall("G1-1", 1), wiresOnGround()};
    for (Case& one : onSamples()) cases.push_back(std::move(one));
    cases.push_back(acrossTiles());
    Case smooth = floating("G4-1", "a torus and a box above the ground with four samples a pixel",
                           "the mask of each sample is that of a ray through its position",
                           "masks resolved before they are tested", [] {
                               return oddlyPlaced(torus(1.3, 0.5, 40, 20), {-0.4, 2.1, 0})
                                   .add(oddlyPlaced(box(dvec3(-0.7), dvec3(0.7), 2), {1.6, 1.7, 0.4}));
                           });
    smooth.sequence = lookDown("1", 4);
    cases.push_back(std::move(smooth));
    cases.push_back(wiresOnWall("G4-2", 4));
    return cases;
}

}  // namespace generator::stress
