// SPDX-License-Identifier: MIT
// A test of a partly occluded highlight against the reference method.
#include "capi.hpp"

using namespace capi_test;

namespace {

constexpr std::uint32_t side = 40, fine = 3 * side;

// Returns a lamp 20 degrees wide on the left, half way towards the camera, in a dim room.
nicol_environment lamp(nicol_context context) {
    constexpr std::uint32_t width = 128, height = 65;
    const glm::dvec3 centre = glm::normalize(glm::dvec3(-0.7, 0.1, 0.7));
    std::vector<float> pixels;
    for (std::uint32_t i = 0; i < width * height; ++i) {
        const double u = 2 * pi * (i % width + 0.5) / width, v = pi * (i / width) / (height - 1.0);
        const double cosine =
            glm::dot(centre, {std::sin(u) * std::sin(v), std::cos(v), -std::cos(u) * std::sin(v)});
        pixels.push_back(static_cast<float>(0.1 + 30 * std::exp((cosine - 1) / 0.03)));
    }
    const nicol_image image = image_of(pixels, width, height, 1, 1);
    return make(nicol_environment_create_image, context, &image);
}

/// Returns a scene of the unit sphere in plastic and a black wall on its left. The wall reaches from far
/// behind the sphere to z = `end`.
nicol_scene sphere_beside_wall(nicol_context context, double end) {
    const Owned light(lamp(context));
    nicol_pplastic parameters = NICOL_PPLASTIC_INIT;
    parameters.distribution = NICOL_DISTRIBUTION_GGX;
    parameters.alpha = 0.2F;
    parameters.diffuse_reflectance = spectrum({0.05F});
    const Owned plastic(plastic_of(context, parameters)), black(diffuse(context, {0}));
    const Owned ball(sphere(context)), wall(rectangle(context));
    const nicol_scene scene = simple_scene(context, light, ball, plastic);
    // The transform maps the wall's z to the world's x and its x to the world's -z, and scales by 8.
    add(scene, wall, black, {{0, 0, 1, -1.6, 0, 8, 0, 0, -8, 0, 0, end - 8, 0, 0, 0, 1}});
    return scene;
}

using Values = std::vector<double>;

/// Renders rows^2 pixels and averages them down to [row][column][component] with `side` rows.
Values image(nicol_context context, nicol_scene scene, const nicol_render_options& options,
             std::uint32_t rows) {
    const Owned framebuffer(framebuffer_of(context, rows, rows, 1));
    nicol_camera camera = front_camera(8);
    camera.fov = 15;
    OK(nicol_render(scene, &camera, &options, framebuffer));
    const std::vector<float> pixels = read_plane(framebuffer, NICOL_PLANE_STOKES);
    const std::size_t square = rows / side;
    Values mean(std::size_t{4} * side * side);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t y = i / 4 / rows / square, x = i / 4 % rows / square;
        mean[4 * (y * side + x) + i % 4] +=
            static_cast<double>(pixels[i]) / static_cast<double>(square * square);
    }
    return mean;
}

Values real_time(nicol_context context, nicol_scene scene, std::uint32_t high, std::uint32_t shadows,
                 std::uint32_t high_order_shadows = 1) {
    nicol_render_options options = plain_options();
    options.high_order_shadows = high_order_shadows;
    options.order_low = 4;
    options.order_high = high;
    options.shadows = shadows;
    return image(context, scene, options, fine);
}

}  // namespace

TEST_CASE("a highlight half behind a wall is dimmed as the reference has it") {
    const Owned context(make_context(NICOL_BACKEND_OSMESA));
    // The edge of the wall's shadow crosses the highlight, or the shadow covers nearly all of it.
    for (const double end : {2.1, 2.6}) {
        CAPTURE(end);
        const Owned scene(sphere_beside_wall(context, end));
        nicol_render_options reference = NICOL_RENDER_OPTIONS_INIT;
        reference.method = NICOL_METHOD_REFERENCE;
        reference.samples = 256;
        const Values truth = image(context, scene, reference, side);
        const Values dimmed = real_time(context, scene, 32, 1);
        // Light is additive: `undimmed` is low orders in shadow plus high orders without shadow.
        Values undimmed = real_time(context, scene, 4, 1);
        const Values low = real_time(context, scene, 4, 0), all = real_time(context, scene, 32, 0);
        double brightest = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            undimmed[i] += all[i] - low[i];
            brightest = std::max(brightest, all[i]);
        }
        const Values asked = real_time(context, scene, 32, 1, 0);
        for (std::size_t i = 0; i < all.size(); ++i)
            REQUIRE(std::abs(asked[i] - undimmed[i]) < 1e-5 * brightest);
        std::vector<bool> highlight(all.size() / 4);
        for (std::size_t i = 0; i < highlight.size(); ++i) highlight[i] = all[4 * i] > 0.3 * brightest;
        const auto count = std::count(highlight.begin(), highlight.end(), true);
        CHECK(count > 30);

        const Distance with(dimmed, truth, highlight), without(undimmed, truth, highlight);
        const auto linear = [](const Distance& d) { return std::hypot(d.error[1], d.error[2]); };
        MESSAGE("wall to " << end << ", " << count << " pixels: s0 " << with.error[0] / with.size[0]
                           << " (undimmed " << without.error[0] / with.size[0] << "), s1 and s2 "
                           << linear(with) / with.size[0] << " (undimmed " << linear(without) / with.size[0]
                           << ")");
        CHECK(with.error[0] < 0.75 * without.error[0]);
        CHECK(linear(with) < 0.75 * linear(without));
    }
}
