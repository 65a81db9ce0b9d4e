// SPDX-License-Identifier: MIT
// Colours of a scene file as one value per colour channel.
#pragma once

#include <vector>

#include "import/scene_description.hpp"
#include "material/film.hpp"

namespace nicol {

/// The meaning of a scene's colour channels: red, green and blue (three, no wavelengths), wavelengths in nm,
/// or unknown.
struct SceneChannels {
    int count = 3;
    std::vector<double> wavelengths;  ///< empty, or one per channel
    /// Whether grey has one value also among colours of red, green and blue: for a film of one channel, so
    /// that images of a scene without colours have one channel from the beginning.
    bool one_for_grey = false;

    [[nodiscard]] bool rgb() const noexcept { return count == 3 && wavelengths.empty(); }
};

// These functions return the values of a colour: three for red, green and blue, one per wavelength, or one
// for grey. A table is linear between its wavelengths and, as in Mitsuba, 0 beyond them; for channels with
// wavelengths, the table of an index is constant beyond its ends. For red, green and blue
// - a reflectance or an index is observed under D65 (rgb_weights()), so that a constant table is grey;
//   reflectances are clipped to 0..1, indices to 0..100;
// - light is observed as it is (rgb_emission_weights()), as in Mitsuba's modes without spectra: a constant
//   table, and one value as a <spectrum>, are white of equal energy, a little redder than D65. Values below 0
//   are clipped.
// They throw Error(unsupported) for a colour that the channels cannot have: red, green and blue that differ,
// for other channels; a table, for channels of unknown meaning.

[[nodiscard]] std::vector<double> reflectance(const ColorDescription& color, const SceneChannels& channels);
[[nodiscard]] std::vector<double> radiance(const ColorDescription& color, const SceneChannels& channels);
[[nodiscard]] std::vector<double> refractive_index(const ColorDescription& color,
                                                   const SceneChannels& channels);

/// Returns a film at the wavelengths of the channels. Throws Error(unsupported) for channels of unknown
/// meaning.
[[nodiscard]] FilmParameters film_in(FilmParameters film, const SceneChannels& channels);

}  // namespace nicol
