// SPDX-License-Identifier: MIT
// High orders looked up at pixels.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::falling_light;
using test::minus;
using test::rms;
using test::Studio;

namespace {

constexpr int width = 64;
constexpr int height = 48;

MaterialPtr metal() {
    static const MaterialPtr material = test::some_metal(0.1);
    return material;
}

Scene lone(const std::shared_ptr<const Mesh>& mesh, const EnvironmentPtr& light,
           const MaterialPtr& material = metal()) {
    Scene scene;
    scene.add({.mesh = mesh, .material = material});
    scene.set_environment(light, theta_phi_frame(glm::normalize(glm::dvec3(1, -2, 0.7))), 0.7);
    return scene;
}

/// A metal sphere over a plastic plate that has two sides.
Scene sphere_on_plate(const EnvironmentPtr& light, const std::shared_ptr<const Mesh>& sphere, int cells) {
    static const MaterialPtr plastic = twosided(pplastic({.diffuse_reflectance = {0.4}, .alpha = 0.3}));
    Scene scene = lone(sphere, light);
    scene.add({.mesh = test::rectangle(cells), .material = plastic, .to_world = test::plate_at(-1, 3)});
    return scene;
}

RenderOptions at(HighOrdersAt where, HighOrders form = HighOrders::split, bool shadows = false) {
    return {.shadows = shadows,
            .bake_directions = 256,
            .order_low = 2,
            .order_high = 9,
            .high_orders = form,
            .high_orders_at = where};
}

/// Root mean square of the difference where `part` is true of the pixel, of Stokes component p.
template <class Part>
double difference(const StokesImage& a, const StokesImage& b, std::size_t p, Part part) {
    double sum = 0;
    int count = 0;
    for (int c = 0; c < a.channels; ++c) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (!part(x, y)) continue;
                sum += std::pow(a.at(c, y, x)[p] - b.at(c, y, x)[p], 2);
                ++count;
            }
        }
    }
    REQUIRE(count > 100);
    return std::sqrt(sum / count);
}

/// Well inside the unit sphere's image.
bool inside_sphere(int x, int y) {
    // It covers asin(1 / sqrt(29)) of half of 40 degrees across.
    const double radius =
        width / 2.0 * std::tan(std::asin(1 / std::sqrt(29.0))) / std::tan(glm::radians(20.0));
    return std::hypot(x + 0.5 - width / 2.0, y + 0.5 - height / 2.0) < 0.85 * radius;
}

}  // namespace

GL_TEST_CASE("where vertices are dense, pixels make what they make") {
    Studio render(context);
    for (const HighOrders form : {HighOrders::split, HighOrders::convolution}) {
        for (const auto& [channels, polarized] : {std::pair(1, true), {3, false}, {6, true}}) {
            CAPTURES(channels, polarized, form);
            const Scene scene = lone(test::fine_sphere(), falling_light(9, polarized, channels));
            const StokesImage pixels = render(scene, at(HighOrdersAt::pixels, form));
            CHECK(render.statistics.high_orders_at == HighOrdersAt::pixels);
            const StokesImage vertices = render(scene, at(HighOrdersAt::vertices, form));
            CHECK(render.statistics.high_orders_at == HighOrdersAt::vertices);
            const StokesImage none = render(scene, at(HighOrdersAt::pixels, HighOrders::none));
            CHECK(render.statistics.high_orders_at == HighOrdersAt::automatic);
            for (std::size_t p = 0; p < (polarized ? 4U : 3U); ++p) {
                if (p > 0 && !polarized && form == HighOrders::convolution) continue;  // all zero
                CAPTURE(p);
                const double all = difference(pixels, none, p, inside_sphere);
                CHECK(all > 1e-3);
                CHECK(difference(pixels, vertices, p, inside_sphere) < 0.02 * all);
            }
        }
    }
}

GL_TEST_CASE("where vertices are far apart, pixels come much nearer to the smooth surface") {
    Studio render(context);
    Studio render_smooth(context);
    for (const bool polarized : {false, true}) {
        const EnvironmentPtr light = falling_light(9, polarized);
        const Scene smooth = lone(test::fine_sphere(), light);
        const Scene coarse = lone(test::coarse_sphere(6), light);
        for (const HighOrders form : {HighOrders::split, HighOrders::convolution}) {
            CAPTURES(polarized, form);
            // What lies below, interpolated between vertices in any case, is kept smooth.
            const auto options = [&](HighOrdersAt where) {
                RenderOptions some = at(where, form);
                some.order_low = 1;
                return some;
            };
            const StokesImage wanted = render_smooth(smooth, options(HighOrdersAt::pixels));
            const StokesImage pixels = render(coarse, options(HighOrdersAt::pixels));
            const StokesImage vertices = render(coarse, options(HighOrdersAt::vertices));
            for (std::size_t p = 0; p < (polarized ? 4U : 1U); ++p) {
                CAPTURE(p);
                CHECK(difference(pixels, wanted, p, inside_sphere) <
                      0.5 * difference(vertices, wanted, p, inside_sphere));
            }
        }
    }
}

