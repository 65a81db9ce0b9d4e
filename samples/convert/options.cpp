// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <nicol_psh.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "common/number_list.hpp"

const char* const usage =
    "usage: nicol-convert IN OUT [options]\n"
    "       nicol-convert --info FILE [--json] [options]\n"
    "       nicol-convert --demosaic METHOD RAW.png OUT.exr [--sensor FILE]\n"
    "       nicol-convert --angles AT_0 AT_45 AT_90 AT_135 OUT.exr\n"
    "Converts light and materials between file formats, or says what a file holds.\n"
    "\n"
    "  light      FILE.exr (equirectangular image), NAME_s0.exr (cube map, four files), FILE.npz (SHVec)\n"
    "  materials  FILE.npz (SHMat), FILE.pbsdf (reading), FILE.response (reading), FOLDER/ (response "
    "tables)\n"
    "\n"
    "      --info                  reports on FILE instead of converting\n"
    "      --json                  that report as JSON\n"
    "      --order N               highest order of coefficients and tables, and of an image made from "
    "them;\n"
    "                              default: that of the file, else 32 for light, 16 for materials\n"
    "      --size WxH              pixels of the image to write\n"
    "      --edge N                pixels along a face of the cube map to write; default 256\n"
    "      --wavelengths A,B,...   channels to make of a spectral image or a measured material, in nm\n"
    "      --scale S               multiplies the light or the material\n"
    "      --rotate X,Y,Z,DEGREES  rotates the light about this axis; may be repeated, in order\n"
    "      --band-limited          takes pixels as samples of light without orders above --order\n"
    "      --physical              makes s0 >= |(s1, s2, s3)| >= 0 in every pixel written\n"
    "      --demosaic METHOD       makes a Stokes image of a polarization camera's raw image: bilinear or\n"
    "                              gradient (of its size), or blocks (one Stokes vector per cell)\n"
    "      --sensor FILE           that camera, as JSON; default: as the raw image says\n"
    "      --angles                makes a Stokes image of four pictures behind a polarizer\n"
    "      --help                  shows this text\n"
    "      --version               shows the version and what this build has\n"
    "\n"
    "Exit code 0, or 2 and a one-line message on the standard error.\n";

namespace {

std::uint32_t parse_number(std::string_view option, std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw Failure(std::string(option) + ": '" + std::string(text) +
                      "' is not a whole number of at most 4294967295");
    return value;
}

std::uint32_t parse_order(std::string_view text) {
    const std::uint32_t order = parse_number("--order", text);
    if (order > NICOL_PSH_MAX_ORDER)
        throw Failure("--order: " + std::string(text) + " is above " + std::to_string(NICOL_PSH_MAX_ORDER));
    return order;
}

void parse_size(nicol_file_options& file, std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos)
        throw Failure("--size: '" + std::string(text) + "' is not WIDTHxHEIGHT, like 1024x513");
    file.width = parse_number("--size", text.substr(0, cross));
    file.height = parse_number("--size", text.substr(cross + 1));
    if (file.width < 2 || file.height < 2)
        throw Failure("--size: " + std::string(text) + " is smaller than 2x2");
}

void parse_wavelengths(nicol_file_options& file, std::string_view text) {
    const std::vector<double> values = parse_list("--wavelengths", text);
    if (values.size() > NICOL_MAX_CHANNELS)
        throw Failure("--wavelengths: there are " + std::to_string(values.size()) + "; at most " +
                      std::to_string(NICOL_MAX_CHANNELS) + " are possible");
    file.wavelengths.count = static_cast<std::uint32_t>(values.size());
    std::transform(values.begin(), values.end(), file.wavelengths.values,
                   [](double value) { return static_cast<float>(value); });
}

void parse_scale(nicol_file_options& file, std::string_view text) {
    const std::vector<double> values = parse_list("--scale", text);
    if (values.size() != 1 || !(values[0] > 0))
        throw Failure("--scale: '" + std::string(text) + "' must be one number above 0");
    file.scale = values[0];
}

nicol_demosaic parse_demosaic(std::string_view text) {
    if (text == "bilinear") return NICOL_DEMOSAIC_BILINEAR;
    if (text == "blocks") return NICOL_DEMOSAIC_BLOCKS;
    if (text == "gradient") return NICOL_DEMOSAIC_GRADIENT;
    throw Failure("--demosaic: '" + std::string(text) + "' is neither bilinear, gradient nor blocks");
}

