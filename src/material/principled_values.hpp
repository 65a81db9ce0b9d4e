// SPDX-License-Identifier: MIT
// Values of the lobes of principled_lobes.hpp, written once for single numbers and for vectors of lanes.
#pragma once

#include <cmath>
#include <numbers>

#include "material/microfacet.hpp"
#include "material/principled_lobes.hpp"

namespace nicol {

/// Constants of a PrincipledShape and constants derived from them. Real: float or double.
template <class Real>
struct PrincipledConstants {
    explicit PrincipledConstants(const PrincipledShape& k)
        : roughness(static_cast<Real>(k.roughness)),
          index(k.eta),
          refracts_away(!(k.eta > 1)),
          inverse_square(static_cast<Real>(1 / (k.eta * k.eta))),
          facets{Distribution::ggx, static_cast<Real>(k.alpha().x), static_cast<Real>(k.alpha().y)},
          normal_reflectance(static_cast<Real>(k.normal_reflectance())),
          coat_alpha2(static_cast<Real>(k.coat_alpha() * k.coat_alpha())),
          coat_scale((coat_alpha2 - 1) / (4 * std::numbers::pi_v<Real> * std::log(coat_alpha2))) {}

    Real roughness;
    RelativeIndex<Real> index;
    bool refracts_away;   ///< eta is at most 1, so light refracts away from the normal
    Real inverse_square;  ///< 1 / eta^2
    Facets<Real> facets;
    Real normal_reflectance;
    Real coat_alpha2;
    Real coat_scale;
};

/// Which lobes are computed.
struct WantedLobes {
    bool base;        ///< diffuse and subsurface
    bool facets;      ///< metal, edge, tinted
    bool dielectric;  ///< dielectric, of the same facets
    bool coat;        ///< clearcoat
};

/// Value of each lobe, by index(). Lobes that are not wanted are 0, except sheen.
template <class Number>
struct PrincipledValues {
    Number of[kPrincipledLobes];
};

template <class Number>
[[gnu::always_inline]] inline void to_fifth_power(Number& x) {
    const Number square = x * x;
    x *= square * square;
}

/// Computes Schlick's weight (1 - c)^5 of a direction, c the cosine of its angle to the normal.
template <class Number>
[[gnu::always_inline]] inline void schlick(const Vector3<Number>& direction, Number& weight) {
    const Number cosine = direction.z > 0.0F ? direction.z : Number{};
    weight = (direction.x * direction.x + direction.y * direction.y) / (1.0F + cosine);
    to_fifth_power(weight);
}

/// Returns the lobes, which are 0 if a direction lies below the horizon. Differences from 1 are computed
/// without cancellation.
template <class Number>
[[gnu::always_inline]] inline PrincipledValues<Number> principled_values(
    const PrincipledConstants<ScalarOf<Number>>& k, const WantedLobes& wanted, const Vector3<Number>& light,
    const Vector3<Number>& viewer) {
    constexpr ScalarOf<Number> inverse_pi = 1 / std::numbers::pi_v<ScalarOf<Number>>;
    // One condition, because GCC 12 does not vectorise two combined ones.
    const Number lower = light.z < viewer.z ? light.z : viewer.z;
    const auto above = lower > 0.0F;
    const Vector3<Number> half{light.x + viewer.x, light.y + viewer.y, light.z + viewer.z};
    const Vector3<Number> difference{light.x - viewer.x, light.y - viewer.y, light.z - viewer.z};
    Number length2;
    dot(half, half, length2);
    constexpr ScalarOf<Number> least = threshold<Number>(1e-18F, 1e-280);
    length2 = length2 > least ? length2 : Number{} + least;
    Number cosine = 0.25F * length2;
    square_root(cosine);
    cosine = cosine < 1.0F ? cosine : Number{} + 1.0F;
    Number sine2;
    dot(difference, difference, sine2);
    sine2 *= 0.25F;

    PrincipledValues<Number> out{};
    if (wanted.base) {
        Number in;
        Number from;
        schlick(light, in);
        schlick(viewer, from);
        const Number grazing = 2.0F * k.roughness * cosine * cosine;
        out.of[index(PrincipledLobe::diffuse)] =
            inverse_pi * ((1.0F - 0.5F * in) * (1.0F - 0.5F * from) +
                          grazing * (in + from + in * from * (grazing - 1.0F)));
        const Number inside = (1.0F + (0.5F * grazing - 1.0F) * in) * (1.0F + (0.5F * grazing - 1.0F) * from);
        out.of[index(PrincipledLobe::subsurface)] =
            1.25F * inverse_pi * (inside * (1.0F / (above ? half.z : Number{} + 1.0F) - 0.5F) + 0.5F);
    }
    Number w = sine2 / (1.0F + cosine);
    to_fifth_power(w);
    out.of[index(PrincipledLobe::sheen)] = w;

    if (k.refracts_away) {
        Number refracted2 = sine2 * k.inverse_square;
        refracted2 = refracted2 < 1.0F ? refracted2 : Number{} + 1.0F;
        Number refracted = 1.0F - refracted2;
        square_root(refracted);
        w = refracted2 / (1.0F + refracted);
        to_fifth_power(w);
    }
    Number from_light;
    Number to_viewer;
    if (wanted.facets || wanted.dielectric) {
        visibility_over_cosine(k.facets, light, from_light);
        visibility_over_cosine(k.facets, viewer, to_viewer);
        Number scale;
        density(k.facets, half, length2, scale);
        scale *= 0.25F * from_light * to_viewer;
        out.of[index(PrincipledLobe::metal)] = (1.0F - w) * scale;
        out.of[index(PrincipledLobe::edge)] = w * scale;
        out.of[index(PrincipledLobe::tinted)] = k.normal_reflectance * (1.0F - w) * scale;
        if (wanted.dielectric)
            out.of[index(PrincipledLobe::dielectric)] = dielectric_reflection(cosine, k.index).a * scale;
    }
    if (wanted.coat) {
        constexpr ScalarOf<Number> reflectance = constant<Number>(kCoatReflectance);
        constexpr Facets<ScalarOf<Number>> hidden{Distribution::ggx, constant<Number>(kCoatShadowing)};
        visibility_over_cosine(hidden, light, from_light);
        visibility_over_cosine(hidden, viewer, to_viewer);
        const Number rho2 = half.x * half.x + half.y * half.y;
        const Number coat = k.coat_scale * length2 / (rho2 + k.coat_alpha2 * half.z * half.z);
        out.of[index(PrincipledLobe::clearcoat)] =
            (reflectance + (1.0F - reflectance) * w) * coat * from_light * light.z * to_viewer * viewer.z;
    }
    for (Number& value : out.of) value = above ? value : Number{};
    return out;
}

}  // namespace nicol
