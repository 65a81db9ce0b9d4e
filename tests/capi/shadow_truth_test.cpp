// SPDX-License-Identifier: MIT
// A statue that shadows itself and the plane it stands on, against Mitsuba 3.
#include <array>
#include <cmath>
#include <cstdlib>

#include "capi.hpp"
#include "image/stokes_image.hpp"

using namespace capi_test;

namespace {

struct Scene {
    nicol_context context = make_context(NICOL_BACKEND_OSMESA);
    nicol_scene scene = nullptr;
    nicol_camera camera = NICOL_CAMERA_INIT;
    nicol_framebuffer framebuffer = nullptr;
    std::uint32_t width = 0, height = 0;

    explicit Scene(const std::string& file) {
        OK(nicol_scene_load(context, file.c_str(), nullptr, 0, &scene));
        OK(nicol_scene_get_camera(scene, &camera));
        OK(nicol_scene_get_film_size(scene, &width, &height));
        OK(nicol_framebuffer_create(context, width, height, 3, &framebuffer));
    }
    ~Scene() {
        CHECK(nicol_framebuffer_release(framebuffer) == NICOL_OK);
        CHECK(nicol_scene_release(scene) == NICOL_OK);
        CHECK(nicol_context_release(context) == NICOL_OK);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// [channel][pixel][component]
    [[nodiscard]] std::vector<float> render(std::int32_t order, std::int32_t shadows) const {
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        options.order_low = order;
        options.high_orders = NICOL_HIGH_ORDERS_NONE;
        options.shadows = shadows;
        OK(nicol_render(scene, &camera, &options, framebuffer));
        return read_all(framebuffer);
    }

    /// 1 where a pixel and its eight neighbours show the same object. Under even light without shadows the
    /// background is 1, the plane grey and the statue coloured. Sets the scene's light to that.
    [[nodiscard]] std::vector<char> inner_pixels() const {
        nicol_environment even = constant_light(context, {1, 1, 1});
        OK(nicol_scene_set_environment(scene, even, nullptr, 0));
        OK(nicol_environment_release(even));
        const std::vector<float> image = render(-1, -1);
        const std::size_t pixels = std::size_t{width} * height;
        std::vector<int> object(pixels);
        for (std::size_t i = 0; i < pixels; ++i) {
            const float red = image[4 * i], blue = image[4 * (2 * pixels + i)];
            const bool background = red > 0.9999F && blue > 0.9999F;
            object[i] = background ? 0 : red - blue < 0.01F ? 1 : 2;
        }
        std::vector<char> inner(pixels, 0);
        for (std::size_t y = 1; y + 1 < height; ++y) {
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
};

/// Of s0, s1 and s2, over the root mean square of the truth's s0.
std::array<double, 3> relative_rmse(const std::vector<float>& ours, const nicol::StokesImage& truth,
                                    const std::vector<char>& mask) {
    std::array<double, 3> error{};
    double size = 0;
    REQUIRE(ours.size() == truth.data.size());
    for (std::size_t i = 0; i < ours.size(); i += 4) {
        if (mask[i / 4 % mask.size()] == 0) continue;
        for (std::size_t p = 0; p < 3; ++p)
            error[p] +=
                std::pow(static_cast<double>(ours[i + p]) - static_cast<double>(truth.data[i + p]), 2);
        size += std::pow(static_cast<double>(truth.data[i]), 2);
    }
    for (double& e : error) e = std::sqrt(e / size);
    return error;
}

}  // namespace

TEST_CASE("a statue on a plane, with shadows, is Mitsuba 3's, but for truncation and noise") {
    namespace fs = std::filesystem;
    const char* given = std::getenv("NICOL_TEST_DATA");
    const fs::path data = fs::absolute(given != nullptr ? given : "");
    if (!fs::exists(data / "mitsuba/buddha.xml") || !fs::exists(data / "polarsh/buddha.obj")) {
        MESSAGE("skipped: NICOL_TEST_DATA has no mitsuba/buddha.xml or polarsh/buddha.obj");
        return;
    }
    const TemporaryFolder folder;
    for (const char* file :
         {"mitsuba/buddha.xml", "mitsuba/venice.exr", "polarsh/buddha.obj", "polarsh/plane.obj"})
        fs::create_symlink(data / file, folder.file(fs::path(file).filename().string()));
    const Scene scene(folder.file("buddha.xml"));
    const nicol::StokesImage truth = nicol::read_exr((data / "mitsuba/buddha_plane_venice.exr").string());

    const std::vector<float> shadowed = scene.render(9, 1);
    const std::vector<float> plain = scene.render(9, -1);
    const std::vector<char> mask = scene.inner_pixels();
    const auto covered = std::count(mask.begin(), mask.end(), 1);
    CHECK(covered > 10000);

    const auto error = relative_rmse(shadowed, truth, mask);
    const auto without = relative_rmse(plain, truth, mask);
    MESSAGE("relative RMSE s0 " << error[0] << " s1 " << error[1] << " s2 " << error[2]
                                << ", without shadows s0 " << without[0] << ", over " << covered
                                << " pixels");
    CHECK(error[0] < 0.03);
    CHECK(error[1] < 0.01);
    CHECK(error[2] < 0.01);
    // Shadows are what makes the image right.
    CHECK(without[0] > 3 * error[0]);
}
