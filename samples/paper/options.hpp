// SPDX-License-Identifier: MIT
// The command line of nicol-paper.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/failure.hpp"

struct Options {
    bool help = false;
    std::filesystem::path data;  ///< folder of buddha.obj, plane.obj, the light and the gold
    std::filesystem::path out = "out/paper";
    std::uint32_t size = 1024;    ///< width and height of images, in pixels
    std::uint32_t frames = 21;    ///< timed frames per method; 0: no table
    std::uint32_t reference = 0;  ///< samples per pixel of each of two images; 0: none
    std::uint32_t bake_directions = 2048;
};

/// Text of --help.
extern const char* const usage;

/// Parses the command line. Throws Failure naming the argument and the valid values.
Options parse_options(int argc, const char* const* argv);
