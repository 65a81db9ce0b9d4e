// SPDX-License-Identifier: MIT
// Tests of the reference method's noise estimate against actual noise.
#include "reference/pixel_estimate.hpp"
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

struct Rendered {
    StokesImage image;
    Aovs aovs;
};

Rendered render_with_variance(const Scene& scene, const Camera& camera, int side, ReferenceOptions options,
                              Strategy strategy = Strategy::both) {
    options.aovs = aov_variance;
    ReferenceStatistics statistics;
    Rendered out;
    out.image = render_reference(scene, project(camera, side, side), side, side, options, statistics,
                                 strategy, &out.aovs);
    return out;
}

EnvironmentPtr lamp() {
    EquirectImage image(32, 17, 3);
    for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = 1;
    for (int c = 0; c < 3; ++c) image.at(c, 5, 20)[0] = static_cast<float>(200 * (1 + c));
    return image_environment(image);
}

Scene ball_on_floor(EnvironmentPtr light) {
    Scene scene;
    const Frame floor(glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0));
    scene.add(square(pplastic({.diffuse_reflectance = {0.4}, .alpha = 0.3}), floor, {0, -1, 0}, 6));
    // A coarse sphere, because the scene is prepared for rays for each of hundreds of pictures.
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere(glm::dvec3(0.0), 1, 0.15)),
               .material = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.2}),
               .to_world = glm::dmat4(1.0)});
    scene.set_environment(std::move(light), glm::dmat3(1.0), 1);
    return scene;
}

Camera camera() {
    Camera out;
    out.to_world = look_at({1.5, 1.5, 3}, {0, -0.4, 0}, {0, 1, 0});
    return out;
}

/// Sums over pixels and channels for each Stokes component.
using Sums = std::array<double, 4>;

struct OverSeeds {
    Sums scatter{};   ///< variance over images of different seeds
    Sums estimate{};  ///< mean of the images' own estimates
};

OverSeeds over_seeds(const Scene& scene, ReferenceOptions options, std::uint64_t seeds) {
    std::vector<double> sum, square;
    OverSeeds out;
    for (options.seed = 0; options.seed < seeds; ++options.seed) {
        const auto [image, aovs] = render_with_variance(scene, camera(), 16, options);
        sum.resize(image.data.size());
        square.resize(image.data.size());
        REQUIRE(aovs.channels == image.channels);
        REQUIRE(aovs.variance.size() == image.data.size());
        for (std::size_t i = 0; i < image.data.size(); ++i) {
            sum[i] += image.data[i];
            square[i] += std::pow(static_cast<double>(image.data[i]), 2);
            out.estimate[i % 4] += aovs.variance[i] / static_cast<double>(seeds);
        }
    }
    const auto n = static_cast<double>(seeds);
    for (std::size_t i = 0; i < sum.size(); ++i)
        out.scatter[i % 4] += (square[i] - sum[i] * sum[i] / n) / (n - 1);
    return out;
}

}  // namespace

TEST_CASE("of independent samples the variance of the mean is estimated without bias") {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const Stokes deviation(3, 1, 0.1, 0);
    constexpr int trials = 20000;
    for (const int samples : {2, 3, 4, 5, 16, 19}) {
        Stokes mean(0.0), estimate(0.0), squares(0.0);
        for (int trial = 0; trial < trials; ++trial) {
            PixelEstimate pixel(samples, 2);
            CHECK(pixel.groups() == std::min(samples, 4));
            Stokes sums[2] = {Stokes(0.0), Stokes(5.0)};
            for (int g = 0; g < pixel.groups(); ++g) {
                for (int i = pixel.first(g); i < pixel.first(g + 1); ++i) {
                    for (int p = 0; p < 4; ++p) sums[0][p] += 10 + deviation[p] * normal(random);
                }
                pixel.record(g, sums);
            }
            CHECK(glm::distance(pixel.mean(0), sums[0] / double{1.0 * samples}) < 1e-12);
            CHECK(pixel.mean(1)[0] == 5.0 / samples);
            const Stokes variance = pixel.variance(0);
            mean += variance / double{trials};
            squares += variance * variance / double{trials};
            estimate = deviation * deviation / double{1.0 * samples};
        }
        for (int p = 0; p < 4; ++p) {
            CAPTURES(samples, p);
            const double error = std::sqrt((squares[p] - mean[p] * mean[p]) / trials);
            CHECK(std::abs(mean[p] - estimate[p]) <= 4 * error);
        }
    }
}

