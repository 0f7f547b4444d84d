// SPDX-License-Identifier: Apache-2.0
// Included by C++ and by every shader: what both sides must agree about. Structures are laid out for std430.
#ifndef UMBRAGE_SHARED_H
#define UMBRAGE_SHARED_H

#ifdef __cplusplus
#include <glm/glm.hpp>
namespace umbrage::gpu {
using uint = unsigned int;
using uvec2 = glm::uvec2;
using uvec4 = glm::uvec4;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using mat4 = glm::mat4;
#endif

// Shader storage bindings, one name a buffer for the whole program. GL 4.5 guarantees only 8 per stage; llvmpipe and
// NVIDIA have 16.
#define BIND_POSITIONS 0
#define BIND_INDICES 1
#define BIND_TRIANGLE_FLAGS 2
#define BIND_EDGES 3
#define BIND_INSTANCES 4
#define BIND_TRIANGLE_CHUNKS 5
#define BIND_EDGE_CHUNKS 6
#define BIND_LIGHTS_IN_MODEL 7
#define BIND_FACING 8
#define BIND_PLANES 9
#define BIND_QUADS 10
#define BIND_SUMMARY 11
#define BIND_LIGHTS 12
#define BIND_DRAWS 14
#define BIND_CASTERS 15
// Counting by parts alone has these, see split.glsl.
#define BIND_PARTS 16
#define BIND_PART_OF 17
#define BIND_CLUSTERS 18

// The deform pass runs before all others and borrows their bindings.
#define BIND_DEFORM_NORMALS 8
#define BIND_DEFORM_TANGENTS 9
#define BIND_DEFORM_INFLUENCES 10
#define BIND_DEFORM_JOINTS 11
#define BIND_DEFORM_MORPHS 12
#define BIND_DEFORM_BOUNDS 13
#define BIND_DEFORM_WEIGHTS 14
#define MORPH_FLOATS 9u  // per vertex and target: position, normal, tangent
// Displacement::Kind
#define PROCEDURE_NOISE 0u
#define PROCEDURE_WAVE 1u
#define PROCEDURE_TWIST 2u

#define BOUNDS_WORDS 6u  // per deforming instance: least and greatest xyz, as integers in the same order

// So do matrices of the frame before, for motion.
#define BIND_PREVIOUS 13

// So does the count of what volumes fill.
#define BIND_FILL 13

// So does the geometry stage that makes side quads.
#define BIND_ADJACENCY 14

// So does the bound on layers (T6).
#define BIND_LAYER_CELLS 13
#define BIND_LAYER_BOUNDS 14
#define LAYER_GRID 32u  // cells along a face; a power of two
#define LAYER_CELLS (6u * LAYER_GRID * LAYER_GRID)

// After those of the G-buffer.
#define UNIT_SHADOW_MAP 7

// Texture units of the vertex stage, apart from those of what is drawn into.
#define UNIT_EDGE_FLAGS 8
#define UNIT_IN_VIEW 9
#define UNIT_IN_MODEL 10
#define TEXEL_ROW 4096u  // texels in a row of vertices or edges

// Uniform block bindings.
#define BIND_VIEW 0
#define BIND_MATERIAL 1

// Facing words are 32 bits, so lights are counted in groups of 32.
#define LIGHTS_PER_GROUP 32
// Triangles and edges of an instance are padded to whole chunks, so that id >> CHUNK_SHIFT finds the instance.
#define CHUNK_SHIFT 7
#define CHUNK_SIZE 128

// One dimension of a dispatch holds 65,535 groups everywhere; larger ones take a second.
#define GROUP_ROW 65535u
#define GROUP_HERE (gl_WorkGroupID.y * GROUP_ROW + gl_WorkGroupID.x)

// TriangleFlags
#define TRIANGLE_CASTS 1u
#define TRIANGLE_EVEN 2u          // its connected component has only edges of even valence
#define TRIANGLE_SINGLE_SIDED 4u  // not in the depth buffer when seen from behind
#define TRIANGLE_HOLED 8u         // alpha-masked: its holes are not in the depth buffer

// Edge::a and Edge::b: vertex, canonical order a < b. Edge::left and right: triangle | EDGE_REVERSED, or EDGE_NONE.
#define EDGE_REVERSED 0x80000000u  // the triangle runs along the edge from b to a
#define EDGE_EVEN 0x40000000u      // (in left) its component is even
#define EDGE_TRIANGLE 0x3fffffffu
#define EDGE_NONE 0xffffffffu

// InstanceData::flags
#define INSTANCE_MIRRORED 1u    // negative determinant: front faces run clockwise on screen
#define INSTANCE_WHOLE 2u       // counted with all its surfaces, not halved (see shadow/counts.h)
#define INSTANCE_INSIDE_OUT 4u  // its evaluated positions are mirrored: what the file calls front runs clockwise

// A placed triangle: InstanceData::placedTriangleBase + triangle of the mesh. Background and lines have none.
#define NO_TRIANGLE 0xffffffffu
#define LINE_OR_POINT 0xfffffffeu  // what readers of samples get where one of these is seen

struct InstanceData {
    vec4 viewFromModel[3];    // rows
    vec4 normalFromModel[3];  // rows: inverse transpose of the same; w unused
    vec4 eyeInModel;          // (eye, 1), or for an orthographic eye (direction towards the viewer, 0)
    uint vertexBase, triangleBase, triangleCount, placedTriangleBase;
    uint edgeBase, edgeCount, placedEdgeBase, flags;
};

struct Edge {
    uint a, b, left, right;
};

// shadow/fault.h
#ifndef FAULT
#define FAULT 0
#endif
#define FAULT_FACING_TWICE 2
#define FAULT_WRONG_FACING 4
#define FAULT_MISSING_EDGE 5
#define FAULT_ORIGIN_EXTRUSION 7

// The lists of side quads a light has.
#define LIST_HALVED 0  // even components: one quad for two crossings, counted by z-pass
#define LIST_WHOLE 1   // all others, |m| quads an edge, counted by z-pass
#define LIST_FAIL 2    // |m| quads an edge, counted by z-fail
#define LIST_KINDS 3
// Each list in two: quads seen nearly edge-on are kept apart, at kind + LIST_EDGE_ON (see count.frag.glsl).
#define LIST_EDGE_ON LIST_KINDS
#define LIST_COUNT (2 * LIST_KINDS)
#define HAZARD 1.52587890625e-5  // 2^-16, of the distance: closer than this to a volume's faces the eye is on them (T4)
#define IN_LINE_SINE 1e-6        // as EDGE_ON_SINE: so nearly edge-on that it covers nothing
#define EDGE_ON_SINE \
    0.0078125  // of the angle between the plane of a quad or cap and the direction to one of its corners

// The viewport is that much larger than the picture, about its centre: where clipping moves corners (seen millimetres
// before a quad of a kilometre, floats miss by pixels) it does so outside.
#define VIEWPORT_SCALE 2.0

// Uniform locations shared by programs that differ in their vertex shader.
#define COUNT_FRONT_VALUE 15
#define FIRST_CLUSTER 11
#define HULL_COLOR 12
#define EXTENT_FACES 20  // six planes in view space: normal, offset
#define TALLY_KIND 13
#define TALLY_FAILED 14
#define VOLUME_END 9

// What an entry of a list of side quads is beside placed edge << 1 | (m < 0): it belongs to the part of the edge's
// right triangle, whose left one is of another part.
#define QUAD_OF_RIGHT 0x80000000u

// Kinds of caps, see cap.vert.glsl.
#define CAP_TRUE 0
#define CAP_EDGE_ON 1
#define CAP_FAR 2
#define CAP_DARK 3
#define CAP_SECTION 4     // see near_cap.vert.glsl
#define CAP_LIGHT_VIEW 5  // see light_view.vert.glsl

// Share of the depth range before the near plane, in frames whose counts begin there (Kilgard 2001: the ledge). A
// half, because scaling floats by a power of two rounds nothing.
#define LEDGE 0.5

// What a triangle's volume does at the plane where near-cap begins to count (Kilgard's cases): none of the rays through
// its corners meets it, all do, or some.
#define NEAR_CAP_TRIVIAL 0
#define NEAR_CAP_EASY 1
#define NEAR_CAP_HARD 2
#define NEAR_CAP_CASES 3

// A command of glDrawElementsIndirect.
struct DrawCommand {
    uint count, instanceCount, firstIndex, baseVertex, baseInstance;
};

// Per instance.
struct CasterState {
    uint countedByFail;  // bits of this group's lights: counted by z-fail
    uint hazards;        // bits of lights for which it must be (T4); written by the silhouette passes
    uint missing;        // some of it is nearer than what is seen there: culled, or before the near plane (T1)
    uint outOfReach;     // bits of lights whose range or cone it is out of: it neither receives nor casts
    uint outOfView;      // bits of lights with which no view ray meets it or its volume
    uint lightOn;        // bits of lights that lie on one of its triangles, which then has no weight; as hazards
    uint lightMoved;     // bits of lights that were moved for it, out of line with it and the eye
    uint ends[4];        // ten lights in each, three bits a light: 0, or 1 + the face of the light's extent that its
                         // volume ends behind
};

// A part of the casters of one light, counted by z-pass before its split plane and by z-fail behind it (Laine 2005).
struct SplitPart {
    vec4 points[2];     // view space; the second's w: SplitPoints::Kind
    vec4 plane;         // on screen, see split.glsl
    uint eyeInside[2];  // its layers over the two ends of the view rays: SPLIT_PASS, SPLIT_FAIL
    uint hazards;       // bits of the ends that lie on its volumes (T4)
    uint unusedPart;
};
#define SPLIT_POINT_POINT 1.0
#define SPLIT_NOWHERE 2.0
#define SPLIT_PASS 0
#define SPLIT_FAIL 1

// Casters that are told apart in one pass.
#define ATTRIBUTED 12

// Kinds of fragments of shadow volumes.
#define FILL_HALVED_SIDES 0  // one for two crossings where LIST_HALVED is halved
#define FILL_SIDES 1
#define FILL_LIGHT_CAPS 2
#define FILL_DARK_CAPS 3
#define FILL_KINDS 4

// Per instance: the fragments of a light's volumes, by kind, facing, and the depth test.
struct CasterFill {
    uint passedFront[FILL_KINDS], passedBack[FILL_KINDS], failedFront[FILL_KINDS], failedBack[FILL_KINDS];
    uint nearCaps[NEAR_CAP_CASES];  // triangles
};

// What the silhouette passes say about one light.
struct LightSummary {
    DrawCommand lists[LIST_COUNT];  // count: 6 for each quad, also beyond the capacity
    uint eyeInside[LIST_KINDS];     // layers over the eye of the casters in each list
    uint litTriangles;              // casting triangles whose front faces the light
    uint silhouetteEdges;           // edge records with m != 0 ...
    uint doubleEdges;               // ... of them those with |m| = 2
    uint lightCaps, darkCaps;       // triangles drawn as caps
};

struct LightData {
    vec4 position;   // view space; w = 1: point or spot, 0: direction towards a directional light
    vec4 direction;  // view space, the way a spot shines; w: 1 / range^2 or 0
    vec4 color;      // candela or lux; w: 0 when the light is off
    vec2 cone;       // spot: cosine scale and offset (KHR_lights_punctual); else (0, 1)
    vec2 unused;
};

// The eye, for every pass of a frame.
struct ViewData {
    mat4 clipFromView;
    vec4 rayScale;  // view ray of NDC (x, y): perspective (x*rs.x, y*rs.y, -1); orthographic offset (x*rs.x, y*rs.y)
    vec4 upInView;  // world +Y
    vec4 ambientSky, ambientGround, background;
    float znear, zfar;  // zfar 0: infinite
    uint perspective;
    uint lightCount;
    vec2 pixelSize;     // in NDC
    float emptyDepth;   // where nothing is seen: 0, or that of a perspective camera's zfar (T12)
    float capDistance;  // of the plane from which near-cap counts, along the view axis (shadow/ledge.h)
    float sceneDepths;  // what is seen has depths from 0 to this: 1 without a ledge
    float unusedView;
    vec2 shift;  // from a place on the picture to that of its view ray, in NDC
};

struct MaterialData {
    vec4 baseColor;
    vec4 emissive;    // w: alpha cutoff, negative: no alpha test
    vec4 factors;     // metallic, roughness, normal scale, occlusion strength
    vec4 uvRows[10];  // five textures, two rows each: (m00, m01, m02, texture coordinate set)
    uint textures;    // bit per texture present: base colour, metallic-roughness, normal, occlusion, emissive
    uint flags;
    uint entry;  // its place in the list of materials
    uint unused;
    vec4 unused2[2];  // to 256 bytes, where a range of a uniform buffer may begin on every device
};
#define MATERIAL_UNLIT 1u
#define TEXTURE_BASE_COLOR 0
#define TEXTURE_METALLIC_ROUGHNESS 1
#define TEXTURE_NORMAL 2
#define TEXTURE_OCCLUSION 3
#define TEXTURE_EMISSIVE 4
#define TEXTURE_COUNT 5

// What a draw of one primitive of one instance needs; found through gl_BaseInstance's attribute.
struct DrawData {
    uint instance, material;
    uint firstPlacedTriangle;  // NO_TRIANGLE for lines and points
    uint flags;
};
#define DRAW_HAS_NORMALS 1u
#define DRAW_HAS_TANGENTS 2u
#define DRAW_HAS_COLORS 4u

#ifdef __cplusplus
}  // namespace umbrage::gpu
#endif

#endif
