// SPDX-License-Identifier: MIT
#include <algorithm>
#include <span>
#include <string>

#include "error.hpp"
#include "import/scene_color.hpp"
#include "material/spectrum_weights.hpp"

namespace nicol {
namespace {

struct Table {
    std::vector<double> wavelengths;
    std::vector<double> values;

    void add(double wavelength, double value) {
        wavelengths.push_back(wavelength);
        values.push_back(value);
    }

    [[nodiscard]] std::vector<double> weighted(const ChannelWeights& weights) const {
        std::vector<double> out;
        for (const std::vector<double>& channel : weights) {
            double sum = 0;
            for (std::size_t k = 0; k < values.size(); ++k) sum += channel[k] * values[k];
            out.push_back(sum);
        }
        return out;
    }
};

Table table_of(const ColorDescription& color) {
    Table table;
    for (const auto& [wavelength, value] : color.spectrum) table.add(wavelength, value);
    return table;
}

// With a step to 0 at either end, narrower than any sampling resolves.
Table ending_in_zeros(const ColorDescription& color) {
    constexpr double step = 1e-6;
    Table table;
    table.add(color.spectrum.front().wavelength - step, 0);
    for (const auto& [wavelength, value] : color.spectrum) table.add(wavelength, value);
    table.add(color.spectrum.back().wavelength + step, 0);
    return table;
}

std::vector<double> values_of(const glm::dvec3& rgb, const SceneChannels& channels) {
    const bool grey = rgb.x == rgb.y && rgb.y == rgb.z;
    if (grey && (channels.one_for_grey || !channels.rgb())) return {rgb.x};
    if (channels.rgb()) return {rgb.x, rgb.y, rgb.z};
    throw Error(
        ErrorCode::unsupported,
        "a colour of red, green and blue under light of " + std::to_string(channels.count) +
            " other channels; give a grey one, or a <spectrum> table where the light has wavelengths");
}

void require_wavelengths(const SceneChannels& channels) {
    if (!channels.wavelengths.empty()) return;
    throw Error(ErrorCode::unsupported, "a <spectrum> table under light of " +
                                            std::to_string(channels.count) +
                                            " channels without wavelengths; give one grey value");
}

std::vector<double> as_emitted(const Table& table) {
    return table.weighted(rgb_emission_weights(table.wavelengths));
}

// Returns a table whose value is the same at all visible wavelengths.
Table constant_table(double value) {
    Table table;
    table.add(300, value);
    table.add(900, value);
    return table;
}

std::vector<double> clipped(std::vector<double> values, double most) {
    for (double& value : values) value = std::clamp(value, 0.0, most);
    return values;
}

}  // namespace

std::vector<double> reflectance(const ColorDescription& color, const SceneChannels& channels) {
    if (color.spectrum.empty()) return values_of(color.rgb, channels);
    const Table table = ending_in_zeros(color);
    if (channels.rgb()) return clipped(table.weighted(rgb_weights(table.wavelengths)), 1);
    require_wavelengths(channels);
    return table.weighted(linear_weights(table.wavelengths, channels.wavelengths));
}

std::vector<double> radiance(const ColorDescription& color, const SceneChannels& channels) {
    if (color.equal_energy && channels.rgb()) return as_emitted(constant_table(color.rgb.x));
    if (color.spectrum.empty()) return values_of(color.rgb, channels);
    const Table table = ending_in_zeros(color);
    if (channels.rgb()) return clipped(as_emitted(table), std::numeric_limits<double>::max());
    require_wavelengths(channels);
    return table.weighted(linear_weights(table.wavelengths, channels.wavelengths));
}

std::vector<double> refractive_index(const ColorDescription& color, const SceneChannels& channels) {
    if (color.spectrum.empty()) return values_of(color.rgb, channels);
    if (channels.rgb()) {
        const Table ends = ending_in_zeros(color);
        return clipped(ends.weighted(rgb_weights(ends.wavelengths)), 100);
    }
    const Table table = table_of(color);
    require_wavelengths(channels);
    return table.weighted(linear_weights(table.wavelengths, channels.wavelengths));
}

FilmParameters film_in(FilmParameters film, const SceneChannels& channels) {
    if (!film.present() || channels.rgb()) return film;
    require_wavelengths(channels);
    film.wavelengths = channels.wavelengths;
    return film;
}

}  // namespace nicol
