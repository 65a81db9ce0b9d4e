// SPDX-License-Identifier: MIT
// Colours of scene files, as plain data.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace nicol {

/// A value for each colour: three of linear RGB, or a table over the wavelength.
struct ColorDescription {
    struct Sample {
        double wavelength;  ///< nm, above 0
        double value;

        bool operator==(const Sample&) const = default;
    };

    ColorDescription(double grey) : rgb(grey) {}
    ColorDescription(const glm::dvec3& linear) : rgb(linear) {}

    bool operator==(const ColorDescription&) const = default;

    glm::dvec3 rgb{0.0};           ///< without meaning beside a table
    std::vector<Sample> spectrum;  ///< empty, or two and more by increasing wavelength
    /// Whether `rgb` is one value of a <spectrum>, the same at all wavelengths. Light of it is not grey.
    bool equal_energy = false;
};

}  // namespace nicol
