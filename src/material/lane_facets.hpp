// SPDX-License-Identifier: MIT
// Reflection off microfacets at sixteen pairs of directions: microfacet.hpp in single precision.
#pragma once

#include <cstddef>
#include <numbers>

#include "material/frames.hpp"
#include "material/lane_mueller.hpp"
#include "material/material.hpp"
#include "polarization/lane_points.hpp"
#include "simd/lane_exponential.hpp"
#include "simd/lane_parts.hpp"

namespace nicol {

/// Facets of a distribution, whose roughness along y may be another than along x.
struct LaneFacets {
    Distribution distribution;
    float alpha;
    float alpha_y = alpha;
};

/// facet_visibility() over the cosine, which stays finite at the horizon.
template <class Number>
[[gnu::always_inline]] inline void visibility_over_cosine(const LaneFacets& facets,
                                                          const Vector3<Number>& direction, Number& out) {
    const Number x = facets.alpha * direction.x;
    const Number y = facets.alpha_y * direction.y;
    const Number slope2 = x * x + y * y;
    const Number& z = direction.z;
    if (facets.distribution == Distribution::ggx) {
        Number root = z * z + slope2;
        square_root(root);
        out = 2.0F / (z + root);
        return;
    }
    Number slope = slope2;
    square_root(slope);
    const Number inverse = 1.0F / (slope > 1e-18F ? slope : Number{} + 1e-18F);
    const Number a = z * inverse;
    const auto few_hidden = a < 1.6F;
    out = (few_hidden ? (3.535F + 2.181F * a) * inverse : Number{} + 1.0F) /
          (few_hidden ? 1.0F + 2.276F * a + 2.577F * a * a : z);
}

/// facet_density() of the half vector, which has any length, with the square of that.
template <class Number>
[[gnu::always_inline]] inline void density(const LaneFacets& facets, const Vector3<Number>& half,
                                           const Number& length2, Number& out) {
    const float scale = 1 / (std::numbers::pi_v<float> * facets.alpha * facets.alpha_y);
    const Number x = (1 / facets.alpha) * half.x;
    const Number y = (1 / facets.alpha_y) * half.y;
    const Number slope2 = x * x + y * y;
    if (facets.distribution == Distribution::ggx) {
        const Number ratio = length2 / (half.z * half.z + slope2);
        out = scale * ratio * ratio;
        return;
    }
    // Few facets are so steep that this limits them, and numbers that would soon be denormal, which slow
    // processors down, are 0.
    const Number least = 1e-9F * length2;
    const Number z2 = half.z * half.z;
    const Number inverse = 1.0F / (z2 > least ? z2 : least);
    const Number power = -slope2 * inverse;
    const auto some = power > -60.0F;
    Number fraction = some ? power : Number{};
    exponential(fraction);
    const Number secant2 = length2 * inverse;
    out = some ? scale * secant2 * secant2 * fraction : Number{};
}

/// What reflection off facets of every index shares.
template <class Number>
struct LaneFacetReflection {
    Number scale;   ///< facet_reflection(), 0 where a direction lies below the horizon
    Number cosine;  ///< of the angle to the facets' normal
    SurfaceRotations<Number> rotations;
};

template <class Number>
[[gnu::always_inline]] inline LaneFacetReflection<Number> facet_reflection(const LaneFacets& facets,
                                                                           const Vector3<Number>& light,
                                                                           const Vector3<Number>& viewer) {
    const Vector3<Number> half{light.x + viewer.x, light.y + viewer.y, light.z + viewer.z};
    Number length2;
    dot(half, half, length2);
    length2 = length2 > 1e-18F ? length2 : Number{} + 1e-18F;
    LaneFacetReflection<Number> out;
    Number length = length2;
    square_root(length);
    dot(viewer, half, out.cosine);
    out.cosine /= length;
    out.cosine = out.cosine > 0.0F ? out.cosine : Number{};
    out.cosine = out.cosine < 1.0F ? out.cosine : Number{} + 1.0F;

    Number from_light;
    Number to_viewer;
    visibility_over_cosine(facets, light, from_light);
    visibility_over_cosine(facets, viewer, to_viewer);
    density(facets, half, length2, out.scale);
    out.scale *= 0.25F * from_light * to_viewer;
    const auto above = (light.z > 0.0F) & (viewer.z > 0.0F);
    out.scale = above ? out.scale : Number{};
    out.rotations = rotations_from_s_frames(light, viewer);
    return out;
}

/// in_rotated_frames() of the block: all columns, or the first alone, from lane `first` on.
template <class Number>
[[gnu::always_inline]] inline void store_reflection(const LaneFacetReflection<Number>& facet,
                                                    const ReflectionBlock<Number>& block, std::size_t columns,
                                                    std::size_t first, LaneMueller& out) {
    in_rotated_frames(
        facet.scale, block, facet.rotations,
        columns, [&](std::size_t i, const Number& element) __attribute__((always_inline)) {
            store_part<Number>(element, first, out.m[i]);
        });
}

}  // namespace nicol
