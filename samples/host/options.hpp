// SPDX-License-Identifier: MIT
// The command line.
#pragma once

#include <string>

struct Options {
    std::string screenshot;  ///< PPM file of the last frame; empty: none
    std::string planes;      ///< raw floats of the Stokes planes; empty: none
    int frames = 0;          ///< 0: until the window is closed
    double polarizer = 0;    ///< degrees
    bool nicol = true;
    bool help = false;
};

extern const char* const usage;

/// Throws Failure naming the option that is wrong.
[[nodiscard]] Options parse(int count, char** arguments);
