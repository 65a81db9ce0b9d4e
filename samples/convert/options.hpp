// SPDX-License-Identifier: MIT
// The command line of nicol-convert.
#pragma once

#include <nicol_files.h>

#include <string>
#include <vector>

#include "common/failure.hpp"

struct Options {
    enum class Action { convert, info, demosaic, angles, help, version };
    Action action = Action::convert;
    std::string input;
    std::vector<std::string> angles;  ///< for `angles`: the pictures at 0, 45, 90 and 135 degrees
    nicol_demosaic demosaic = NICOL_DEMOSAIC_BILINEAR;
    std::string sensor;  ///< for `demosaic`: file; empty: the input names it
    std::string output;  ///< empty for `info`
    bool json = false;
    nicol_file_options file = NICOL_FILE_OPTIONS_INIT;
};

/// Text of --help.
extern const char* const usage;

/// Parses the command line. Throws Failure that names the argument and the valid values.
Options parse_options(int argc, const char* const* argv);
