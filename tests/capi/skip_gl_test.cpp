// SPDX-License-Identifier: MIT
// What a render may leave out: with every skip the image is the same as without it.
#include <algorithm>
#include <cmath>

#include "capi.hpp"

using namespace capi_test;

namespace {

constexpr std::uint32_t every_skip[] = {NICOL_OPTIMISATION_UNCHANGED,     NICOL_OPTIMISATION_LIGHT_COMPONENTS,
                                        NICOL_OPTIMISATION_CHANNELS,      NICOL_OPTIMISATION_ORDERS,
                                        NICOL_OPTIMISATION_RESPONSE_ROWS, NICOL_OPTIMISATION_HIDDEN,
                                        NICOL_OPTIMISATION_UNOCCLUDED,    NICOL_OPTIMISATION_ALL};

float largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
    REQUIRE(a.size() == b.size());
    float largest = 0, scale = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
        scale = std::max(scale, std::abs(a[i]));
    }
    CHECK(scale > 0.01F);
    return largest / scale;
}

/// Unpolarized, of orders 0 to 3; grey: the same in every channel.
nicol_environment plain_light(nicol_context context, bool grey) {
    constexpr std::uint32_t order = 3, channels = 3;
    constexpr std::size_t count = 4 * (order + 1) * (order + 1);
    std::vector<double> coefficients(channels * count);
    for (std::size_t c = 0; c < channels; ++c) {
        for (std::size_t i = 0; i < count; i += 4) {
            const double wave = std::cos(static_cast<double>(i) + (grey ? 0.0 : static_cast<double>(c)));
            coefficients[c * count + i] = i == 0 ? 4 : 0.5 * wave;
        }
    }
    nicol_environment environment = nullptr;
    OK(nicol_environment_create_psh(context, order, channels, coefficients.data(), coefficients.size(),
                                    &environment));
    return environment;
}

/// Two spheres that shadow each other, one of plastic and one diffuse.
struct Pair {
    nicol_scene scene = nullptr;
    nicol_framebuffer framebuffer = nullptr;
    nicol_camera camera = front_camera(5);

    Pair(nicol_context context, nicol_environment environment) {
        OK(nicol_scene_create(context, &scene));
        OK(nicol_scene_set_environment(scene, environment, nullptr, 1));
        nicol_mesh sphere = nullptr;
        OK(nicol_mesh_create_sphere(context, &sphere));
        nicol_material plastic = nullptr, wall = nullptr;
        const nicol_pplastic parameters = NICOL_PPLASTIC_INIT;
        OK(nicol_material_create_pplastic(context, &parameters, &plastic));
        const nicol_spectrum half = spectrum({0.5F});
        OK(nicol_material_create_diffuse(context, &half, &wall));
        for (const double x : {-1.1, 1.1}) {
            nicol_instance instance = NICOL_INSTANCE_INIT;
            instance.mesh = sphere;
            instance.material = x < 0 ? plastic : wall;
            std::copy_n(placed(x, 0, 0).rows, 16, instance.to_world);
            OK(nicol_scene_add_instance(scene, &instance, nullptr));
        }
        OK(nicol_mesh_release(sphere));
        OK(nicol_material_release(plastic));
        OK(nicol_material_release(wall));
        OK(nicol_framebuffer_create(context, 64, 48, 3, &framebuffer));
    }
    ~Pair() {
        CHECK(nicol_framebuffer_release(framebuffer) == NICOL_OK);
        CHECK(nicol_scene_release(scene) == NICOL_OK);
    }
    Pair(const Pair&) = delete;
    Pair& operator=(const Pair&) = delete;

    [[nodiscard]] std::vector<float> render(const nicol_render_options& options) const {
        OK(nicol_render(scene, &camera, &options, framebuffer));
        return read_all(framebuffer);
    }
    [[nodiscard]] nicol_statistics statistics() const {
        const nicol_statistics s = statistics_of(framebuffer);
        return s;
    }
};

}  // namespace

