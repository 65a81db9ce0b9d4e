// SPDX-License-Identifier: MIT
// What the tests of files of light and materials share.
#pragma once

#include "image/stokes_image.hpp"
#include "psh_sky.hpp"

namespace capi_test {

/// Coefficients [channel][l*l + l + m][4] of a file; `channels` must be right.
inline Doubles coefficients_of(const std::string& path, std::uint32_t order, std::uint32_t channels) {
    Doubles out(channels * vector_size(order));
    std::uint32_t found = 0;
    OK(nicol_psh_project_file(path.c_str(), order, &found, out.data(), out.size()));
    REQUIRE(found == channels);
    return out;
}

/// Random light that is physical: s0 stays well above the polarized part.
inline Doubles random_light(std::mt19937& random, std::uint32_t order, std::size_t channels) {
    Doubles out = random_fields(random, order, channels);
    for (std::size_t c = 0; c < channels; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < vector_size(order); ++i) sum += std::abs(out[c * vector_size(order) + i]);
        out[c * vector_size(order)] = sum * std::sqrt(2.0 * order + 1) + 1;
    }
    return out;
}

inline void write_light(const std::string& path, std::uint32_t order, const Doubles& field) {
    OK(nicol_psh_write_file(path.c_str(), order, field.size() / vector_size(order), field.data(),
                            field.size()));
}

inline void convert(const std::string& in, const std::string& out, const nicol_file_options& options) {
    OK(nicol_file_convert(in.c_str(), &options, out.c_str()));
}

inline nicol_file_options of_order(std::int32_t order, std::uint32_t flags = 0) {
    nicol_file_options options = NICOL_FILE_OPTIONS_INIT;
    options.order = order;
    options.flags = flags;
    return options;
}

inline void set_rotation(nicol_file_options& options, const Rotation& rotation) {
    std::copy(rotation.begin(), rotation.end(), options.rotation);
}

inline double largest_of(const Doubles& values) {
    double largest = 0;
    for (const double v : values) largest = std::max(largest, std::abs(v));
    return largest;
}

inline nicol_light_report light_report_of(const std::string& path,
                                          const nicol_file_options* options = nullptr) {
    nicol_light_report report = NICOL_LIGHT_REPORT_INIT;
    OK(nicol_file_describe_light(path.c_str(), options, &report, nullptr, 0));
    return report;
}

/// The sky of psh_sky.hpp as an image file.
inline void write_sky(const std::string& path, std::uint32_t width, std::uint32_t height) {
    const std::vector<float> pixels = sky_image(width, height, 1);
    nicol::StokesImage image(static_cast<int>(width), static_cast<int>(height), 1);
    std::copy(pixels.begin(), pixels.end(), image.data.begin());
    nicol::write_exr(path, image);
}

}  // namespace capi_test
