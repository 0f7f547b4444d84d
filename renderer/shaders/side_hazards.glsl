// SPDX-License-Identifier: Apache-2.0
// Where a side quad lies to the eye: decided once an edge and light, by the sweep over the edges.
/// An end of the view rays (the eye, or for an orthographic eye a direction, w = 0) within the wedge of a side quad, to
/// whose plane it is near. The wedge is widened by 2^-6 in its own coordinates; outside it the quad is seen edge-on and
/// covers nothing.
bool inWedge(vec4 eye, vec4 light, vec3 a, vec3 b) {
    vec3 e = eye.w == 0.0 ? eye.xyz : (light.w == 0.0 ? eye.xyz - a : eye.xyz - light.xyz);
    vec3 u = light.w == 0.0 ? b - a : a - light.xyz;
    vec3 v = light.w == 0.0 ? -light.xyz : b - light.xyz;
    vec3 n = cross(u, v);
    float squared = dot(n, n);
    const float kMargin = 0.015625;
    float alongU = dot(cross(e, v), n) / squared;  // e = alongU u + alongV v
    float alongV = dot(cross(u, e), n) / squared;
    if (eye.w == 0.0) {
        return alongU * length(u) > -kMargin * length(e) && alongV * length(v) > -kMargin * length(e);
    }
    if (light.w == 0.0) {
        return alongU > -kMargin && alongU < 1.0 + kMargin &&
               alongV * length(v) > -kMargin * (length(u) + length(e));
    }
    return alongU > -kMargin && alongV > -kMargin && alongU + alongV > 1.0 - kMargin;
}

/// T4: the start of the count so close to the quad that the rasteriser and the eye constant may disagree about the side
/// it is on.
bool hazardous(vec4 start, vec4 light, vec3 a, vec3 b) {
    if (start.w == 0.0 && light.w == 0.0) return false;  // such counts have no constant
    vec3 e = start.w == 0.0 ? start.xyz : (light.w == 0.0 ? start.xyz - a : start.xyz - light.xyz);
    vec3 n = light.w == 0.0 ? cross(b - a, -light.xyz) : cross(a - light.xyz, b - light.xyz);
    float scale = start.w == 0.0 ? length(e) : max(length(e), max(distance(start.xyz, a), distance(start.xyz, b)));
    return abs(dot(n, e)) < HAZARD * scale * length(n) && inWedge(start, light, a, b);
}

/// The side quad seen nearly edge-on, or its edge nearly along the light's rays: a sliver on screen.
bool isSliver(vec4 eye, vec4 light, vec3 a, vec3 b) {
    vec3 l = light.w == 0.0 ? light.xyz : light.xyz - a;
    vec3 e = eye.w == 0.0 ? eye.xyz : eye.xyz - a;
    return abs(dot(cross(b - a, l), e)) < EDGE_ON_SINE * length(b - a) * length(l) * length(e);
}

/// The view rays' other end, from which the count does not start, in the quad: it is seen edge-on and covers nothing,
/// but passes through the one point without a place on screen (x = y = w = 0), where clippers go astray.
bool endsInQuad(vec4 end, vec4 light, vec3 a, vec3 b) {
    if (end.w == 0.0 && light.w == 0.0) return false;
    vec3 n = cross(b - a, light.w == 0.0 ? light.xyz : light.xyz - a);
    vec3 e = end.w == 0.0 ? end.xyz : end.xyz - a;
    return abs(dot(n, e)) < IN_LINE_SINE * length(n) * length(e) && inWedge(end, light, a, b);
}