TEST_CASE("the variance is what groups of samples scatter more than all do, and no less than the noise") {
    // With v(n) the variance of images of n samples over seeds, the estimate is (v(n / 4) - v(n)) / 3.
    constexpr int samples = 16;
    constexpr std::uint64_t seeds = 64;
    for_all({false, true}, {false, true}, [&](bool smooth, bool luminance) {
        const Scene scene = ball_on_floor(smooth ? rayleigh_sky({.sun_direction = {1, 1, 1}}) : lamp());
        const OverSeeds whole = over_seeds(scene, {.samples = samples, .luminance = luminance}, seeds);
        const OverSeeds group = over_seeds(scene, {.samples = samples / 4, .luminance = luminance}, seeds);
        for (std::size_t p = 0; p < 3; ++p) {
            CAPTURES(smooth, luminance, p);
            const double wanted = (group.scatter[p] - whole.scatter[p]) / 3;
            MESSAGE((smooth ? "sky" : "lamp")
                    << ", s" << p << ": " << (whole.estimate[p] / wanted) << " of what is expected, "
                    << (whole.estimate[p] / whole.scatter[p]) << " of the noise");
            CHECK(whole.estimate[p] == doctest::Approx(wanted).epsilon(0.15));
            CHECK(whole.estimate[p] > whole.scatter[p]);
            CHECK(whole.estimate[p] < 3 * whole.scatter[p]);
        }
    });
}

TEST_CASE("light without noise has no variance, and even light on a diffuse ball little") {
    Scene scene;
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()),
               .material = diffuse({0.5}),
               .to_world = glm::dmat4(1.0)});
    scene.set_environment(constant_environment({3}), glm::dmat3(1.0), 1);
    Camera view;
    view.to_world = look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0});
    constexpr int side = 32;
    const auto [image, aovs] = render_with_variance(scene, view, side, {.samples = 64});
    const auto [even, no_noise] =
        render_with_variance(scene, camera_on({0, 0, 1}, {0, 0, 1}), 4, {.samples = 64}, Strategy::surface);
    for (std::size_t i = 0; i < no_noise.variance.size(); ++i) CHECK(no_noise.variance[i] < 1e-20F);
    int inside = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const float* variance = &aovs.variance[static_cast<std::size_t>(4 * (y * side + x))];
            for (int p = 1; p < 4; ++p) CHECK(variance[p] == 0);
            const double from_middle = std::hypot(x + 0.5 - side / 2.0, y + 0.5 - side / 2.0) / side;
            // The ball's outline is 0.31 from the middle.
            if (from_middle > 0.36) CHECK(variance[0] == 0);
            if (from_middle > 0.25) continue;
            ++inside;
            CHECK(variance[0] > 0);
            CHECK(std::sqrt(variance[0]) < 0.03F * image.at(0, y, x)[0]);
        }
    }
    CHECK(inside > 100);
}

TEST_CASE("the variance leaves the image as it is, and bright light's is finite") {
    for (const int samples : {2, 5, 600}) {
        CAPTURE(samples);
        Scene scene = ball_on_floor(lamp());
        const auto with = render_with_variance(scene, camera(), 8, {.samples = samples});
        CHECK(with.aovs.mask() == aov_variance);
        CHECK(with.image.data == render(scene, camera(), 8, 8, {.samples = samples}).data);
        CHECK(largest(with.aovs.variance) > 0);
        scene.set_environment(lamp(), glm::dmat3(1.0), 1e26);
        const auto bright = render_with_variance(scene, camera(), 8, {.samples = samples}).aovs.variance;
        CHECK(largest(bright) == std::numeric_limits<float>::max());
    }
}

TEST_CASE("one sample has no variance, and only three channels have a luminance") {
    const Scene scene = ball_on_floor(lamp());
    check_error(ErrorCode::invalid_argument, CALL(render_with_variance(scene, camera(), 8, {.samples = 1})),
                "samples is 1", "variance");
    Scene grey;
    grey.add(square(diffuse({0.5})));
    check_error(ErrorCode::invalid_argument, CALL(render(grey, camera(), 8, 8, {.luminance = true})),
                "three channels");
}