// Applies this rotation after the earlier ones (Rodrigues' formula).
void add_rotation(nicol_file_options& file, std::string_view text) {
    const std::vector<double> values = parse_list("--rotate", text);
    if (values.size() != 4) throw Failure("--rotate: '" + std::string(text) + "' is not X,Y,Z,DEGREES");
    const double length = std::hypot(values[0], values[1], values[2]);
    if (!(length > 0) || !std::isfinite(length))
        throw Failure("--rotate: the axis of '" + std::string(text) + "' has no length");
    const std::array<double, 3> axis{values[0] / length, values[1] / length, values[2] / length};
    const double angle = values[3] * std::acos(-1.0) / 180;
    std::array<double, 9> rotation{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            rotation[3 * row + column] = (1 - std::cos(angle)) * axis[row] * axis[column];
            if (row == column) rotation[3 * row + column] += std::cos(angle);
        }
        const std::size_t next = (row + 1) % 3;
        const std::size_t last = (row + 2) % 3;
        rotation[3 * row + next] -= std::sin(angle) * axis[last];
        rotation[3 * row + last] += std::sin(angle) * axis[next];
    }
    std::array<double, 9> before{};
    std::copy(std::begin(file.rotation), std::end(file.rotation), before.begin());
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
            file.rotation[3 * row + column] = 0;
            for (std::size_t i = 0; i < 3; ++i)
                file.rotation[3 * row + column] += rotation[3 * row + i] * before[3 * i + column];
        }
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
    Options options;
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        std::string_view name = argv[i];
        std::optional<std::string_view> attached;  // value in --name=value
        if (name.starts_with("--") && name.find('=') != std::string_view::npos) {
            attached = name.substr(name.find('=') + 1);
            name = name.substr(0, name.find('='));
        }
        const auto value = [&]() -> std::string_view {
            if (attached) return *attached;
            if (i + 1 >= argc) throw Failure(std::string(name) + ": a value must follow");
            return argv[++i];
        };
        const auto plain = [&] {
            if (attached) throw Failure(std::string(name) + ": takes no value");
        };
        if (name == "--help" || name == "-h" || name == "--version") {
            options.action = name == "--version" ? Options::Action::version : Options::Action::help;
            return options;
        }
        if (name == "--info")
            plain(), options.action = Options::Action::info;
        else if (name == "--json")
            plain(), options.json = true;
        else if (name == "--demosaic")
            options.demosaic = parse_demosaic(value()), options.action = Options::Action::demosaic;
        else if (name == "--sensor")
            options.sensor = value();
        else if (name == "--angles")
            plain(), options.action = Options::Action::angles;
        else if (name == "--order")
            options.file.order = parse_order(value());
        else if (name == "--size")
            parse_size(options.file, value());
        else if (name == "--edge")
            options.file.edge = std::max(1U, parse_number(name, value()));
        else if (name == "--wavelengths")
            parse_wavelengths(options.file, value());
        else if (name == "--scale")
            parse_scale(options.file, value());
        else if (name == "--rotate")
            add_rotation(options.file, value());
        else if (name == "--band-limited")
            plain(), options.file.flags |= NICOL_FILE_BAND_LIMITED;
        else if (name == "--physical")
            plain(), options.file.flags |= NICOL_FILE_PHYSICAL;
        else if (name.starts_with("-"))
            throw Failure("unknown option '" + std::string(argv[i]) + "'; --help lists them all");
        else
            files.emplace_back(argv[i]);
    }
    const bool info = options.action == Options::Action::info;
    if (options.json && !info) throw Failure("--json: is for --info");
    if (!options.sensor.empty() && options.action != Options::Action::demosaic)
        throw Failure("--sensor: is for --demosaic");
    if (options.action == Options::Action::angles) {
        if (files.size() != 5)
            throw Failure(
                "--angles takes pictures at 0, 45, 90 and 135 degrees and an output, and there are " +
                std::to_string(files.size()) + " files");
        options.output = files.back();
        files.pop_back();
        options.angles = files;
        return options;
    }
    const std::size_t wanted = info ? 1 : 2;
    if (files.size() != wanted)
        throw Failure(std::string(info ? "--info takes one file" : "an input and an output are wanted") +
                      ", and there are " + std::to_string(files.size()) +
                      "; usage: nicol-convert IN OUT, or nicol-convert --info FILE");
    options.input = files[0];
    if (!info) options.output = files[1];
    return options;
}
