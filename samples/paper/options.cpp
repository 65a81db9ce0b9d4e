// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <charconv>
#include <cstdlib>

const char* const usage =
    "usage: nicol-paper [DATA] [options]\n"
    "Renders the scene of the paper's figures 18 and 22: images of figures 20 and 22, and table 4.\n"
    "\n"
    "  DATA                 folder of buddha.obj, plane.obj, SHVec_sponza_1024_L100.npz and\n"
    "                       SHMat_6_gold_ds1_L20_ISOBI2.npz; default: polarsh in the folder NICOL_TEST_DATA\n"
    "      --out DIR        where the results go, made when missing; default: out/paper\n"
    "      --size N         images of N x N pixels, 32 to 4096; default 1024\n"
    "      --frames N       times N frames of each method, at most 1000; default 21, 0: no times\n"
    "      --directions N   that shadows are traced in from each vertex, 256 to 65536; default 2048\n"
    "      --reference N    also renders by rays, twice N samples a pixel, and states the errors\n"
    "      --help           shows this text\n"
    "\n"
    "Exit code 0, or 2 and a one-line message on the standard error, also where DATA is absent.\n";

namespace {

template <class Number>
Number parse_number(const std::string& name, const std::string& text, Number least, Number most) {
    Number value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) {
        throw Failure(name + ": '" + text + "' is not a whole number from " + std::to_string(least) + " to " +
                      std::to_string(most));
    }
    return value;
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        const auto value = [&]() -> std::string {
            if (i + 1 >= argc) throw Failure(name + ": a value must follow");
            return argv[++i];
        };
        if (name == "--help") {
            options.help = true;
            return options;
        } else if (name == "--out") {
            options.out = value();
        } else if (name == "--size") {
            options.size = parse_number<std::uint32_t>(name, value(), 32, 4096);
        } else if (name == "--frames") {
            options.frames = parse_number<std::uint32_t>(name, value(), 0, 1000);
        } else if (name == "--directions") {
            options.bake_directions = parse_number<std::uint32_t>(name, value(), 256, 65536);
        } else if (name == "--reference") {
            options.reference = parse_number<std::int32_t>(name, value(), 1, 1 << 20);
        } else if (name.starts_with("-")) {
            throw Failure("unknown option '" + name + "'; --help lists them all");
        } else if (!options.data.empty()) {
            throw Failure("two folders of data given, '" + options.data.string() + "' and '" + name +
                          "'; one is wanted");
        } else {
            options.data = name;
        }
    }
    if (options.out.empty()) throw Failure("--out: the path is empty");
    if (options.data.empty()) {
        const char* folder = std::getenv("NICOL_TEST_DATA");
        if (folder == nullptr || *folder == '\0') {
            throw Failure(
                "no folder of data given, and NICOL_TEST_DATA is not set; it must hold buddha.obj, "
                "plane.obj, the light and the gold of the Python package polarsh");
        }
        options.data = std::filesystem::path(folder) / "polarsh";
    }
    return options;
}
