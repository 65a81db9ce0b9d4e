// SPDX-License-Identifier: MIT
// Depth of the image's surfaces in a depth buffer of the host's. HOST_DEPTH: the unit of the texture that has the
// distances along the camera's z, infinite without a surface.

layout(binding = HOST_DEPTH) uniform sampler2D distances;
uniform int distance_component;
uniform bool orthographic;   // whether depth is linear in the distance
uniform vec2 depth_mapping;  // depth = x + y * distance, or x + y / distance in perspective

float host_depth(ivec2 at) {
    float d = texelFetch(distances, at, 0)[distance_component];
    return clamp(depth_mapping.x + depth_mapping.y * (orthographic ? d : 1.0 / d), 0.0, 1.0);
}
