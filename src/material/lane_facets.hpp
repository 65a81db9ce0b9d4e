// SPDX-License-Identifier: MIT
// Reflection off microfacets at sixteen pairs of directions: microfacet.hpp in single precision.
#pragma once

#include <cstddef>
#include <numbers>

#include "material/lane_frames.hpp"
#include "material/lane_fresnel.hpp"
#include "material/lane_mueller.hpp"
#include "material/material.hpp"
#include "polarization/lane_points.hpp"
#include "simd/lane_exponential.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {

/// Sixteen floats in registers.
using LaneNumber [[gnu::vector_size(64)]] = float;

[[gnu::always_inline]] inline Vector3<LaneNumber> load(const LaneVectors& from) {
    Vector3<LaneNumber> to;
    load(&from.x, to.x);
    load(&from.y, to.y);
    load(&from.z, to.z);
    return to;
}

/// Facets of a distribution.
struct LaneFacets {
    Distribution distribution;
    float alpha;
};

/// facet_visibility() over the cosine, which stays finite at the horizon.
[[gnu::always_inline]] inline void visibility_over_cosine(const LaneFacets& facets,
                                                          const Vector3<LaneNumber>& direction,
                                                          LaneNumber& out) {
    const LaneNumber rho2 = direction.x * direction.x + direction.y * direction.y;
    const LaneNumber& z = direction.z;
    if (facets.distribution == Distribution::ggx) {
        LaneNumber root = z * z + facets.alpha * facets.alpha * rho2;
        square_root(root);
        out = 2.0F / (z + root);
        return;
    }
    LaneNumber slope = rho2;
    square_root(slope);
    slope *= facets.alpha;
    const LaneNumber inverse = 1.0F / (slope > 1e-18F ? slope : LaneNumber{} + 1e-18F);
    const LaneNumber a = z * inverse;
    const auto few_hidden = a < 1.6F;
    out = (few_hidden ? (3.535F + 2.181F * a) * inverse : LaneNumber{} + 1.0F) /
          (few_hidden ? 1.0F + 2.276F * a + 2.577F * a * a : z);
}

/// facet_density() of the half vector, which has any length, with the square of that.
[[gnu::always_inline]] inline void density(const LaneFacets& facets, const Vector3<LaneNumber>& half,
                                           const LaneNumber& length2, LaneNumber& out) {
    const float alpha2 = facets.alpha * facets.alpha;
    const float scale = 1 / (std::numbers::pi_v<float> * alpha2);
    const LaneNumber rho2 = half.x * half.x + half.y * half.y;
    if (facets.distribution == Distribution::ggx) {
        const LaneNumber ratio = length2 / (half.z * half.z + rho2 / alpha2);
        out = scale * ratio * ratio;
        return;
    }
    // No facet is as steep as where this is limited.
    const LaneNumber least = 1e-9F * length2;
    const LaneNumber z2 = half.z * half.z;
    const LaneNumber inverse = 1.0F / (z2 > least ? z2 : least);
    LaneNumber power = -rho2 * inverse / alpha2;
    power = power > -87.0F ? power : LaneNumber{} - 87.0F;
    exponential(power);
    const LaneNumber secant2 = length2 * inverse;
    out = scale * secant2 * secant2 * power;
}

/// What reflection off facets of every index shares.
struct LaneFacetReflection {
    LaneNumber scale;   ///< facet_reflection(), 0 where a direction lies below the horizon
    LaneNumber cosine;  ///< of the angle to the facets' normal
    LaneRotations<LaneNumber> rotations;
};

[[gnu::always_inline]] inline LaneFacetReflection facet_reflection(const LaneFacets& facets,
                                                                   const Vector3<LaneNumber>& light,
                                                                   const Vector3<LaneNumber>& viewer) {
    const Vector3<LaneNumber> half{light.x + viewer.x, light.y + viewer.y, light.z + viewer.z};
    LaneNumber length2;
    dot(half, half, length2);
    length2 = length2 > 1e-18F ? length2 : LaneNumber{} + 1e-18F;
    LaneFacetReflection out;
    LaneNumber length = length2;
    square_root(length);
    dot(viewer, half, out.cosine);
    out.cosine /= length;
    out.cosine = out.cosine > 0.0F ? out.cosine : LaneNumber{};
    out.cosine = out.cosine < 1.0F ? out.cosine : LaneNumber{} + 1.0F;

    LaneNumber from_light;
    LaneNumber to_viewer;
    visibility_over_cosine(facets, light, from_light);
    visibility_over_cosine(facets, viewer, to_viewer);
    density(facets, half, length2, out.scale);
    out.scale *= 0.25F * from_light * to_viewer;
    const auto above = (light.z > 0.0F) & (viewer.z > 0.0F);
    out.scale = above ? out.scale : LaneNumber{};
    out.rotations = lane_rotations(light, viewer);
    return out;
}

/// in_rotated_frames() of the block: all columns, or the first alone.
[[gnu::always_inline]] inline void store_reflection(const LaneFacetReflection& facet,
                                                    const LaneReflection<LaneNumber>& block,
                                                    std::size_t columns, LaneMueller& out) {
    const LaneNumber a = facet.scale * block.a;
    const LaneNumber b = facet.scale * block.b;
    const auto& [ci, si, co, so] = facet.rotations;
    store(&out.m[0], a);
    store(&out.m[4], co * b);
    store(&out.m[8], -so * b);
    store(&out.m[12], LaneNumber{});
    if (columns == 1) return;
    const LaneNumber c = facet.scale * block.c;
    const LaneNumber d = facet.scale * block.d;
    store(&out.m[1], b * ci);
    store(&out.m[2], -b * si);
    store(&out.m[3], LaneNumber{});
    store(&out.m[5], co * ci * a + so * si * c);
    store(&out.m[6], so * ci * c - co * si * a);
    store(&out.m[7], -so * d);
    store(&out.m[9], co * si * c - so * ci * a);
    store(&out.m[10], co * ci * c + so * si * a);
    store(&out.m[11], -co * d);
    store(&out.m[13], d * si);
    store(&out.m[14], d * ci);
    store(&out.m[15], c);
}

}  // namespace nicol