TEST_CASE("skips leave the image as it is, and count") {
    on_every_backend([](nicol_context context) {
        for (const bool grey : {false, true}) {
            const Owned environment(plain_light(context, grey));
            const Pair pair(context, environment);
            nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
            options.bake_directions = 512;
            const std::vector<float> skipping = pair.render(options);
            const nicol_statistics skipped = pair.statistics();
            CHECK(skipped.light_columns_skipped > 0);
            CHECK(skipped.channels_shared == (grey ? 2 : 0));
            CHECK(skipped.order == 4);
            CHECK(skipped.vertices_skipped > 0);
            CHECK(skipped.vertices_unoccluded > 0);
            for (const std::uint32_t skip : every_skip) {
                CAPTURE(skip);
                options.disabled_optimisations = skip;
                CHECK(largest_difference(skipping, pair.render(options)) < 1e-6F);
                const nicol_statistics s = pair.statistics();
                CHECK(s.draw_ms > 0);
                const auto off = [&](std::uint32_t which) { return (skip & which) != 0; };
                CHECK((s.light_columns_skipped == 0) == off(NICOL_OPTIMISATION_LIGHT_COMPONENTS));
                CHECK((s.channels_shared == 0) == (off(NICOL_OPTIMISATION_CHANNELS) || !grey));
                CHECK(s.order == (off(NICOL_OPTIMISATION_ORDERS) ? 9 : 4));
                CHECK((s.vertices_skipped == 0) == off(NICOL_OPTIMISATION_HIDDEN));
                CHECK((s.vertices_unoccluded == 0) == off(NICOL_OPTIMISATION_UNOCCLUDED));
            }
            options.disabled_optimisations = 0;
            CHECK(pair.render(options) == skipping);
            CHECK(pair.render(options) == skipping);
            CHECK(pair.statistics().draw_ms == 0);
            options.disabled_optimisations = NICOL_OPTIMISATION_UNCHANGED;
            CHECK(pair.render(options) == skipping);
            CHECK(pair.render(options) == skipping);
            CHECK(pair.statistics().draw_ms > 0);
        }
    });
}

TEST_CASE("components that nobody asked for are 0 and the others the same") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        const auto render = [&](nicol_components components) {
            options.components = components;
            OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
            return read_all(stage.framebuffer);
        };
        const std::vector<float> all = render(NICOL_COMPONENTS_ALL);
        CHECK(std::ranges::any_of(all, [](float value) { return value < 0; }));  // s1 or s2
        for (const nicol_components components : {NICOL_COMPONENTS_S0, NICOL_COMPONENTS_LINEAR}) {
            const std::vector<float> some = render(components);
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < all.size(); ++i)
                wrong += some[i] != (i % 4 < components ? all[i] : 0.0F) ? 1 : 0;
            CHECK(wrong == 0);
        }
    });
}

TEST_CASE("a tolerance chooses the orders and says what it expects") {
    const Owned context(make_context(NICOL_BACKEND_OSMESA));
    const Stage stage(context);
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.order_low = 12;  // not looked at
    std::uint32_t before = 0;
    std::uint32_t first = 0;
    for (const double tolerance : {0.5, 0.02, 0.001}) {
        options.tolerance = tolerance;
        OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
        const nicol_statistics s = statistics_of(stage.framebuffer);
        CHECK(s.predicted_error <= tolerance);
        CHECK(s.order >= before);
        CHECK(s.order_low <= s.order);
        before = s.order;
        if (tolerance == 0.5) first = s.order;
    }
    CHECK(before > first);
}

TEST_CASE("options that mean nothing are refused by name") {
    const Owned context(make_context(NICOL_BACKEND_OSMESA));
    const Stage stage(context);
    const auto refused = [&](auto&& change, const char* name) {
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        change(options);
        FAILS(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer),
              NICOL_ERROR_INVALID_ARGUMENT, name);
    };
    for (const double bad : {-1.0, std::nan(""), HUGE_VAL})
        refused([&](auto& o) { o.tolerance = bad; }, "tolerance");
    refused([](auto& o) { o.components = 2; }, "components");
    refused([](auto& o) { o.disabled_optimisations = 128; }, "disabled_optimisations");
    refused([](auto& o) { o.tolerance = 0.1, o.method = NICOL_METHOD_DENSE; }, "tolerance");
    refused([](auto& o) { o.tolerance = 0.1, o.high_orders = NICOL_HIGH_ORDERS_CONVOLUTION; }, "tolerance");
}
