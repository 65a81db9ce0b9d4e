// SPDX-License-Identifier: MIT
#include "shading/lane_footprint.hpp"

#include <cstddef>

#include "polarization/view_geometry.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// The compiler's own vector type.
using Number [[gnu::vector_size(64)]] = float;

[[gnu::always_inline]] inline void find_all(const PixelSteps& steps, const LaneTextureAxes& axes,
                                            const LaneVectors& towards_viewer, TexturePoints& points) {
    const Number zero{}, one = zero + 1.0F;
    Vector3<Number> by_u, by_v, back;
    load_part(axes.by_u, 0, by_u);
    load_part(axes.by_v, 0, by_v);
    load_part(towards_viewer, 0, back);
    const Vector3<Number> normal = cross(by_u, by_v);
    Number squared;
    dot(normal, normal, squared);
    Number facing;
    dot(back, normal, facing);
    Number least;
    dot(back, back, least);
    least *= squared;
    square_root(least);
    least *= 1e-4F;
    const Number safe = facing < 0 ? -least : least;
    facing = (facing < 0 ? -facing : facing) > least ? facing : safe;
    Number distance = one;
    if (!steps.orthographic) {
        dot(back, components(steps.forward), distance);
        distance = -distance;
    }
    distance = least > 0 ? distance / squared : zero;
    facing = least > 0 ? 1.0F / facing : zero;

    // Texture coordinates grow along the plane by the slopes times `squared`; [0] is for u, [1] for v.
    const Vector3<Number> slopes[2] = {cross(by_v, normal), cross(normal, by_u)};
    const Vector3<float> moves[2] = {components(steps.right), components(steps.down)};
    std::array<Lanes, 2>* const out[2] = {&points.du, &points.dv};
    for (std::size_t m = 0; m < 2; ++m) {
        Number rise;
        dot(normal, moves[m], rise);
        rise *= facing;
        for (std::size_t k = 0; k < 2; ++k) {
            Number along, change;
            dot(slopes[k], back, along);
            dot(slopes[k], moves[m], change);
            store(&(*out[m])[k], distance * (change - rise * along));
        }
    }
}

}  // namespace

void find_footprints(const PixelSteps& steps, const LaneTextureAxes& axes, const LaneVectors& towards_viewer,
                     TexturePoints& points) {
    dispatch<find_all>(steps, axes, towards_viewer, points);
}

}  // namespace nicol
