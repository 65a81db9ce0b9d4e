// SPDX-License-Identifier: MIT
// Tests of the optimisations that skip work: the image is unchanged with each of them.
#include "capi.hpp"

using namespace capi_test;

namespace {

constexpr std::uint32_t every_skip[] = {NICOL_OPTIMISATION_UNCHANGED,     NICOL_OPTIMISATION_LIGHT_COMPONENTS,
                                        NICOL_OPTIMISATION_CHANNELS,      NICOL_OPTIMISATION_ORDERS,
                                        NICOL_OPTIMISATION_RESPONSE_ROWS, NICOL_OPTIMISATION_HIDDEN,
                                        NICOL_OPTIMISATION_UNOCCLUDED,    NICOL_OPTIMISATION_ALL};

/// Channels of a light.
enum class Channels { different, equal, multiples };

/// Returns unpolarized light of orders 0 to 3.
nicol_environment plain_light(nicol_context context, Channels channels_are) {
    constexpr std::uint32_t order = 3, channels = 3;
    constexpr std::size_t count = 4 * (order + 1) * (order + 1);
    std::vector<double> coefficients(channels * count);
    for (std::size_t c = 0; c < channels; ++c) {
        for (std::size_t i = 0; i < count; i += 4) {
            const bool differs = channels_are == Channels::different;
            const double wave = std::cos(static_cast<double>(i) + (differs ? static_cast<double>(c) : 0.0));
            const double factor = channels_are == Channels::multiples ? 0.3 + static_cast<double>(c) : 1.0;
            coefficients[c * count + i] = factor * (i == 0 ? 4 : 0.5 * wave);
        }
    }
    return make(nicol_environment_create_psh, context, order, channels, coefficients.data(),
                coefficients.size());
}

/// Two spheres that shadow each other, one of plastic and one diffuse.
struct Pair {
    Owned<nicol_scene> scene;
    Owned<nicol_framebuffer> framebuffer;
    nicol_camera camera = front_camera(5);

    Pair(nicol_context context, nicol_environment environment)
        : scene(empty_scene(context)), framebuffer(framebuffer_of(context, 64, 48, 3)) {
        OK(nicol_scene_set_environment(scene, environment, nullptr, 1));
        const Owned ball(sphere(context));
        const Owned wall(diffuse(context, {0.5F})), plastic(plastic_of(context));
        add(scene, ball, plastic, placed(-1.1, 0, 0));
        add(scene, ball, wall, placed(1.1, 0, 0));
    }
    [[nodiscard]] std::vector<float> render(const nicol_render_options& options) const {
        OK(nicol_render(scene, &camera, &options, framebuffer));
        return read_all(framebuffer);
    }
};

}  // namespace

CONTEXT_TEST_CASE("skips leave the image as it is, and count") {
    for (const Channels channels : {Channels::different, Channels::equal, Channels::multiples}) {
        const bool shares = channels != Channels::different;
        const Owned environment(plain_light(context, channels));
        const Pair pair(context, environment);
        nicol_render_options options = plain_options();
        options.bake_directions = 512;
        // A first picture bakes less than those after a change.
        options.disabled_optimisations = NICOL_OPTIMISATION_RAYS;
        const std::vector<float> skipping = pair.render(options);
        const double brightest = largest(skipping);
        CHECK(brightest > 0.01);
        const nicol_statistics skipped = statistics_of(pair.framebuffer);
        CHECK(skipped.light_columns_skipped > 0);
        CHECK(skipped.channels_shared == (shares ? 2 : 0));
        CHECK(skipped.order == 4);
        CHECK(skipped.vertices_skipped > 0);
        CHECK(skipped.vertices_unoccluded > 0);
        for (const std::uint32_t skip : every_skip) {
            CAPTURE(skip);
            options.disabled_optimisations = skip | NICOL_OPTIMISATION_RAYS;
            const auto off = [&](std::uint32_t which) { return (skip & which) != 0; };
            // Tables of other light have other interpolated angles, each with an error of up to 1e-5.
            // Light that is a multiple of another is rounded otherwise.
            const bool rounds = off(NICOL_OPTIMISATION_LIGHT_COMPONENTS) ||
                                (channels == Channels::multiples && off(NICOL_OPTIMISATION_CHANNELS));
            const double tolerance = rounds ? 1e-5 : 1e-6;
            CHECK(largest_difference(skipping, pair.render(options)) < tolerance * brightest);
            const nicol_statistics s = statistics_of(pair.framebuffer);
            CHECK(s.draw_ms > 0);
            CHECK((s.light_columns_skipped == 0) == off(NICOL_OPTIMISATION_LIGHT_COMPONENTS));
            CHECK((s.channels_shared == 0) == (off(NICOL_OPTIMISATION_CHANNELS) || !shares));
            CHECK(s.order == (off(NICOL_OPTIMISATION_ORDERS) ? 9 : 4));
            CHECK((s.vertices_skipped == 0) == off(NICOL_OPTIMISATION_HIDDEN));
            CHECK((s.vertices_unoccluded == 0) == off(NICOL_OPTIMISATION_UNOCCLUDED));
        }
        options.disabled_optimisations = NICOL_OPTIMISATION_RAYS;
        CHECK(pair.render(options) == skipping);
        CHECK(pair.render(options) == skipping);
        CHECK(statistics_of(pair.framebuffer).draw_ms == 0);
        options.disabled_optimisations |= NICOL_OPTIMISATION_UNCHANGED;
        CHECK(pair.render(options) == skipping);
        CHECK(pair.render(options) == skipping);
        CHECK(statistics_of(pair.framebuffer).draw_ms > 0);
    }
}

STAGE_TEST_CASE("components that nobody asked for are 0 and the others the same") {
    nicol_render_options options = plain_options();
    const auto render = [&](nicol_components components) {
        options.components = components;
        return stage.image(options);
    };
    const std::vector<float> all = render(NICOL_COMPONENTS_ALL);
    CHECK(std::ranges::any_of(all, [](float value) { return value < 0; }));  // from s1 or s2
    for (const nicol_components components : {NICOL_COMPONENTS_S0, NICOL_COMPONENTS_LINEAR}) {
        const std::vector<float> some = render(components);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            wrong += some[i] != (i % 4 < components ? all[i] : 0.0F) ? 1 : 0;
        CHECK(wrong == 0);
    }
}
