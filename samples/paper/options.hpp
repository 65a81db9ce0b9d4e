// SPDX-License-Identifier: MIT
// The command line of nicol-paper.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/failure.hpp"

struct Options {
    bool help = false;
    std::filesystem::path data;  ///< holds buddha.obj, plane.obj, the light and gold
    std::filesystem::path out = "out/paper";
    std::uint32_t size = 1024;    ///< of the images, in pixels
    std::uint32_t frames = 21;    ///< of each method that are timed; 0: no table
    std::uint32_t reference = 0;  ///< samples a pixel of each of two images; 0: none
    std::uint32_t bake_directions = 2048;
};

/// The text of --help.
extern const char* const usage;

/// Throws Failure naming the argument and what would be right.
Options parse_options(int argc, const char* const* argv);
