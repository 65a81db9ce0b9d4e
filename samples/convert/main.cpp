// SPDX-License-Identifier: MIT
// nicol-convert: conversion of light and materials between file formats, descriptions of files, and Stokes
// images of what cameras measure, using only the C ABI.
#include <nicol_files.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "common/failure.hpp"
#include "common/handles.hpp"
#include "options.hpp"
#include "report.hpp"

namespace {

// Prints a notice about truncated light that rings, because its images may be refused later by Nicol or other
// programs.
void notice_unphysical(const std::string& path) {
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.order = 0;
    nicol_light_report report = NICOL_LIGHT_REPORT_INIT;
    check(nicol_file_describe_light(path.c_str(), &options, &report, nullptr, 0));
    const double excess = *std::max_element(report.largest_excess, report.largest_excess + report.channels);
    if (excess < 1e-3) return;
    std::fprintf(stderr,
                 "nicol-convert: notice: %s: %.2g %% of the sphere violates s0 >= |(s1, s2, s3)|, by up to "
                 "%.2g of the mean s0; where the light is refused for it, convert with --physical\n",
                 one_line(path.c_str()).c_str(),
                 100 * *std::max_element(report.unphysical, report.unphysical + report.channels), excess);
}

void convert(const Options& options) {
    check(nicol_file_convert(options.input.c_str(), &options.file, options.output.c_str()));
    // An output written to a pipe cannot be read again.
    std::error_code error;
    const bool image = std::filesystem::path(options.output).extension() == ".exr" &&
                       std::filesystem::is_regular_file(options.output, error);
    if (image && (options.file.flags & NICOL_FILE_PHYSICAL) == 0) notice_unphysical(options.output);
}

void demosaic(const Options& options) {
    nicol_sensor sensor = NICOL_SENSOR_INIT;
    check(nicol_sensor_load(&sensor, (options.sensor.empty() ? options.input : options.sensor).c_str()));
    check(nicol_file_demosaic(options.input.c_str(), &sensor, options.demosaic, options.output.c_str()));
}

template <class Report>
void print(const Report& report, bool json) {
    std::fputs((json ? as_json(report) : as_text(report)).c_str(), stdout);
    if (std::fflush(stdout) != 0) throw Failure("the report could not be written");
}

void inform(const Options& options) {
    nicol_file_kind kind = 0;
    check(nicol_file_identify(options.input.c_str(), &kind));
    const std::size_t most_orders = NICOL_PSH_MAX_ORDER + 1;
    if (kind <= NICOL_FILE_LIGHT_PSH) {
        LightReport report{options.input, NICOL_LIGHT_REPORT_INIT, {}};
        report.energy.resize(4 * NICOL_MAX_CHANNELS * most_orders);
        check(nicol_file_describe_light(options.input.c_str(), &options.file, &report.numbers,
                                        report.energy.data(), report.energy.size()));
        print(report, options.json);
    } else {
        MaterialReport report{options.input, NICOL_MATERIAL_REPORT_INIT, {}};
        report.energy.resize(NICOL_MAX_CHANNELS * most_orders);
        check(nicol_file_describe_material(options.input.c_str(), &options.file, &report.numbers,
                                           report.energy.data(), report.energy.size()));
        print(report, options.json);
    }
}

void print_version() {
    std::printf("nicol-convert %s\n", nicol_version_string());
    for (std::uint32_t i = 0; const char* fact = nicol_build_info(i); ++i) std::printf("%s\n", fact);
}

void run(const Options& options) {
    switch (options.action) {
        case Options::Action::help:
            std::fputs(usage, stdout);
            return;
        case Options::Action::version:
            return print_version();
        case Options::Action::info:
            return inform(options);
        case Options::Action::demosaic:
            return demosaic(options);
        case Options::Action::angles:
            return check(nicol_file_combine_angles(options.angles[0].c_str(), options.angles[1].c_str(),
                                                   options.angles[2].c_str(), options.angles[3].c_str(),
                                                   options.output.c_str()));
        case Options::Action::convert:
            return convert(options);
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run(parse_options(argc, argv));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nicol-convert: %s\n", one_line(error.what()).c_str());
    } catch (...) {
        std::fputs("nicol-convert: an unknown error\n", stderr);
    }
    return 2;
}
