// SPDX-License-Identifier: MIT
// Terms of materials whose reflection of distant light is sampled, because tables of harmonics cannot hold
// it.
#pragma once

#include <functional>

#include "material/material.hpp"

namespace nicol {

/// Narrowest lobe, in radians, of which order 64 leaves no more than a few hundredths out.
inline constexpr double kNarrowestLobe = 0.1;

/// Terms whose reflection of distant light is the mean over samples of their lobes. All other terms reflect
/// the light's harmonics.
struct SampledTerms {
    enum class Kind {
        none,
        smooth,              ///< terms that replace a smooth surface, whose surroundings rays find
        anisotropic,         ///< terms whose lobes differ along x and along y
        anisotropic_narrow,  ///< these, and terms with lobes narrower than `narrowest`
    };
    using enum Kind;

    Kind kind = Kind::none;
    double narrowest = kNarrowestLobe;  ///< width of the narrowest lobes in harmonics, in radians

    // Each kind is the set of terms of that kind with the usual width.
    constexpr SampledTerms(Kind of) : kind(of) {}  // NOLINT(google-explicit-constructor)
    constexpr SampledTerms(Kind of, double width) : kind(of), narrowest(width) {}
    bool operator==(const SampledTerms&) const = default;
};

/// Returns whether a term of a material without variation() is sampled.
[[nodiscard]] bool is_sampled(const Material& material, int term, SampledTerms sampled);
/// Returns whether any term of a material, or of the materials that it varies between, is sampled.
[[nodiscard]] bool any_sampled(const Material& material, SampledTerms sampled);
/// Returns whether a sampled lobe is so narrow in all directions that its samples find extracted lights, too.
[[nodiscard]] bool finds_lights(const Lobe& lobe, SampledTerms sampled);
/// Returns whether a term is sampled and its lobe finds extracted lights; all other terms are lit by samples
/// of these lights.
[[nodiscard]] bool finds_lights(const Material& material, int term, SampledTerms sampled);
/// Returns the terms of a material without variation() that `has` returns true for: the material itself if
/// there is no other term, and a black material if there is no such term.
[[nodiscard]] MaterialPtr some_terms(const MaterialPtr& material, const std::function<bool(int)>& has);
/// Returns the some_terms() that are not sampled, for tables of harmonics.
[[nodiscard]] MaterialPtr in_harmonics(const MaterialPtr& material, SampledTerms sampled);

}  // namespace nicol
