// SPDX-License-Identifier: MIT
// Checks that material models share.
#pragma once

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

namespace nicol {

/// Throws Error(invalid_argument) if there is no value or one is outside 0..1.
void check_reflectance(const std::vector<double>& values, std::string_view name);

/// Throws Error(invalid_argument) unless low <= value <= high (so never for NaN).
void check_range(double value, double low, double high, std::string_view name);

/// Throws Error(invalid_argument) unless both parameters have equally many values or one has a single one.
void check_channels(std::size_t a, std::string_view a_name, std::size_t b, std::string_view b_name);

/// Throws Error(invalid_argument) if PplasticParameters or PlasticParameters are out of range.
template <class Parameters>
void check_plastic(const Parameters& p) {
    check_reflectance(p.diffuse_reflectance.values, "diffuse_reflectance");
    check_reflectance(p.specular_reflectance.values, "specular_reflectance");
    check_range(p.int_ior, 1e-3, 1e3, "int_ior");
    check_range(p.ext_ior, 1e-3, 1e3, "ext_ior");
    check_range(p.alpha.value, 0.001, 1, "alpha");
    check_channels(p.diffuse_reflectance.values.size(), "diffuse_reflectance",
                   p.specular_reflectance.values.size(), "specular_reflectance");
}

/// Returns whether all values are 0.
[[nodiscard]] inline bool black(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return value == 0; });
}

/// Returns the value of a channel; a single value stands for every channel.
[[nodiscard]] inline double of_channel(const std::vector<double>& values, int channel) {
    return values.size() == 1 ? values.front() : values.at(static_cast<std::size_t>(channel));
}

/// Returns the mean over the channels.
[[nodiscard]] inline double mean_factor(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace nicol
