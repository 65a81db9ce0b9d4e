// SPDX-License-Identifier: MIT
// Tests of images against Mitsuba 3.
#include "image/stokes_image.hpp"
#include "planes.hpp"

using namespace capi_test;

namespace {

nicol_render_options low_orders(std::uint32_t order, std::uint32_t shadows = 1) {
    nicol_render_options options = plain_options();
    options.order_low = order;
    options.high_orders = NICOL_HIGH_ORDERS_NONE;
    options.shadows = shadows;
    options.aovs = NICOL_AOV_INSTANCE;
    return options;
}

// Statistics over the interior of a sphere of radius 1 in an image of half width 1.25.
struct Comparison {
    double mean_ratio = 0;        // of s0
    double slope[3] = {0, 0, 0};  // least-squares slope of Nicol's value against the truth, for s0, s1, s2
    double largest_s3 = 0;
    double rmse[3] = {0, 0, 0};         // divided by the channel's mean s0, in the worst channel
    double noise_share[3] = {0, 0, 0};  // residual divided by the noise of the truth, in the worst channel
};

// Compares an image with the truth. Under constant light the left and right halves of the truth are mirror
// images, so their difference measures its noise.
Comparison compare(const std::vector<float>& ours, const nicol::StokesImage& truth) {
    REQUIRE(ours.size() == truth.data.size());
    Comparison out;
    double total = 0, total_truth = 0;
    double product[3] = {0, 0, 0}, square[3] = {0, 0, 0};
    const double half = truth.width / 2.0;
    std::size_t i = 0;
    for (int c = 0; c < truth.channels; ++c) {
        double mean = 0, count = 0;
        double error[3] = {0, 0, 0}, noise[3] = {0, 0, 0};
        for (int y = 0; y < truth.height; ++y) {
            for (int x = 0; x < truth.width; ++x, i += 4) {
                if (1.25 * std::hypot(x + 0.5 - half, y + 0.5 - half) / half >= 0.97) continue;
                const nicol::Stokes other = truth.stokes(c, y, x);
                const nicol::Stokes mirrored = truth.stokes(c, y, truth.width - 1 - x);
                ++count;
                mean += other[0];
                total += ours[i];
                total_truth += other[0];
                out.largest_s3 = std::fmax(out.largest_s3, std::abs(double(ours[i + 3])));
                for (std::size_t p = 0; p < 3; ++p) {
                    const double a = ours[i + p], b = other[int(p)], m = mirrored[int(p)];
                    product[p] += a * b;
                    square[p] += b * b;
                    error[p] += (a - b) * (a - b);
                    noise[p] += std::pow(b - (p == 2 ? -m : m), 2) / 2;
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

/// Marks pixels of the last render whose eight neighbours show the same object.
std::vector<bool> inner_pixels(const LoadedScene& file) {
    const auto object = read_surface<std::uint32_t>(file.framebuffer, NICOL_PLANE_INSTANCE, 1);
    const std::size_t width = file.width;
    std::vector<bool> inner(object.size(), false);
    for (std::size_t i = width + 1; i + width + 1 < object.size(); ++i) {
        if (i % width == 0 || i % width == width - 1) continue;
        bool same = object[i] != NICOL_NO_INSTANCE;
        for (std::size_t n = 0; n < 9; ++n)
            same = same && object[i + n / 3 * width - width + n % 3 - 1] == object[i];
        inner[i] = same;
    }
    return inner;
}

}  // namespace

// A single sphere has no shadow. Order 0 represents constant light exactly, so any difference is Monte Carlo
// noise or an error of Nicol. Under an environment map truncation adds to it.
TEST_CASE("a sphere is Mitsuba 3's in every Stokes component, but for noise and truncation") {
    struct Case {
        const char *scene, *definition, *truth;
        std::uint32_t order;
        nicol_backend backend;
    };
    double before = 1;
    for (const Case& c : {
             Case{"const", "alpha=0.3", "mitsuba/sphere_const_a03.exr", 0, NICOL_BACKEND_EGL},
             Case{"const", "alpha=0.3", "mitsuba/sphere_const_a03.exr", 0, NICOL_BACKEND_OSMESA},
             Case{"const", "alpha=0.1", "mitsuba/sphere_const_a01.exr", 0, NICOL_BACKEND_EGL},
             Case{"const", "alpha=0.1", "mitsuba/sphere_const_a01.exr", 0, NICOL_BACKEND_OSMESA},
             Case{"env", "alpha=0.3", "mitsuba/sphere_env_a03.exr", 4, NICOL_BACKEND_OSMESA},
             Case{"env", "alpha=0.3", "mitsuba/sphere_env_a03.exr", 9, NICOL_BACKEND_OSMESA},
             Case{"env", "alpha=0.3", "mitsuba/sphere_env_a03.exr", 14, NICOL_BACKEND_OSMESA},
         }) {
        CAPTURE(c.truth);
        CAPTURE(c.order);
        const std::filesystem::path truth = test_data(c.truth);
        if (truth.empty()) continue;
        const std::string scene = (truth.parent_path() / "sphere_").string() + c.scene + ".xml";
        const Owned context(make_context(c.backend));
        const Comparison result = compare(
            LoadedScene(context, scene, {c.definition}).image(low_orders(c.order)), nicol::read_exr(truth));
        MESSAGE(std::string(c.truth) << ", order " << c.order << ": mean s0 ratio " << result.mean_ratio
                                     << ", slopes s1 " << result.slope[1] << " s2 " << result.slope[2]
                                     << ", |s3| " << result.largest_s3 << ", relative RMSE s0 "
                                     << result.rmse[0] << " s1 " << result.rmse[1] << " s2 "
                                     << result.rmse[2]);
        if (c.order == 0) {
            CHECK(std::abs(result.mean_ratio - 1) < 0.003);
            CHECK(std::abs(result.slope[1] - 1) < 0.01);
            CHECK(std::abs(result.slope[2] - 1) < 0.01);
            CHECK(result.largest_s3 < 1e-6);
            CHECK(result.rmse[0] < 0.025);
            // The residual is no larger than the noise of the truth.
            for (const double share : result.noise_share) CHECK(share < 1.03);
            continue;
        }
        CHECK(std::abs(result.mean_ratio - 1) < 0.005);
        if (c.order >= 9) {
            CHECK(std::abs(result.slope[1] - 1) < 0.015);
            CHECK(std::abs(result.slope[2] - 1) < 0.015);
        }
        CHECK(result.rmse[0] < before);
        before = result.rmse[0];
    }
}

TEST_CASE("a statue on a plane, with shadows, is Mitsuba 3's, but for truncation and noise") {
    const TemporaryFolder folder;
    for (const char* name :
         {"mitsuba/buddha.xml", "mitsuba/venice.exr", "polarsh/buddha.obj", "polarsh/plane.obj"}) {
        const std::filesystem::path file = test_data(name);
        if (file.empty()) return;
        std::filesystem::create_symlink(std::filesystem::absolute(file), folder / file.filename().string());
    }
    const Owned context(make_context(NICOL_BACKEND_OSMESA));
    const LoadedScene file(context, folder.file("buddha.xml"));
    const std::vector<float> truth = nicol::read_exr(test_data("mitsuba/buddha_plane_venice.exr")).data;
    const std::vector<float> shadowed = file.image(low_orders(9, 1)), plain = file.image(low_orders(9, 0));
    const std::vector<bool> inner = inner_pixels(file);
    const auto covered = std::count(inner.begin(), inner.end(), true);
    CHECK(covered > 10000);
    const Distance with(shadowed, truth, inner), without(plain, truth, inner);
    MESSAGE("relative RMSE s0 " << with.error[0] / with.size[0] << " s1 " << with.error[1] / with.size[0]
                                << " s2 " << with.error[2] / with.size[0] << ", without shadows s0 "
                                << without.error[0] / with.size[0] << ", over " << covered << " pixels");
    CHECK(with.error[0] < 0.03 * with.size[0]);
    CHECK(with.error[1] < 0.01 * with.size[0]);
    CHECK(with.error[2] < 0.01 * with.size[0]);
    // Without shadows the image is wrong.
    CHECK(without.error[0] > 3 * with.error[0]);
}
