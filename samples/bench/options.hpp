// SPDX-License-Identifier: MIT
// The command line.
#pragma once

#include <nicol.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Values of the command line; 0 or -1 means the sub-command's default.
struct Options {
    std::string scene;  ///< empty: the snail of samples/assets
    std::vector<std::string> definitions;
    std::string light;  ///< empty: the light of the scene
    nicol_backend backend = NICOL_BACKEND_AUTOMATIC;
    std::uint32_t size = 0;
    std::uint32_t samples = 0;
    int first_order = -1;
    int last_order = -1;
    int converged = 0;
    double memory = 4;  ///< in GB
    double seconds = 1;
    bool large = false;
    std::string only;  ///< part of a row's name
    std::string cache;
    std::string plot;
    std::string peer;
    std::string csv;
    std::string json;
};

/// Parses the command line. Throws std::runtime_error with one line that names the argument. `accepted` are
/// the names of options, such as "--size"; "SCENE.xml" stands for the one argument without a name.
Options parse_options(std::span<char* const> arguments, std::span<const char* const> accepted);
