// SPDX-License-Identifier: MIT
// Depolarizing lobes that principled() mixes: Burley, "Physically Based Shading at Disney" (2012) and
// "Extending the Disney BRDF to a BSDF" (2015), in the form of Mitsuba 3.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "material/material.hpp"

namespace nicol {

/// Lobes with w = (1 - c)^5, c the cosine of the angle between viewer and half vector. Metal, edge, tinted
/// and dielectric are GGX facets times the factor given here.
enum class PrincipledLobe : std::size_t {
    sheen,       ///< w
    diffuse,     ///< Burley's diffuse lobe with retro-reflection; about 1 / pi
    subsurface,  ///< Burley's fit to Hanrahan and Krueger; about 1 / pi
    metal,       ///< 1 - w
    edge,        ///< w
    tinted,      ///< (1 - w) times a dielectric's reflectance at normal incidence
    dielectric,  ///< Fresnel's reflectance of a dielectric
    clearcoat    ///< a quarter of Berry's facets (GTR 1) under Schlick's factor of 0.04
};
inline constexpr std::size_t kPrincipledLobes = 8;
[[nodiscard]] constexpr std::size_t index(PrincipledLobe lobe) {
    return static_cast<std::size_t>(lobe);
}

/// Reflectance of the clearcoat at normal incidence, and the roughness that shadows its facets.
inline constexpr double kCoatReflectance = 0.04;
inline constexpr double kCoatShadowing = 0.25;

/// Numbers on which lobes depend nonlinearly. For eta below 1, w is at the refracted angle, but not in sheen.
struct PrincipledShape {
    double roughness = 0.5;      ///< diffuse, subsurface, facets
    double anisotropic = 0;      ///< facets
    double eta = 1.5;            ///< facets
    double clearcoat_gloss = 0;  ///< clearcoat

    /// Returns the roughness of the facets along x and along y.
    [[nodiscard]] glm::dvec2 alpha() const {
        const double aspect = std::sqrt(1 - 0.9 * anisotropic);
        return glm::max(roughness * roughness * glm::dvec2(1 / aspect, aspect), 0.001);
    }
    [[nodiscard]] double coat_alpha() const { return 0.1 - (0.1 - 0.001) * clearcoat_gloss; }
    /// Returns the reflectance of a dielectric at normal incidence.
    [[nodiscard]] double normal_reflectance() const {
        return (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
    }
};

/// Amounts of the lobes: `colored` is multiplied by the colour, `white` is the same in every channel.
struct PrincipledMix {
    std::array<double, kPrincipledLobes> colored{};
    std::array<double, kPrincipledLobes> white{};
};

/// Returns the sum of lobes; at least one amount must not be 0. `color`: one value, or one per channel.
[[nodiscard]] MaterialPtr principled_lobes(const PrincipledShape& shape, std::vector<double> color,
                                           const PrincipledMix& mix);

}  // namespace nicol
