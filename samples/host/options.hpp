// SPDX-License-Identifier: MIT
// The command line.
#pragma once

#include <string>

struct Options {
    std::string screenshot;  ///< PPM file of the last frame; empty: none
    std::string planes;      ///< file of raw floats of the Stokes planes; empty: none
    int frames = 0;          ///< number of frames; 0: until the window is closed
    int pause = 0;           ///< frame at which the motion stops; 0: it goes on
    double polarizer = 0;    ///< in degrees
    double time_budget = 0;  ///< time_budget_ms of the render options
    bool nicol = true;
    bool rings = false;  ///< whether the application draws rings about the ball
    bool help = false;
};

extern const char* const usage;

/// Parses the command line. Throws Failure naming the wrong option.
[[nodiscard]] Options parse(int count, char** arguments);
