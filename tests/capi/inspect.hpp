// SPDX-License-Identifier: MIT
// Shared helpers of the light and material file tests.
#pragma once

#include "image/stokes_image.hpp"
#include "psh.hpp"

namespace capi_test {

/// Reads the coefficients of a light file and checks that it has `channels` channels.
inline nicol::PshVector coefficients_of(const std::string& path, int order, int channels) {
    nicol::PshVector out(order, channels);
    std::uint32_t found = 0;
    OK(nicol_psh_project_file(path.c_str(), static_cast<std::uint32_t>(order), &found, out.data().data(),
                              out.data().size()));
    REQUIRE(found == static_cast<std::uint32_t>(channels));
    return out;
}

inline void write_light(const std::string& path, const nicol::PshVector& field) {
    OK(nicol_psh_write_file(path.c_str(), static_cast<std::uint32_t>(field.order()),
                            static_cast<std::uint64_t>(field.channels()), field.data().data(),
                            field.data().size()));
}

inline void convert(const std::string& in, const std::string& out,
                    const nicol_file_options& options = NICOL_FILE_OPTIONS_INIT) {
    OK(nicol_file_convert(in.c_str(), &options, out.c_str()));
}

inline nicol_file_options of_order(std::uint32_t order, std::uint32_t flags = 0) {
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.order = order;
    options.flags = flags;
    return options;
}

inline nicol_light_report light_report_of(const std::string& path,
                                          const nicol_file_options* options = nullptr) {
    nicol_light_report report = NICOL_LIGHT_REPORT_INIT;
    OK(nicol_file_describe_light(path.c_str(), options, &report, nullptr, 0));
    return report;
}

}  // namespace capi_test
