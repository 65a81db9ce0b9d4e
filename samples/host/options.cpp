// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <cmath>
#include <cstdlib>

#include "common/failure.hpp"

const char* const usage =
    "usage: nicol-host [OPTION...]\n"
    "Shows polarized light inside an application with OpenGL of its own. Left and right rotate the "
    "polarizer; the space bar stops the motion, and the image then gets up to 64 samples per pixel.\n"
    "  --polarizer ANGLE   degrees counter-clockwise from the right\n"
    "  --frames N          end after N frames; the first one faces the viewer\n"
    "  --pause N           stop the motion at frame N\n"
    "  --screenshot FILE   write the last frame as a PPM image; needs --frames\n"
    "  --planes FILE       write what the image on the quad is made of: 256 x 256 x 3 Stokes vectors as "
    "floats\n"
    "  --time-budget MS    time that Nicol may take for a frame, in milliseconds (time_budget_ms)\n"
    "  --rings             draw two rings about the ball, by the application, which share its depth\n"
    "  --without-nicol     leave the quad out\n";

namespace {

double number(const std::string& option, const char* text) {
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    if (end == text || *end != '\0' || !std::isfinite(value))
        throw Failure(option + ": " + text + " is not a number");
    return value;
}

int frame_number(const std::string& option, const char* text) {
    const double value = number(option, text);
    if (value < 1 || value > 1e6 || value != std::floor(value))
        throw Failure(option + " must be a whole number from 1 to 1000000");
    return static_cast<int>(value);
}

}  // namespace

Options parse(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string option = arguments[i];
        const auto value = [&] {
            if (++i >= count) throw Failure(option + " needs a value");
            return arguments[i];
        };
        if (option == "--help") {
            options.help = true;
        } else if (option == "--without-nicol") {
            options.nicol = false;
        } else if (option == "--rings") {
            options.rings = true;
        } else if (option == "--screenshot") {
            options.screenshot = value();
        } else if (option == "--planes") {
            options.planes = value();
        } else if (option == "--polarizer") {
            options.polarizer = number(option, value());
        } else if (option == "--time-budget") {
            options.time_budget = number(option, value());
        } else if (option == "--frames") {
            options.frames = frame_number(option, value());
        } else if (option == "--pause") {
            options.pause = frame_number(option, value());
        } else {
            throw Failure("unknown option " + option + "; --help lists them");
        }
    }
    if (!options.screenshot.empty() && options.frames == 0) throw Failure("--screenshot needs --frames");
    if (options.rings && !options.nicol) throw Failure("--rings and --without-nicol exclude each other");
    if (!options.planes.empty() && !options.nicol)
        throw Failure("--planes and --without-nicol exclude each other");
    return options;
}
