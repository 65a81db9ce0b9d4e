// SPDX-License-Identifier: MIT
// Input of an experiment and output of its claims.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

struct Experiment {
    std::filesystem::path out;  ///< folder for images
    std::string light;          ///< OpenEXR file; empty: the image of light.hpp
    std::string polarsh;        ///< folder of the authors' data; empty: not compared
    bool quick = false;         ///< a smaller case if the full one takes more than a second
    bool failed = false;        ///< true if a claim did not hold

    /// Prints the claim and whether it holds.
    void claim(bool holds, const std::string& text);
    /// Returns an image's path under `out` and prints it.
    [[nodiscard]] std::string image(const std::string& name) const;
};

// Experiments, one file each, with the paper's figure numbers.
void figure_7(Experiment& experiment);
void figure_10(Experiment& experiment);
void figure_11(Experiment& experiment);
void figure_13(Experiment& experiment);
void figure_16(Experiment& experiment);
void figure_17(Experiment& experiment);
