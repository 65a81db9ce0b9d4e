// SPDX-License-Identifier: MIT
// Interfaces with a thin film, for the channels of light.
#pragma once

#include <array>
#include <complex>
#include <memory>
#include <string>
#include <vector>

#include "polarization/film.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Largest thickness of a film, in nm.
inline constexpr double kThickestFilm = 10000;

/// Thin film on the interface of a material.
struct FilmParameters {
    double thickness = 0;  ///< nm, 0..kThickestFilm; 0: no film
    /// Index n - ik, one value or one per channel; n lies in 0.1..100, k in 0..100.
    std::vector<std::complex<double>> eta{{1.5, 0.0}};
    /// Wavelength of each channel, nm, 100..5000. Empty: red, green and blue.
    std::vector<double> wavelengths;

    [[nodiscard]] bool present() const noexcept { return thickness != 0; }
    [[nodiscard]] int channels() const noexcept {
        return wavelengths.empty() ? 3 : static_cast<int>(wavelengths.size());
    }
};

/// Throws Error(invalid_argument) that names the parameter of a film that is out of range.
void check_film(const FilmParameters& film);

/// Reflection and transmission of an interface with a film, tabulated over the angle. A channel of red, green
/// or blue has the mean over its response to the visible spectrum, rgb_weights(). The mean is clipped to
/// 0..1 for s and for p, because colours of films lie outside the gamut; its correlation of s and p is
/// clipped to what these allow, so that all Mueller matrices are physically possible. Immutable.
class FilmTable {
public:
    enum class Kind {
        interface,  ///< the interface itself
        slab,       ///< a slab with the film on both sides, see slab_of()
    };
    /// Makes the table of an interface. outside: index of the medium in front. inside: index n - ik of the
    /// medium behind, in the same unit, one value or one per channel. Only a single real index transmits
    /// light. Throws Error(invalid_argument) that names the parameter out of range.
    FilmTable(const FilmParameters& film, double outside, std::vector<std::complex<double>> inside,
              Kind kind = Kind::interface);

    [[nodiscard]] int channels() const noexcept { return static_cast<int>(tables_.size()); }
    /// Returns everything that the values depend on, as text.
    [[nodiscard]] const std::string& key() const noexcept { return key_; }

    /// Returns the reflection of light from the front at an angle given by its cosine, 0..1.
    [[nodiscard]] ReflectionBlock<double> reflection(int channel, double cosine) const;
    /// Computes reflection() of sixteen cosines in single precision.
    void reflection_lanes(int channel, const Lanes& cosines, ReflectionBlock<Lanes>& out) const;
    /// Returns both reflections and the transmission at an angle given by its cosine, 0..1, in front or, if
    /// `from_behind`, behind. Any channel is that of a table with a single one.
    [[nodiscard]] FilmSplit split(int channel, double cosine, bool from_behind) const;

private:
    /// Entries of one channel at even steps of a parameter.
    struct Channel {
        std::vector<FilmSplit> refracted;  ///< over the root of the cosine in the medium of lower index
        std::vector<FilmSplit> total;      ///< total reflection; empty if there is none
        std::vector<std::array<float, 4>> in_front;  ///< front of `refracted` as a, b, c, d
    };
    [[nodiscard]] std::vector<std::vector<FilmSplit>> tabulate(const FilmParameters& film, bool total,
                                                               std::size_t entries, Kind kind) const;

    double outside_;
    std::vector<std::complex<double>> eta_;  ///< relative indices of the medium behind
    double lower_ = 1;                       ///< lower of the relative indices of both media
    double excess_ = 0;                      ///< square of the higher index less that of the lower one
    std::string key_;
    std::vector<Channel> tables_;
};
using FilmTablePtr = std::shared_ptr<const FilmTable>;

/// Returns the table of a film; null if there is no film.
[[nodiscard]] FilmTablePtr film_table(const FilmParameters& film, double outside,
                                      std::vector<std::complex<double>> inside,
                                      FilmTable::Kind kind = FilmTable::Kind::interface);

}  // namespace nicol