GL_TEST_CASE("shadows dim high orders at pixels as they dim them at vertices") {
    Studio render(context);
    const Scene scene = sphere_on_plate(falling_light(9, false), test::coarse_sphere(23), 40);
    // What the high orders add, with and without shadows.
    const auto high = [&](HighOrdersAt where, bool shadows) {
        return minus(render(scene, at(where, HighOrders::split, shadows)),
                     render(scene, at(where, HighOrders::none, shadows)));
    };
    const StokesImage shadowed = high(HighOrdersAt::pixels, true);
    const StokesImage plain = high(HighOrdersAt::pixels, false);
    const StokesImage shadow = minus(plain, shadowed);
    const StokesImage at_vertices =
        minus(high(HighOrdersAt::vertices, false), high(HighOrdersAt::vertices, true));
    CHECK(rms(shadow) > 0.2 * rms(plain));
    CHECK(rms(minus(shadow, at_vertices)) < 0.1 * rms(shadow));
    // A fraction takes away and never adds.
    const double most = largest(plain);
    for (std::size_t i = 0; i < plain.data.size(); i += 4) {
        REQUIRE(std::abs(shadowed.data[i]) <= std::abs(plain.data[i]) + 0.02 * most);
    }
}

GL_TEST_CASE("unpolarized light costs one look-up a level, whatever the channels") {
    // Grey light, so that its maps are of one size.
    const auto bytes = [&](int channels, bool polarized) {
        const PshVector grey = falling_light(9, polarized, 1)->project(9);
        PshVector light(9, channels);
        for (int c = 0; c < channels; ++c) std::ranges::copy(grey.channel(0), light.channel(c).begin());
        const Scene scene = lone(test::coarse_sphere(6), psh_environment(light));
        std::uint64_t of[2];
        for (const HighOrders form : {HighOrders::split, HighOrders::none}) {
            Studio render(context);
            std::ignore = render(scene, at(HighOrdersAt::pixels, form));
            of[form == HighOrders::none ? 1 : 0] = render.statistics.texture_bytes;
        }
        REQUIRE(of[0] > of[1]);
        return of[0] - of[1];
    };
    // A texel has up to four channels of s0, or half a Stokes vector of one.
    const std::uint64_t one = bytes(1, false);
    CHECK(bytes(4, false) == one);
    CHECK(bytes(5, false) == 2 * one);
    CHECK(bytes(3, true) > 3 * one);
}

GL_TEST_CASE("the physical range is that of the sum of all orders, at pixels") {
    Studio render(context);
    const Scene scene = lone(test::coarse_sphere(14), test::lamp());
    const auto unphysical = [](const StokesImage& image) {
        int count = 0;
        for (std::size_t i = 0; i < image.data.size(); i += 4) {
            const float* s = &image.data[i];
            count += s[0] < 0 || std::hypot(s[1], s[2], s[3]) > s[0] * 1.00001F + 1e-6F ? 1 : 0;
        }
        return count;
    };
    for (const Executor executor : {Executor::cpu, Executor::compute}) {
        RenderOptions options = at(HighOrdersAt::pixels);
        options.executor = executor;
        const StokesImage plain = render(scene, options);
        CHECK(unphysical(plain) > 100);
        options.physical = true;
        const StokesImage physical = render(scene, options);
        CHECK(unphysical(physical) == 0);
        CHECK(render.statistics.vertices_unphysical == 0);
        // What was physical is as it was: vertices were left alone.
        for (std::size_t i = 0; i < plain.data.size(); i += 4) {
            const float* s = &plain.data[i];
            if (s[0] < 0 || std::hypot(s[1], s[2], s[3]) > 0.999F * s[0]) continue;
            for (std::size_t p = 0; p < 4; ++p) REQUIRE(physical.data[i + p] == s[p]);
        }
    }
}

GL_TEST_CASE("backs of one-sided surfaces stay black at pixels, and two-sided ones shine") {
    for (const bool both : {false, true}) {
        Studio render(context);
        const Scene scene =
            lone(test::rectangle(4), falling_light(9, true), both ? twosided(metal()) : metal());
        const StokesImage image = render(scene, at(HighOrdersAt::pixels), test::camera_at({0.3, 0.2, -2}));
        const float middle = image.at(1, height / 2, width / 2)[0];
        CHECK((both ? middle > 0.5F : middle == 0));
    }
}

GL_TEST_CASE("changes reach pixels") {
    const EnvironmentPtr light = falling_light(9, true);
    Scene scene = sphere_on_plate(light, test::coarse_sphere(6), 6);
    Studio render(context);
    RenderOptions options = at(HighOrdersAt::pixels, HighOrders::split, true);
    options.order_high = 6;
    const auto compare = [&](const Camera& camera = test::some_camera()) {
        Studio fresh(context);
        const StokesImage here = render(scene, options, camera);
        // What has moved is computed in other axes.
        CHECK(largest_difference(here, fresh(scene, options, camera)) <= 1e-5 * largest(here));
    };
    compare();
    scene.set_environment(falling_light(5, false), glm::dmat3(1), 0.3);
    compare();
    scene.set_transform(0, test::at(0.3, 0.2, 0));
    scene.add({.mesh = test::coarse_sphere(4),
               .material = pplastic({.alpha = 0.4}),
               .to_world = test::at(-1, 0.5, 1)});
    compare();
    Camera camera = test::some_camera();
    camera.orthographic = true;
    compare(camera);
    scene.set_environment(falling_light(2, false), glm::dmat3(1), 1);  // no high orders
    compare();
}

GL_TEST_CASE("high orders are at vertices where OpenGL runs on the CPU, unless asked otherwise") {
    Studio render(context);
    const Scene scene = lone(test::coarse_sphere(6), falling_light(9, true));
    const StokesImage automatic = render(scene, at(HighOrdersAt::automatic));
    const HighOrdersAt same = context->info().software ? HighOrdersAt::vertices : HighOrdersAt::pixels;
    CHECK(render.statistics.high_orders_at == same);
    CHECK(automatic.data == render(scene, at(same)).data);
}
