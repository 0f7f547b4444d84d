// SPDX-License-Identifier: Apache-2.0
// Shadow volumes cut by the plane from which near-cap counts (Kilgard 2001), in homogeneous view space, where a far
// corner is a direction: g(p) = -p.z - capDistance p.w is 0 in the plane and positive beyond it. A cut point depends only
// on the two corners it lies between, so sides and caps that share it have it bit for bit and close whatever rounding
// does. In double: a corner at a kilometre is cut millimetres before the eye.

struct Corner {
    dvec4 p;
    double g;
    vec4 clip;  // the same for depth and for uncut volumes
};

Corner cornerAt(dvec3 p, double w, vec4 clip) {
    precise double g = -p.z - double(view.capDistance) * w;
    return Corner(dvec4(p, w), g, clip);
}

vec4 onLedge(vec4 clip) { return vec4(clip.xy, (1.0 - LEDGE) * clip.z, clip.w); }

dvec3 viewFromModelInDouble(uint instance, vec4 model) {
    dvec4 p = dvec4(model);
    precise dvec3 v;
    for (int k = 0; k < 3; ++k) {
        dvec4 row = dvec4(instances[instance].viewFromModel[k]);
        v[k] = row.x * p.x + row.y * p.y + row.z * p.z + row.w * p.w;
    }
    return v;
}

Corner nearCut(uint instance, vec3 p) {
    return cornerAt(viewFromModelInDouble(instance, vec4(p, 1.0)), 1.0lf, onLedge(nearCorner(instance, p)));
}

/// Differences of view space: rounding keeps their order, so no side is cut more than twice.
Corner farCut(Corner near, dvec3 lightInView, float lightW) {
    precise dvec3 direction = near.p.xyz * double(lightW) - lightInView;
    return cornerAt(direction, 0.0lf, onLedge(clipFromView(vec3(direction), 0.0)));
}

bool isBeyond(Corner corner) { return corner.g >= 0.0lf; }

/// Where the line between two corners, one of them beyond the plane, passes through it. With both at infinity that is a
/// direction in the plane: Kilgard's vertices with w = 0.
vec4 clipOfCut(Corner one, Corner other) {
    Corner beyond = isBeyond(one) ? one : other, before = isBeyond(one) ? other : one;
    precise double scale = 1.0lf / (beyond.g - before.g);
    precise dvec4 p = (before.p * beyond.g - beyond.p * before.g) * scale;
    precise float z = -view.capDistance * float(p.w);
    return onLedge(clipFromView(vec3(p.xy, z), float(p.w)));
}
