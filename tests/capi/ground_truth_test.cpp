// SPDX-License-Identifier: MIT
// Images against Mitsuba 3's. A sphere under constant light has neither shadow nor truncation: every
// difference is either Monte Carlo noise or ours.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "image/stokes_image.hpp"
#include "nicol.h"

namespace {

struct Observation {
    std::uint32_t width = 0, height = 0, channels = 0;
    std::vector<std::vector<float>> planes;  // [channel] of four floats a pixel
};

#define OK(call)                             \
    do {                                     \
        const nicol_result result_ = (call); \
        INFO(nicol_last_error());            \
        REQUIRE(result_ == NICOL_OK);        \
    } while (false)

Observation render(nicol_backend backend, const std::string& scene_file, const char* definition,
                   std::int32_t order) {
    nicol_context_options context_options = NICOL_CONTEXT_OPTIONS_INIT;
    context_options.backend = backend;
    nicol_context context = nullptr;
    OK(nicol_context_create(&context_options, &context));
    nicol_scene scene = nullptr;
    OK(nicol_scene_load(context, scene_file.c_str(), &definition, 1, &scene));
    nicol_camera camera = NICOL_CAMERA_INIT;
    OK(nicol_scene_get_camera(scene, &camera));
    Observation image;
    OK(nicol_scene_get_film_size(scene, &image.width, &image.height));
    OK(nicol_scene_get_channels(scene, &image.channels));
    nicol_framebuffer framebuffer = nullptr;
    OK(nicol_framebuffer_create(context, image.width, image.height, image.channels, &framebuffer));
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.order_low = options.order_high = order;
    OK(nicol_render(scene, &camera, &options, framebuffer));
    for (std::uint32_t c = 0; c < image.channels; ++c) {
        image.planes.emplace_back(std::size_t{4} * image.width * image.height);
        OK(nicol_framebuffer_read(framebuffer, NICOL_PLANE_STOKES, c, image.planes.back().data(), 0,
                                  image.planes.back().size() * sizeof(float)));
    }
    OK(nicol_framebuffer_release(framebuffer));
    OK(nicol_scene_release(scene));
    OK(nicol_context_release(context));
    return image;
}

// What is compared over the sphere's interior.
struct Comparison {
    double mean_ratio = 0;        // of s0
    double slope[3] = {0, 0, 0};  // least squares of ours against the truth, s0..s2
    double largest_s3 = 0;
    double rmse[3] = {0, 0, 0};         // over the channel's mean s0, in the worst channel
    double noise_share[3] = {0, 0, 0};  // residual over the truth's own noise, in the worst channel
};

bool inside(const Observation& image, std::uint32_t x, std::uint32_t y) {
    const double half = image.width / 2.0;  // the sphere of radius 1 in an image of half width 1.25
    return 1.25 * std::hypot(x + 0.5 - half, y + 0.5 - half) / half < 0.97;
}

// Under constant light left and right halves are mirror images, so what they differ by is the truth's noise.
Comparison compare(const Observation& ours, const nicol::StokesImage& truth) {
    Comparison out;
    double total = 0, total_truth = 0;
    double product[3] = {0, 0, 0}, square[3] = {0, 0, 0};
    for (std::uint32_t c = 0; c < ours.channels; ++c) {
        double mean = 0, count = 0;
        double error[3] = {0, 0, 0}, noise[3] = {0, 0, 0};
        for (std::uint32_t y = 0; y < ours.height; ++y) {
            for (std::uint32_t x = 0; x < ours.width; ++x) {
                if (!inside(ours, x, y)) continue;
                const float* mine = &ours.planes[c][4 * (std::size_t{y} * ours.width + x)];
                const auto at = [&](std::uint32_t column) {
                    return truth.stokes(static_cast<int>(c), static_cast<int>(y), static_cast<int>(column));
                };
                const nicol::Stokes other = at(x);
                const nicol::Stokes mirrored = at(ours.width - 1 - x);
                ++count;
                mean += other[0];
                total += static_cast<double>(mine[0]);
                total_truth += other[0];
                out.largest_s3 = std::fmax(out.largest_s3, std::abs(static_cast<double>(mine[3])));
                for (int p = 0; p < 3; ++p) {
                    const auto a = static_cast<double>(mine[p]);
                    const double b = other[p];
                    product[p] += a * b;
                    square[p] += b * b;
                    error[p] += (a - b) * (a - b);
                    noise[p] += std::pow(b - (p == 2 ? -mirrored[p] : mirrored[p]), 2) / 2;
                }
            }
        }
        for (std::size_t p = 0; p < 3; ++p) {
            out.rmse[p] = std::fmax(out.rmse[p], std::sqrt(error[p] / count) / (mean / count));
            out.noise_share[p] = std::fmax(out.noise_share[p], std::sqrt(error[p] / noise[p]));
        }
    }
    out.mean_ratio = total / total_truth;
    for (std::size_t p = 0; p < 3; ++p) out.slope[p] = product[p] / square[p];
    return out;
}

std::string data_folder() {
    const char* folder = std::getenv("NICOL_TEST_DATA");
    return folder == nullptr ? std::string() : std::string(folder) + "/mitsuba/";
}

}  // namespace

