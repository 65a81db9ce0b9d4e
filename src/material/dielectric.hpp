// SPDX-License-Identifier: MIT
// Glass: materials that transmit light.
#pragma once

#include <string>
#include <vector>

#include "material/film.hpp"
#include "material/material.hpp"
#include "polarization/slab.hpp"

namespace nicol {

/// Boundary that splits light into a reflected and a transmitted part by Fresnel's formulas: smooth, or made
/// of facets that are smooth.
struct SmoothBoundary {
    /// Medium behind the front of the surface.
    enum class Behind {
        body,  ///< a body: the transmitted light is refracted
        slab,  ///< a thin slab and then the outside again: the transmitted light goes straight on
    };
    Behind behind = Behind::body;
    double eta = 1;                          ///< index of the inside relative to the outside
    std::vector<double> reflectance{1.0};    ///< factor of reflected light, one value or one per channel
    std::vector<double> transmittance{1.0};  ///< factor of transmitted light, as `reflectance`
    /// Absorption coefficient of the body per unit of length, as `reflectance`; 0 for a slab.
    std::vector<double> absorption{0.0};
    double alpha = 0;                                    ///< roughness, 0.001..1; 0: smooth
    Distribution distribution = Distribution::beckmann;  ///< distribution of the facets of a rough boundary
    /// Film on the boundary, or on both sides of a slab, made for `eta`; null: none.
    FilmTablePtr film = nullptr;

    [[nodiscard]] bool rough() const noexcept { return alpha > 0; }
    /// Returns whether light that passes changes its direction.
    [[nodiscard]] bool bends() const noexcept { return rough() || (behind == Behind::body && eta != 1); }
    /// Returns the number of channels; 1 if the boundary is equal in every channel.
    [[nodiscard]] int channels() const noexcept;
    /// Returns everything that the values depend on, as text.
    [[nodiscard]] std::string content_key() const;
};

/// Returns what a smooth boundary, or a facet, reflects and transmits of a channel's light, for light on a
/// ray at an angle given by its cosine, 0..1. inside: whether the ray lies inside the body. Both matrices
/// have the frames of SlabSplit. Without a film, all channels are equal.
[[nodiscard]] SlabSplit split_of(const SmoothBoundary& boundary, double cosine, bool inside, int channel);
/// Returns the mean of split_of() over the channels of the film.
[[nodiscard]] SlabSplit mean_split_of(const SmoothBoundary& boundary, double cosine, bool inside);

/// Returns the content_key() of the boundary that light passes, or an empty text if the material has none.
[[nodiscard]] std::string glass_key(const Material& material);

/// Parameters of Mitsuba 3's `dielectric`, `roughdielectric` and `thindielectric`, and of a body that absorbs
/// light.
struct DielectricParameters {
    ColorParameter specular_reflectance{1.0};    ///< 0..1
    ColorParameter specular_transmittance{1.0};  ///< 0..1
    double int_ior = 1.5046;                     ///< index of the inside, 0.001..1000
    double ext_ior = 1.000277;                   ///< index of the outside, 0.001..1000
    /// Absorption coefficient of the inside, per unit of length, finite and not negative: a path of length d
    /// transmits exp(-absorption d). One value or one per channel.
    std::vector<double> absorption{0.0};
    /// Roughness of facets, 0.001..1; 0: a smooth boundary. A texture is clamped to 0.01..1; the facets that
    /// transmit light have its mean.
    NumberParameter alpha = 0.0;
    Distribution distribution = Distribution::beckmann;
    FilmParameters film = {};  ///< film on the boundary, or on both sides of a slab
};
/// Returns the boundary between the inside of a body and the outside. Throws Error(invalid_argument) that
/// names the parameter out of range, and Error(unsupported) for a texture.
[[nodiscard]] MaterialPtr dielectric(const DielectricParameters& parameters);
/// Returns a slab so thin that light leaves it where it arrives. All reflections inside the slab are summed
/// without interference. Throws what dielectric() throws, and Error(invalid_argument) for an absorption,
/// because a slab has no thickness.
[[nodiscard]] MaterialPtr thin_dielectric(const DielectricParameters& parameters);

/// Returns what the front of a rough boundary reflects. alpha: roughness in place of the boundary's, of which
/// a slab takes the number alone. Throws what rough_conductor() throws, and Error(invalid_argument) for an
/// index out of range.
[[nodiscard]] MaterialPtr rough_reflection(const SmoothBoundary& boundary, const NumberParameter& alpha);
/// Returns a material that reflects like `reflection` on its front, and that transmits light through a rough
/// boundary, whose reflection on the front `reflection` stands for. Throws Error(invalid_argument) if the
/// boundary is smooth.
[[nodiscard]] MaterialPtr transmitting(MaterialPtr reflection, SmoothBoundary boundary);

}  // namespace nicol
