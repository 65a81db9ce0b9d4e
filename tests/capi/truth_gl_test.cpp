// SPDX-License-Identifier: MIT
// Images against Mitsuba 3's.
#include <cstdlib>

#include "capi.hpp"
#include "image/stokes_image.hpp"

using namespace capi_test;

namespace {

/// A file of Mitsuba's below NICOL_TEST_DATA; empty, with a message, where it is not there.
std::filesystem::path data(const char* name) {
    const char* folder = std::getenv("NICOL_TEST_DATA");
    const std::filesystem::path file = std::filesystem::absolute(folder != nullptr ? folder : "") / name;
    if (std::filesystem::exists(file)) return file;
    MESSAGE("skipped: NICOL_TEST_DATA has no " << std::string(name));
    return {};
}

/// A scene file and a framebuffer of its film's size.
struct File {
    Owned<nicol_context> context;
    Owned<nicol_scene> scene;
    Owned<nicol_framebuffer> framebuffer;
    nicol_camera camera = NICOL_CAMERA_INIT;
    std::uint32_t width = 0, height = 0, channels = 0;

    File(nicol_backend backend, const std::string& file, const char* definition = nullptr)
        : context(make_context(backend)) {
        OK(nicol_scene_load(context, file.c_str(), &definition, definition != nullptr ? 1 : 0, &scene));
        OK(nicol_scene_get_camera(scene, &camera));
        OK(nicol_scene_get_film_size(scene, &width, &height));
        OK(nicol_scene_get_channels(scene, &channels));
        OK(nicol_framebuffer_create(context, width, height, channels, &framebuffer));
    }
    /// Of orders up to this one, [channel][pixel][component].
    [[nodiscard]] std::vector<float> render(std::int32_t order, std::int32_t shadows = 0) const {
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.order_low = order;
        options.high_orders = NICOL_HIGH_ORDERS_NONE;
        options.shadows = shadows;
        OK(nicol_render(scene, &camera, &options, framebuffer));
        return read_all(framebuffer);
    }
};

// What is compared over the interior of a sphere of radius 1 in an image of half width 1.25.
struct Comparison {
    double mean_ratio = 0;        // of s0
    double slope[3] = {0, 0, 0};  // least squares of ours against the truth, s0..s2
    double largest_s3 = 0;
    double rmse[3] = {0, 0, 0};         // over the channel's mean s0, in the worst channel
    double noise_share[3] = {0, 0, 0};  // residual over the truth's own noise, in the worst channel
};

// Under constant light left and right halves are mirror images, so what they differ by is the truth's noise.
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
                total += static_cast<double>(ours[i]);
                total_truth += other[0];
                out.largest_s3 = std::fmax(out.largest_s3, std::abs(static_cast<double>(ours[i + 3])));
                for (std::size_t p = 0; p < 3; ++p) {
                    const auto a = static_cast<double>(ours[i + p]);
                    const double b = other[static_cast<int>(p)], m = mirrored[static_cast<int>(p)];
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

/// 1 where a pixel and its eight neighbours show the same object. Under even light without shadows the
/// background is 1, the plane grey and the statue coloured. Sets the scene's light to that.
std::vector<char> inner_pixels(const File& file) {
    const Owned even(constant_light(file.context, {1, 1, 1}));
    OK(nicol_scene_set_environment(file.scene, even, nullptr, 0));
    const std::vector<float> image = file.render(-1, -1);
    const std::size_t width = file.width, pixels = width * file.height;
    std::vector<int> object(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float red = image[4 * i], blue = image[4 * (2 * pixels + i)];
        object[i] = red > 0.9999F && blue > 0.9999F ? 0 : red - blue < 0.01F ? 1 : 2;
    }
    std::vector<char> inner(pixels, 0);
    for (std::size_t y = 1; y + 1 < file.height; ++y) {
        for (std::size_t x = 1; x + 1 < width; ++x) {
            const int own = object[y * width + x];
            bool same = own != 0;
            for (std::size_t n = 0; n < 9; ++n)
                same = same && object[(y + n / 3 - 1) * width + x + n % 3 - 1] == own;
            inner[y * width + x] = same ? 1 : 0;
        }
    }
    return inner;
}

}  // namespace

// A sphere alone has no shadow. Order 0 is the whole of constant light, so that every difference is either
// Monte Carlo noise or ours; under an image of light there is the truncation, too.
TEST_CASE("a sphere is Mitsuba 3's in every Stokes component, but for noise and truncation") {
    struct Case {
        const char *scene, *definition, *truth;
        std::int32_t order;
        nicol_backend backend;
    };
    double before = 1;
    for (const Case& c : {
             Case{"const", "alpha=0.3", "mitsuba/sphere_const_a03.exr", -1, NICOL_BACKEND_EGL},
             Case{"const", "alpha=0.3", "mitsuba/sphere_const_a03.exr", -1, NICOL_BACKEND_OSMESA},
             Case{"const", "alpha=0.1", "mitsuba/sphere_const_a01.exr", -1, NICOL_BACKEND_EGL},
             Case{"const", "alpha=0.1", "mitsuba/sphere_const_a01.exr", -1, NICOL_BACKEND_OSMESA},
             Case{"env", "alpha=0.3", "mitsuba/sphere_env_a03.exr", 4, NICOL_BACKEND_OSMESA},
             Case{"env", "alpha=0.3", "mitsuba/sphere_env_a03.exr", 9, NICOL_BACKEND_OSMESA},
             Case{"env", "alpha=0.3", "mitsuba/sphere_env_a03.exr", 14, NICOL_BACKEND_OSMESA},
         }) {
        CAPTURE(c.truth);
        CAPTURE(c.order);
        const std::filesystem::path truth = data(c.truth);
        if (truth.empty()) continue;
        const std::string scene = (truth.parent_path() / "sphere_").string() + c.scene + ".xml";
        const Comparison result =
            compare(File(c.backend, scene, c.definition).render(c.order), nicol::read_exr(truth));
        MESSAGE(std::string(c.truth) << ", order " << c.order << ": mean s0 ratio " << result.mean_ratio
                                     << ", slopes s1 " << result.slope[1] << " s2 " << result.slope[2]
                                     << ", |s3| " << result.largest_s3 << ", relative RMSE s0 "
                                     << result.rmse[0] << " s1 " << result.rmse[1] << " s2 "
                                     << result.rmse[2]);
        if (c.order < 0) {
            CHECK(std::abs(result.mean_ratio - 1) < 0.003);
            CHECK(std::abs(result.slope[1] - 1) < 0.01);
            CHECK(std::abs(result.slope[2] - 1) < 0.01);
            CHECK(result.largest_s3 < 1e-6);
            CHECK(result.rmse[0] < 0.025);
            // Nothing is left once the noise is taken away.
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
        const std::filesystem::path file = data(name);
        if (file.empty()) return;
        std::filesystem::create_symlink(file, folder / file.filename().string());
    }
    const File file(NICOL_BACKEND_OSMESA, folder.file("buddha.xml"));
    const nicol::StokesImage truth = nicol::read_exr(data("mitsuba/buddha_plane_venice.exr"));
    const std::vector<float> shadowed = file.render(9, 1), plain = file.render(9, -1);
    const std::vector<char> mask = inner_pixels(file);
    const auto covered = std::count(mask.begin(), mask.end(), 1);
    CHECK(covered > 10000);
    // Of s0, s1 and s2, over the root mean square of the truth's s0.
    const auto relative_rmse = [&](const std::vector<float>& ours) {
        std::array<double, 3> error{};
        double size = 0;
        REQUIRE(ours.size() == truth.data.size());
        for (std::size_t i = 0; i < ours.size(); i += 4) {
            if (mask[i / 4 % mask.size()] == 0) continue;
            const auto at = [i](const std::vector<float>& v, std::size_t p) {
                return static_cast<double>(v[i + p]);
            };
            for (std::size_t p = 0; p < 3; ++p) error[p] += std::pow(at(ours, p) - at(truth.data, p), 2);
            size += std::pow(at(truth.data, 0), 2);
        }
        for (double& e : error) e = std::sqrt(e / size);
        return error;
    };
    const auto error = relative_rmse(shadowed), without = relative_rmse(plain);
    MESSAGE("relative RMSE s0 " << error[0] << " s1 " << error[1] << " s2 " << error[2]
                                << ", without shadows s0 " << without[0] << ", over " << covered
                                << " pixels");
    CHECK(error[0] < 0.03);
    CHECK(error[1] < 0.01);
    CHECK(error[2] < 0.01);
    // Shadows are what makes the image right.
    CHECK(without[0] > 3 * error[0]);
}
