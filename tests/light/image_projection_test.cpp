// SPDX-License-Identifier: MIT
// Tests of image coefficients against independent integration.
#include "harmonics/evaluate.hpp"
#include "light/images.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Returns the inner products of radiance() with the harmonics, by 5 x 5 Gauss points in every cell between
/// pixels.
PshVector brute_force(const Environment& light, int width, int height, int order) {
    constexpr double node[] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                               0.9061798459386640};
    constexpr double share[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                0.4786286704993665, 0.2369268850561891};
    PshVector result(order, light.channels());
    // Large cells are divided, so that the rule is practically exact for the harmonics.
    const int cuts_u = 1 + 16 / width;
    const int cuts_v = 1 + 24 / (height - 1);
    const double du = 1.0 / (width * cuts_u);
    const double dv = 1.0 / ((height - 1) * cuts_v);
    for (int j = 0; j < (height - 1) * cuts_v * 5; ++j) {
        for (int i = 0; i < width * cuts_u * 5; ++i) {
            const double u = 0.5 / width + (i / 5 + 0.5 + 0.5 * node[i % 5]) * du;
            const double v = (j / 5 + 0.5 + 0.5 * node[j % 5]) * dv;
            const double weight =
                share[i % 5] * share[j % 5] / 4 * (2 * pi * du) * (pi * dv) * std::sin(pi * v);
            add_products(result, light, -towards(u, v), weight);
        }
    }
    return result;
}

}  // namespace

TEST_CASE("the coefficients are those of the bilinear function that radiance() returns") {
    struct Case {
        int width, height, order;
    };
    // Sizes: even, odd, fewer columns than degrees, and a prime width that takes the direct sums.
    for (const auto& [width, height, order] :
         {Case{8, 5, 6}, {7, 4, 6}, {2, 2, 4}, {3, 9, 5}, {67, 3, 2}, {16, 2, 7}}) {
        CAPTURES(width, height);
        for (const bool polarized : {true, false}) {
            const auto light = image_environment(random_image(width, height, 2, 9, polarized));
            CHECK(light->polarized() == polarized);
            CHECK(largest_difference(light->project(order), brute_force(*light, width, height, order)) <
                  1e-9);
        }
    }
}

TEST_CASE("a channel of an image has the bits that it has alone") {
    for (const bool polarized : {true, false}) {
        const EquirectImage image = random_image(48, 25, 3, 4, polarized);
        const PshVector together = image_environment(image)->project(12);
        for (int c = 0; c < 3; ++c) {
            CAPTURE(c);
            EquirectImage one(48, 25, 1);
            const std::size_t size = one.data.size();
            std::copy_n(image.data.begin() + static_cast<std::ptrdiff_t>(size) * c, size, one.data.begin());
            const PshVector alone = image_environment(one)->project(12);
            CHECK(std::ranges::equal(together.channel(c), alone.channel(0)));
        }
    }
}

TEST_CASE("a constant image has the coefficients of constant light, at any resolution and order") {
    for (const auto& [width, height] : {std::pair{2, 2}, {5, 3}, {64, 33}, {101, 40}, {256, 128}}) {
        EquirectImage image(width, height, 1);
        for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = 1.5f;
        const PshVector f = image_environment(std::move(image))->project(20);
        CHECK(largest_difference(f, constant_environment({1.5})->project(20)) < 2e-13);
    }
}

TEST_CASE("the same image gives the same bits every time") {
    const auto light = image_environment(random_image(40, 300, 1, 6));
    const PshVector a = light->project(12);
    for (int i = 0; i < 3; ++i) CHECK(std::ranges::equal(a.data(), light->project(12).data()));
}
