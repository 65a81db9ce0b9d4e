// SPDX-License-Identifier: MIT
// Microfacet distributions and their shadowing, after Walter et al. 2007 and, for anisotropic roughness,
// Heitz 2014. Written once for single numbers and for vectors of lanes.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <numbers>

#include "material/frames.hpp"
#include "material/material.hpp"
#include "polarization/lane_points.hpp"
#include "simd/lane_exponential.hpp"
#include "simd/lane_parts.hpp"

namespace nicol {

/// Facets of a distribution with roughness alpha along x and alpha_y along y. Real: float or double.
template <class Real>
struct Facets {
    Distribution distribution;
    Real alpha;
    Real alpha_y = alpha;
};

/// Computes facet_visibility() divided by the cosine, which stays finite at the horizon. `direction` is a
/// unit vector above the horizon.
template <class Number>
[[gnu::always_inline]] inline void visibility_over_cosine(const Facets<ScalarOf<Number>>& facets,
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
    constexpr ScalarOf<Number> least = constant<Number>(1e-18);
    const Number inverse = 1.0F / (slope > least ? slope : Number{} + least);
    const Number a = z * inverse;
    const auto few_hidden = a < constant<Number>(1.6);
    out = (few_hidden ? (constant<Number>(3.535) + constant<Number>(2.181) * a) * inverse : Number{} + 1.0F) /
          (few_hidden ? 1.0F + constant<Number>(2.276) * a + constant<Number>(2.577) * a * a : z);
}

/// Computes facet_density() at a half vector of any length; length2 is the square of that length.
template <class Number>
[[gnu::always_inline]] inline void density(const Facets<ScalarOf<Number>>& facets,
                                           const Vector3<Number>& half, const Number& length2, Number& out) {
    const ScalarOf<Number> scale = 1 / (std::numbers::pi_v<ScalarOf<Number>> * facets.alpha * facets.alpha_y);
    const Number x = (1 / facets.alpha) * half.x;
    const Number y = (1 / facets.alpha_y) * half.y;
    const Number slope2 = x * x + y * y;
    if (facets.distribution == Distribution::ggx) {
        const Number ratio = length2 / (half.z * half.z + slope2);
        out = scale * ratio * ratio;
        return;
    }
    // The limit affects few facets, because few are so steep. Numbers that would soon be denormal become 0,
    // because denormal numbers slow processors down.
    const Number least = threshold<Number>(1e-9F, 1e-100) * length2;
    const Number z2 = half.z * half.z;
    const Number inverse = 1.0F / (z2 > least ? z2 : least);
    const Number power = -slope2 * inverse;
    const auto some = power > threshold<Number>(-60.0F, -700.0);
    Number fraction = some ? power : Number{};
    exponential(fraction);
    const Number secant2 = length2 * inverse;
    out = some ? scale * secant2 * secant2 * fraction : Number{};
}

/// Part of a reflection off facets that does not depend on the facets' index.
template <class Number>
struct FacetReflection {
    Number scale;   ///< D G / (4 cos cos), per steradian; 0 where a direction lies below the horizon
    Number cosine;  ///< cosine of the angle to the facets' normal
    SurfaceRotations<Number> rotations;
};

/// Returns the reflection off facets whose normal is the half vector of the unit vectors light and viewer.
template <class Number>
[[gnu::always_inline]] inline FacetReflection<Number> facet_reflection(const Facets<ScalarOf<Number>>& facets,
                                                                       const Vector3<Number>& light,
                                                                       const Vector3<Number>& viewer) {
    const Vector3<Number> half{light.x + viewer.x, light.y + viewer.y, light.z + viewer.z};
    Number length2;
    dot(half, half, length2);
    constexpr ScalarOf<Number> least = threshold<Number>(1e-18F, 1e-280);
    length2 = length2 > least ? length2 : Number{} + least;
    FacetReflection<Number> out;
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
    // One condition, because GCC 12 does not vectorise two combined ones.
    const Number lower = light.z < viewer.z ? light.z : viewer.z;
    out.scale = lower > 0.0F ? out.scale : Number{};
    out.rotations = rotations_from_s_frames(light, viewer);
    return out;
}

/// Stores in_rotated_frames() of the block from lane `first` on: all columns, or only the first column.
template <class Number>
[[gnu::always_inline]] inline void store_reflection(const FacetReflection<Number>& facet,
                                                    const ReflectionBlock<Number>& block, std::size_t columns,
                                                    std::size_t first, LaneMueller& out) {
    in_rotated_frames(
        facet.scale, block, facet.rotations,
        columns, [&](std::size_t i, const Number& element) __attribute__((always_inline)) {
            store_part<Number>(element, first, out.m[i]);
        });
}

/// Returns the density of facet normals, per steradian, at an angle to the macro normal given by its cosine;
/// the integral of D cos over the hemisphere is 1.
[[nodiscard]] double facet_density(Distribution distribution, double alpha, double cos_facet);
/// Returns the density of facets with roughness alpha.x along x and alpha.y along y at a unit normal.
[[nodiscard]] double facet_density(Distribution distribution, const glm::dvec2& alpha,
                                   const glm::dvec3& facet);

/// Returns the fraction of facets visible from a direction given by its cosine to the normal (Smith's G1); 0
/// at and below the horizon. Exact for GGX; Walter's rational fit for Beckmann, as in Mitsuba 3.
[[nodiscard]] double facet_visibility(Distribution distribution, double alpha, double cos_view);
/// Returns the visible fraction of facets with roughness alpha.x along x and alpha.y along y.
[[nodiscard]] double facet_visibility(Distribution distribution, const glm::dvec2& alpha,
                                      const glm::dvec3& view);

/// Samples the normal of a GGX facet that is visible from a unit direction above the horizon, with density
/// G1 D (view.facet) / view.z, after Dupuy and Benyoub 2023. point: in [0, 1)^2.
[[nodiscard]] glm::dvec3 visible_facet(const glm::dvec2& alpha, const glm::dvec3& view,
                                       const glm::dvec2& point);

}  // namespace nicol