TEST_CASE("a sphere under constant light is Mitsuba 3's, in every Stokes component") {
    if (!std::filesystem::exists(data_folder() + "sphere_const.xml")) {
        MESSAGE("skipped: NICOL_TEST_DATA has no mitsuba/sphere_const.xml");
        return;
    }
    struct Case {
        const char* definition;
        const char* truth;
    };
    for (const Case& c :
         {Case{"alpha=0.3", "sphere_const_a03.exr"}, Case{"alpha=0.1", "sphere_const_a01.exr"}}) {
        const nicol::StokesImage truth = nicol::read_exr(data_folder() + c.truth);
        for (const nicol_backend backend : {NICOL_BACKEND_EGL, NICOL_BACKEND_OSMESA}) {
            // Order 0 is the whole light.
            const Comparison result =
                compare(render(backend, data_folder() + "sphere_const.xml", c.definition, -1), truth);
            MESSAGE(std::string(c.definition)
                    << ": mean s0 ratio " << result.mean_ratio << ", slopes s1 " << result.slope[1] << " s2 "
                    << result.slope[2] << ", |s3| " << result.largest_s3 << ", relative RMSE s0 "
                    << result.rmse[0] << " s1 " << result.rmse[1] << " s2 " << result.rmse[2]);
            CHECK(std::abs(result.mean_ratio - 1) < 0.003);
            CHECK(std::abs(result.slope[1] - 1) < 0.01);
            CHECK(std::abs(result.slope[2] - 1) < 0.01);
            CHECK(result.largest_s3 < 1e-6);
            CHECK(result.rmse[0] < 0.025);
            // Nothing is left once the noise is taken away.
            for (const double share : result.noise_share) CHECK(share < 1.03);
        }
    }
}

TEST_CASE("a sphere under an image of light differs from Mitsuba 3's by the truncation alone") {
    if (!std::filesystem::exists(data_folder() + "sphere_env.xml")) {
        MESSAGE("skipped: NICOL_TEST_DATA has no mitsuba/sphere_env.xml");
        return;
    }
    const nicol::StokesImage truth = nicol::read_exr(data_folder() + "sphere_env_a03.exr");
    double before = 1;
    for (const std::int32_t order : {4, 9, 14}) {
        const Comparison result = compare(
            render(NICOL_BACKEND_OSMESA, data_folder() + "sphere_env.xml", "alpha=0.3", order), truth);
        MESSAGE("order " << order << ": mean s0 ratio " << result.mean_ratio << ", slopes s1 "
                         << result.slope[1] << " s2 " << result.slope[2] << ", relative RMSE s0 "
                         << result.rmse[0] << " s1 " << result.rmse[1] << " s2 " << result.rmse[2]);
        CHECK(std::abs(result.mean_ratio - 1) < 0.005);
        if (order >= 9) {
            CHECK(std::abs(result.slope[1] - 1) < 0.015);
            CHECK(std::abs(result.slope[2] - 1) < 0.015);
        }
        CHECK(result.rmse[0] < before);
        before = result.rmse[0];
    }
}
