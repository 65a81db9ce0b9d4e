// SPDX-License-Identifier: MIT
// Tests of pixel backgrounds against the radiance of environments in single directions.
#include "shading/background.hpp"

#include "polarization/viewpoint.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Returns light of columns x rows random texels with 1 (unpolarized) or 4 components.
std::shared_ptr<const Environment> random_light(int columns, int rows, int channels, int components) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> number(-0.5F, 0.5F);
    EquirectImage image(columns, rows, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        const bool s0 = i % 4 == 0;
        if (s0 || components == 4) image.data[i] = s0 ? 2 + number(random) : number(random);
    }
    return image_environment(image);
}

constexpr std::size_t kColumns = 13;
constexpr std::size_t kRows = 9;

}  // namespace

TEST_CASE("the background of a pixel is the environment's light in the camera's frame") {
    for (const int components : {1, 4})
        for (const auto& [of_light, channels] : {std::pair(1, 1), {1, 3}, {3, 3}, {6, 6}})
            for (const double pitch : {0.0, 0.7, -1.2, 3.0}) {
                CAPTURES(components, of_light, channels, pitch);
                const auto light = random_light(24, 13, of_light, components);
                const Background background(*light, channels);
                // The views are about the horizon, near and beyond the poles, and backwards.
                Viewpoint view{.forward = {0.3, std::sin(pitch), std::cos(pitch)}, .up = {0, 1, 0.1}};
                view.forward = glm::normalize(view.forward);
                view.right = glm::normalize(glm::cross(view.forward, view.up));
                view.up = glm::cross(view.right, view.forward);
                const PixelRays rays{.first = view.forward - 0.9 * view.right + 0.8 * view.up,
                                     .right = 0.15 * view.right,
                                     .down = -0.2 * view.up,
                                     .up = view.up,
                                     .width = kColumns};
                std::vector<std::vector<glm::vec4>> pixels(
                    static_cast<std::size_t>(channels),
                    std::vector<glm::vec4>(kColumns * kRows, {1, 2, 3, 4}));
                const std::vector<std::span<glm::vec4>> out(pixels.begin(), pixels.end());
                const std::size_t first = 5;
                const std::size_t last = kColumns * kRows - 3;
                std::vector<float> coverage(last - first);
                for (std::size_t i = 0; i < coverage.size(); ++i) coverage[i] = static_cast<float>(i % 5) / 4;
                const std::size_t wanted = channels == 6 ? 3 : 4;
                background.add(rays, 0.5F, wanted, first, last, coverage, out);
                for (std::size_t i = 0; i < kColumns * kRows; ++i) {
                    const bool inside = i >= first && i < last;
                    const double weight = inside ? 0.5 * (1 - static_cast<double>(coverage[i - first])) : 0;
                    const glm::dvec3 ray = glm::normalize(
                        glm::dvec3(rays.first) + static_cast<double>(i % kColumns) * glm::dvec3(rays.right) +
                        static_cast<double>(i / kColumns) * glm::dvec3(rays.down));
                    const double angle = angle_between(theta_phi_frame(-ray), view.frame(-ray));
                    for (std::size_t c = 0; c < pixels.size(); ++c) {
                        const int of = of_light == 1 ? 0 : static_cast<int>(c);
                        const Stokes expected = weight * rotated(light->radiance(of, ray), angle);
                        for (std::size_t p = 0; p < 4; ++p) {
                            const auto k = static_cast<glm::length_t>(p);
                            const double added =
                                static_cast<double>(pixels[c][i][k]) - static_cast<double>(p + 1);
                            CHECK(std::abs(added - (p < wanted ? expected[k] : 0)) < 1e-5);
                        }
                    }
                }
            }
}

TEST_CASE("straight up and down the background is its first and last row") {
    const auto light = random_light(8, 5, 1, 1);
    const Background background(*light, 1);
    for (const float y : {1.0F, -1.0F}) {
        std::vector<glm::vec4> pixel(1, glm::vec4(0));
        const std::span<glm::vec4> out[] = {pixel};
        background.add({.first = {0, y, 0}, .right = {}, .down = {}, .up = {0, 0, 1}, .width = 1}, 1, 4, 0, 1,
                       std::vector<float>{0}, out);
        const EquirectImage image = light->image();
        float least = 1e9F;
        float most = 0;
        for (int x = 0; x < 8; ++x) {
            least = std::min(least, image.at(0, y > 0 ? 0 : 4, x)[0]);
            most = std::max(most, image.at(0, y > 0 ? 0 : 4, x)[0]);
        }
        CHECK(pixel[0].x >= least);
        CHECK(pixel[0].x <= most);
    }
}
