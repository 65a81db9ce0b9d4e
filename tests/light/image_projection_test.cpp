// SPDX-License-Identifier: MIT
// Coefficients of images against independent integration.
#include "harmonics/evaluate.hpp"
#include "light/images.hpp"
#include "light/random_field.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Inner products of radiance() with the harmonics: five Gauss points a side in every cell between pixels.
PshVector brute_force(const Environment& light, int width, int height, int order) {
    constexpr double node[] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                               0.9061798459386640};
    constexpr double share[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                0.4786286704993665, 0.2369268850561891};
    PshVector result(order, light.channels());
    // Large cells are cut into small ones, where the rule is as good as exact for the harmonics.
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

EquirectImage image_of(const PshVector& field, int width, int height) {
    EquirectImage image(width, height, field.channels());
    for (int c = 0; c < field.channels(); ++c)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double u = (x + 0.5) / width;
                const double v = y / (height - 1.0);
                const glm::dvec3 along = -towards(u, v);
                const Stokes s = rotated(evaluate(field, c, along),
                                         angle_between(theta_phi_frame(along), pixel_frame(u, v)));
                for (std::size_t p = 0; p < 4; ++p)
                    image.at(c, y, x)[p] = static_cast<float>(s[static_cast<int>(p)]);
            }
    return image;
}

}  // namespace

TEST_CASE("the coefficients are those of the bilinear function that radiance() returns") {
    struct Case {
        int width, height, order;
    };
    // Even and odd sizes, fewer columns than degrees, and a prime width that takes the direct sums.
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

TEST_CASE("a constant image has the coefficients of constant light, at any resolution and order") {
    for (const auto& [width, height] : {std::pair{2, 2}, {5, 3}, {64, 33}, {101, 40}, {256, 128}}) {
        EquirectImage image(width, height, 1);
        for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = 1.5f;
        const PshVector f = image_environment(std::move(image))->project(20);
        CHECK(largest_difference(f, constant_environment({1.5})->project(20)) < 2e-13);
    }
}

TEST_CASE("a field of known harmonics comes back from its image, better the finer it is") {
    const PshVector field = random_field(4, 2);
    double previous = 0;
    for (const int height : {33, 65, 129}) {
        const auto light = image_environment(image_of(field, 2 * height - 2, height));
        CHECK(light->polarized());
        CHECK(light->circular());
        const double error = largest_difference(light->project(4), field);
        CHECK(error < 60.0 / (height * height));
        if (previous > 0) CHECK(previous / error == doctest::Approx(4).epsilon(0.05));
        previous = error;
    }
}

TEST_CASE("radiance() is what the coefficients of high order say, for smooth light") {
    const auto light = image_environment(image_of(random_field(3, 1), 128, 65));
    const PshVector f = light->project(24);
    for (const glm::dvec3& w : random_directions(60, 2))
        CHECK(glm::length(light->radiance(0, w) - evaluate(f, 0, -w)) < 1e-3);
}

TEST_CASE("the same image gives the same bits every time") {
    const auto light = image_environment(random_image(40, 300, 1, 6));
    const PshVector a = light->project(12);
    for (int i = 0; i < 3; ++i) CHECK(std::ranges::equal(a.data(), light->project(12).data()));
}
