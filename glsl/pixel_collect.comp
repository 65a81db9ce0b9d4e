// SPDX-License-Identifier: MIT
// The shade step at pixels: counts (or with LISTING lists) the points that pixels show. Samples of triangles
// that share a corner belong to one smooth surface; a surface has one point, at the mean of its samples. One
// invocation per pixel.
#version 450 core

// SAMPLES: samples per pixel.
#include "hits.glsl"
#include "pixel_points.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Corners { uint corners[]; };  // three per triangle
layout(std430, binding = 1) readonly buffer Groups { uint groups[]; };    // shading group of each triangle
layout(std430, binding = 2) readonly buffer Offsets { vec2 offsets[]; };  // samples from the pixel's centre
layout(binding = 0) uniform usampler2D hits[SAMPLES];

uniform int first;  // first pixel
uniform int count;
uniform int width;

#ifdef LISTING
layout(std430, binding = 3) buffer Places { uint places[]; };  // by group, place of its next point
layout(std430, binding = 4) writeonly buffer Points { PixelPoint points[]; };
layout(std430, binding = 5) writeonly buffer Shares { uint shares[]; };  // in the layout of pixel_gather.comp
#else
layout(std430, binding = 3) buffer Counts { uint counts[]; };  // [block of pixels][group]
layout(binding = 0, r32f) writeonly uniform image2D coverage;

uniform int block;        // pixels per block
uniform int group_count;
#endif

bool share_corner(uint a, uint b) {
    for (uint i = 3u * a; i < 3u * a + 3u; ++i)
        for (uint j = 3u * b; j < 3u * b + 3u; ++j)
            if (corners[i] == corners[j]) return true;
    return false;
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= count) return;
    int pixel = first + i;
    ivec2 texel = ivec2(pixel % width, pixel / width);

    uint triangles[SAMPLES];
    int surface_of[SAMPLES];   // surface of each sample, or -1
    uint latest[SAMPLES];      // latest triangle of each surface
    int surfaces = 0;
    int covered = 0;
    for (int s = 0; s < SAMPLES; ++s) {
        Hit hit = hit_of(texelFetch(hits[s], texel, 0).x);
        surface_of[s] = -1;
        triangles[s] = hit.triangle;
        if (hit.exists) ++covered;
        if (!hit.exists || !hit.front) continue;
        int found = 0;
        while (found < surfaces && latest[found] != hit.triangle && !share_corner(latest[found], hit.triangle)) ++found;
        if (found == surfaces) ++surfaces;
        latest[found] = hit.triangle;
        surface_of[s] = found;
    }
#ifndef LISTING
    imageStore(coverage, texel, vec4(float(covered) / float(SAMPLES)));
#endif

    for (int p = 0; p < surfaces; ++p) {
        vec2 sum = vec2(0.0);
        int of_surface = 0;
        for (int s = 0; s < SAMPLES; ++s) {
            if (surface_of[s] != p) continue;
            sum += offsets[s];
            ++of_surface;
        }
        // The mean may lie between triangles, so the nearest sample's triangle represents the surface.
        int nearest = -1;
        float least = 0.0;
        for (int s = 0; s < SAMPLES; ++s) {
            if (surface_of[s] != p) continue;
            vec2 away = float(of_surface) * offsets[s] - sum;
            float distance2 = dot(away, away);
            if (nearest >= 0 && distance2 >= least) continue;
            nearest = s;
            least = distance2;
        }
        uint triangle = triangles[nearest];
        uint group = groups[triangle];
#ifdef LISTING
        uint place = atomicAdd(places[group], 1u);
        points[place] = PixelPoint(triangle, uint(pixel), sum / float(of_surface));
        shares[i * SAMPLES + p] = place << 4 | uint(of_surface);
#else
        atomicAdd(counts[pixel / block * group_count + int(group)], 1u);
#endif
    }
#ifdef LISTING
    if (surfaces < SAMPLES) shares[i * SAMPLES + surfaces] = 0u;
#endif
}
