// SPDX-License-Identifier: MIT
// Checks that material models share.
#pragma once

#include <string_view>
#include <vector>

namespace nicol {

/// Throws Error(invalid_argument) if there is no value or one is outside 0..1.
void check_reflectance(const std::vector<double>& values, std::string_view name);

/// Throws Error(invalid_argument) unless low <= value <= high (so never for NaN).
void check_range(double value, double low, double high, std::string_view name);

/// Throws Error(invalid_argument) unless both parameters have equally many values or one has a single one.
void check_channels(std::size_t a, std::string_view a_name, std::size_t b, std::string_view b_name);

/// One value stands for every channel.
[[nodiscard]] inline double of_channel(const std::vector<double>& values, int channel) {
    return values.size() == 1 ? values.front() : values.at(static_cast<std::size_t>(channel));
}

}  // namespace nicol
