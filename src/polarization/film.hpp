// SPDX-License-Identifier: MIT
// Interference in a thin film between two media.
#pragma once

#include <complex>

#include "polarization/fresnel.hpp"

namespace nicol {

/// Thin film on an interface. Thickness and wavelength are in the same unit. The index n - ik and the index
/// of the medium behind the film are relative to the medium in front, as is the wavelength.
struct ThinFilm {
    double thickness;
    std::complex<double> eta;
};

/// Optical element that acts on the s and p parts of light, in frames with x along the s-axis and z along the
/// propagation: power factors for both, and for their correlation |J_s J_p| e^{id} with d = arg J_p - arg
/// J_s.
struct SpShares {
    double s = 0;
    double p = 0;
    std::complex<double> correlation;

    SpShares& operator+=(const SpShares& other);
    /// Elements of this kind commute.
    friend SpShares operator*(const SpShares& a, const SpShares& b) {
        return {a.s * b.s, a.p * b.p, a.correlation * b.correlation};
    }
    friend SpShares operator*(double scale, const SpShares& of) {
        return {scale * of.s, scale * of.p, scale * of.correlation};
    }
};
[[nodiscard]] SpShares operator+(SpShares a, const SpShares& b);

/// Returns the block of the element's Mueller matrix, in which c + id is the correlation.
[[nodiscard]] ReflectionBlock<double> block_of(const SpShares& shares);
[[nodiscard]] inline Mueller mueller_of(const SpShares& shares) {
    return mueller_of(block_of(shares));
}

/// Light that an interface with a film reflects and transmits. The transmission includes the power factor
/// of refraction, as fresnel_transmission(), and is equal in both directions.
struct FilmSplit {
    SpShares front;         ///< reflection of light from the front
    SpShares back;          ///< reflection of light from behind
    SpShares transmission;  ///< zero if the light cannot propagate in both media
};

/// Returns what an interface reflects and transmits: Airy's sum over all reflections inside the film, with
/// their phases, for s and p apart. `tangential2` is the square of the sine of the angle in front; above 1,
/// light from behind is reflected totally, and the `front` is not defined. `eta` is the relative index n - ik
/// of the medium behind; `back` and `transmission` are defined if it is real. The film's phase is that at a
/// wavelength in the medium in front.
[[nodiscard]] FilmSplit film_split(double tangential2, std::complex<double> eta, const ThinFilm& film,
                                   double wavelength);

/// Returns what a slab reflects and transmits whose two sides are this interface, with all reflections inside
/// the slab summed without interference.
[[nodiscard]] FilmSplit slab_of(const FilmSplit& side);

}  // namespace nicol
