// SPDX-License-Identifier: MIT
// Tests of light that surfaces reflect to each other, by the factored method.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/memory_estimate.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"
#include "scene/path_depth.hpp"

using namespace nicol;
using test::rms;
using test::rms_difference;

namespace {

const glm::dmat3 kTurned(glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(0, 1, 0)));
const glm::dmat4 kBack = glm::translate(glm::dmat4(1), {0, 1, -2});

glm::dmat4 left_wall() {
    return test::at(-2, 1, 0, 2) * glm::rotate(glm::dmat4(1), glm::radians(90.0), glm::dvec3(0, 1, 0));
}

/// Returns a ball on a floor between two walls.
Scene corner(const MaterialPtr& ball, const MaterialPtr& floor, const MaterialPtr& wall, int cells = 6) {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(6), .material = ball, .to_world = test::at(0, -0.3, 0, 0.7)});
    scene.add({.mesh = test::rectangle(cells), .material = floor, .to_world = test::plate_at(-1, 2)});
    scene.add({.mesh = test::rectangle(cells), .material = wall, .to_world = kBack * test::at(0, 0, 0, 2)});
    scene.add({.mesh = test::rectangle(cells), .material = wall, .to_world = left_wall()});
    return scene;
}

Scene colored_corner() {
    Scene scene = corner(diffuse({0.7, 0.4, 0.2}), diffuse({0.6}), diffuse({0.8, 0.2, 0.1}));
    scene.set_environment(test::falling_light(3, false), glm::dmat3(1), 1);
    return scene;
}

RenderOptions bouncing(int max_depth, int samples = 1) {
    return {.order_low = 4,
            .high_orders = HighOrders::none,
            .shade_at = ShadeAt::pixels,
            .pixel_samples = samples,
            .max_depth = max_depth};
}

double distance_from(const StokesImage& image, float s0) {
    double out = 0;
    for (std::size_t i = 0; i < image.data.size(); i += 4)
        out = std::max(out, std::abs(double{image.data[i]} - double{s0}));
    return out;
}

double mean_s0(const StokesImage& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.data.size(); i += 4) sum += double{image.data[i]};
    return sum / static_cast<double>(image.data.size() / 4);
}

}  // namespace

IMAGE_TEST_CASE("surfaces that absorb nothing look like the even light around them") {
    test::Studio render(context);
    const MaterialPtr white = diffuse({1.0});
    Scene scene = corner(white, white, white);
    scene.set_environment(constant_environment({1}), glm::dmat3(1), 1);
    const StokesImage image = render(scene, bouncing(kUnlimitedDepth));
    CHECK(render.statistics.bounce_rounds > 3);
    CHECK(render.statistics.bounced_left < 0.01);
    // Light that few orders lose in each bounce would be missing.
    CHECK(std::abs(mean_s0(image) - 1) < 0.004);
    CHECK(distance_from(image, 1) < 0.1);
    CHECK(distance_from(render(scene, bouncing(2)), 1) > 0.3);
}

IMAGE_TEST_CASE("a closed box whose walls emit 1 and reflect a has the radiance 1 / (1 - a)") {
    test::Studio render(context, 24, 24);
    constexpr double albedo = 0.8;
    const auto emission = std::make_shared<const Emission>(Emission{.radiance = {1}});
    Scene scene;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 middle(0);
            middle[axis] = side;
            const glm::dvec3 up = axis == 1 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
            const glm::dmat4 aimed = glm::inverse(glm::lookAt(middle, 2.0 * middle, up));
            scene.add({.mesh = test::rectangle(3),
                       .material = diffuse({albedo}),
                       .to_world = aimed,
                       .emission = emission});
        }
    RenderOptions options = bouncing(kUnlimitedDepth);
    options.light_samples = 64;
    const StokesImage image = render(scene, options, test::camera_at({0.3, 0.2, 0.6}, {-0.5, -0.4, -0.9}));
    CHECK(mean_s0(image) == doctest::Approx(1 / (1 - albedo)).epsilon(0.01));
    CHECK(distance_from(image, 5) < 0.4);
    // The walls' own light irradiates them with 1 - a of all light.
    CHECK(render.statistics.bounced_light == doctest::Approx(albedo).epsilon(0.03));
}

IMAGE_TEST_CASE("light of a lamp bounces in sixteen channels as in one") {
    test::Studio render(context, 24, 24);
    const auto image_of = [&](std::size_t channels) {
        const MaterialPtr grey = diffuse({0.6});
        Scene scene = corner(grey, grey, grey, 3);
        scene.add_light({.value = std::vector<double>(channels, 10.0), .to_world = test::at(1, 1.5, 1)});
        return render(scene, bouncing(4));
    };
    const StokesImage one = image_of(1), sixteen = image_of(16);
    for (std::size_t c = 0; c < 16; ++c)
        CHECK(std::equal(one.data.begin(), one.data.end(),
                         sixteen.data.begin() + static_cast<std::ptrdiff_t>(c * one.data.size())));
}

IMAGE_TEST_CASE("light bounces as rays do, as often as max_depth says") {
    test::Studio render(context, 32, 24);
    const Scene scene = colored_corner();
    StokesImage before = render(scene, bouncing(2, 8));
    for (const int depth : {3, 6}) {
        const StokesImage image = render(scene, bouncing(depth, 8));
        const StokesImage truth =
            render(scene, {.method = Method::reference, .samples = 256, .max_depth = depth});
        CHECK(rms_difference(image, truth) < 0.03 * rms(truth));
        CHECK(rms_difference(image, before) > 0.03 * rms(truth));
        before = image;
    }
}

IMAGE_TEST_CASE("bounced light is polarized as that of rays") {
    test::Studio render(context, 32, 24);
    const MaterialPtr metal = test::some_metal(0.4);
    Scene scene = corner(diffuse({0.6}), metal, metal);
    scene.set_environment(test::falling_light(3, false), glm::dmat3(1), 1);
    const auto polarization = [](StokesImage image) {
        for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = image.data[i + 3] = 0;
        return image;
    };
    const StokesImage truth =
        polarization(render(scene, {.method = Method::reference, .samples = 1024, .max_depth = 6}));
    const double direct = rms_difference(polarization(render(scene, bouncing(2, 8))), truth);
    CHECK(rms_difference(polarization(render(scene, bouncing(6, 8))), truth) < 0.4 * direct);
}

IMAGE_TEST_CASE("narrow lobes send the light of lamps on as by rays") {
    test::Studio render(context, 32, 24);
    const auto flat = test::with_texcoords(make_rectangle(4)),
               ground = test::with_texcoords(make_rectangle(32));
    // A quarter of the area is there.
    constexpr int cells = 16;
    TextureImage quarter{.width = cells, .height = cells, .channels = 1};
    for (int i = 0; i < cells * cells; ++i)
        quarter.values.push_back(i % 2 == 0 && i / cells % 2 == 0 ? 1.0F : 0.0F);
    const TexturePtr some = image_texture(std::move(quarter), {.filter = TextureSampling::Filter::nearest});
    enum class Scenery { plain, cut_metal, cut_floor, mirror };
    const struct {
        double alpha, alpha_v;
        LocalLight::Kind lamp;
        Scenery scenery;
    } rows[] = {{0.05, 0, LocalLight::Kind::spot, Scenery::plain},
                {0.2, 0, LocalLight::Kind::spot, Scenery::plain},
                {0.05, 0.12, LocalLight::Kind::spot, Scenery::plain},
                {0.08, 0, LocalLight::Kind::directional, Scenery::plain},
                {0.2, 0, LocalLight::Kind::spot, Scenery::cut_metal},
                {0.2, 0, LocalLight::Kind::spot, Scenery::cut_floor},
                {0.2, 0, LocalLight::Kind::spot, Scenery::mirror}};
    for (const auto& row : rows) {
        CAPTURE(row.alpha);
        CAPTURE(row.alpha_v);
        CAPTURE(static_cast<int>(row.scenery));
        const bool spot = row.lamp == LocalLight::Kind::spot;
        const MaterialPtr metal =
            rough_conductor({.eta = {{0.2, -3.0}}, .alpha = row.alpha, .alpha_v = row.alpha_v});
        const MaterialPtr white = diffuse({0.8});
        const auto with_lamp = [&](const glm::dvec3& place, const glm::dvec3& target) {
            // The lamp lights the wall's front alone, and the floor has the light that the wall sends.
            Scene scene;
            scene.add({.mesh = flat,
                       .material = row.scenery == Scenery::cut_metal ? masked(metal, some) : metal,
                       .to_world = kBack});
            scene.add({.mesh = ground,
                       .material = row.scenery == Scenery::cut_floor ? masked(white, some) : white,
                       .to_world = test::plate_at(-1, 2)});
            scene.add_light(
                {.kind = row.lamp,
                 .value = {spot ? 40.0 : 2.0},
                 .to_world = glm::inverse(glm::lookAt(place, 2.0 * place - target, glm::dvec3(0, 1, 0))),
                 .cutoff_angle = 0.15,
                 .beam_width = 0.12});
            return scene;
        };
        const bool mirrored = row.scenery == Scenery::mirror;
        const glm::dvec3 place(0, mirrored ? 2 : 4, mirrored ? 4 : 0), target(0, 1, -2);
        const Scene seen = with_lamp(place, target);
        // Rays find no lamp by a mirror, but its mirror image.
        Scene scene = seen;
        if (mirrored) {
            scene = with_lamp({place.x, place.y, 2}, {target.x, target.y, 8});
            scene.add({.mesh = test::rectangle(1),
                       .material = conductor({{0.0, -100.0}}),
                       .to_world = test::at(0, place.y, 3, 0.8) *
                                   glm::rotate(glm::dmat4(1), glm::radians(180.0), glm::dvec3(0, 1, 0))});
        }
        // The camera sees equal areas of the floor in all pixels, nearly.
        const Camera camera = test::camera_at({0.1, 9, 0}, {0, -1, 0});
        // Light that is reflected once, and more often.
        const auto bounced = [&](const Scene& of, const RenderOptions& twice) {
            RenderOptions once = twice;
            once.max_depth = 2;
            StokesImage out = render(of, twice, camera);
            const StokesImage direct = render(of, once, camera);
            for (std::size_t i = 0; i < out.data.size(); ++i) out.data[i] -= direct.data[i];
            return out;
        };
        const StokesImage truth =
            bounced(seen, {.method = Method::reference, .samples = 512, .max_depth = 3});
        const StokesImage image = bounced(scene, bouncing(mirrored ? 4 : 3, 8));
        CHECK(std::abs(mean_s0(image) / mean_s0(truth) - 1) < 0.16);
    }
}

IMAGE_TEST_CASE("a large floor with narrow lobes lights what stands on it, evenly for any directions") {
    // The light grazes the floor, so that far places send it as well as near ones.
    test::Studio render(context, 32, 24);
    const auto floor = test::with_texcoords(make_rectangle(1));
    const MaterialPtr brushed = rough_conductor({.eta = {{1.3, -4.0}}, .alpha = 0.1, .alpha_v = 0.3});
    Scene scene;
    scene.add({.mesh = test::rectangle(4),
               .material = diffuse({0.8}),
               .to_world = test::at(0, 0, 0, 1) * glm::scale(glm::dmat4(1), {0.6, 0.6, 1})});
    scene.add({.mesh = floor, .material = brushed, .to_world = test::plate_at(-1, 80)});
    scene.add_light({.kind = LocalLight::Kind::directional,
                     .value = {2.0},
                     .to_world = glm::inverse(glm::lookAt(glm::dvec3(0.5, 0.6, 2.9), glm::dvec3(1, 1.2, 5.8),
                                                          glm::dvec3(0, 1, 0)))});
    const Camera camera = test::camera_at({0, 0.1, 3}, {0, 0, 0});
    const auto bounced = [&](RenderOptions options) {
        options.max_depth = 3;
        const double all = mean_s0(render(scene, options, camera));
        options.max_depth = 2;
        return all - mean_s0(render(scene, options, camera));
    };
    const double truth = bounced({.method = Method::reference, .samples = 1024});
    for (const int directions : {512, 1024, 2048, 4096}) {
        CAPTURE(directions);
        RenderOptions options = bouncing(3, 8);
        options.bake_directions = directions;
        CHECK(std::abs(bounced(options) / truth - 1) < 0.15);
    }
}

IMAGE_TEST_CASE("narrow lobes send the light of a lamp that has moved on, by any number of threads") {
    Scene scene;
    scene.add({.mesh = test::rectangle(4),
               .material = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.1}),
               .to_world = kBack});
    scene.add({.mesh = test::rectangle(8), .material = diffuse({0.8}), .to_world = test::plate_at(-1, 2)});
    const auto lamp = [](double x) {
        return LocalLight{.kind = LocalLight::Kind::point, .value = {4.0}, .to_world = test::at(x, 2, 0, 1)};
    };
    const std::uint32_t id = scene.add_light(lamp(0));
    test::Studio render(context, 32, 24);
    const StokesImage before = render(scene, bouncing(3));
    scene.set_light(id, lamp(0.5));
    const StokesImage moved = render(scene, bouncing(3));
    CHECK(rms_difference(moved, before) > 0.01 * rms(before));
    Renderer fresh(context, {.threads = 1});
    Framebuffer target(context, 32, 24, scene.channels());
    fresh.render(scene, test::some_camera(), bouncing(3), target);
    CHECK(rms_difference(moved, target.image()) == 0);
}

IMAGE_TEST_CASE("brushed metal reflects what surfaces around it reflect") {
    test::Studio render(context, 32, 24);
    const MaterialPtr brushed = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.4, .alpha_v = 0.15});
    Scene scene = corner(brushed, diffuse({0.6, 0.5, 0.4}), diffuse({0.8, 0.4, 0.2}));
    scene.set_environment(constant_environment({1}), glm::dmat3(1), 1);
    const StokesImage truth = render(scene, {.method = Method::reference, .samples = 256, .max_depth = 4});
    CHECK(rms_difference(render(scene, bouncing(4, 32)), truth) < 0.06 * rms(truth));
}

IMAGE_TEST_CASE("an object that sees no other has no bounces") {
    test::Studio render(context);
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(6), .material = test::some_metal(0.3)});
    scene.set_environment(test::falling_light(3, false), glm::dmat3(1), 1);
    const StokesImage direct = render(scene, bouncing(2));
    CHECK(render(scene, bouncing(12)).data == direct.data);
    CHECK(render.statistics.bounce_links == 0);
}

IMAGE_TEST_CASE("bounces are computed when the light changes, and not for a camera") {
    test::Studio render(context);
    Scene scene = colored_corner();
    static_cast<void>(render(scene, bouncing(5)));
    CHECK(render.statistics.bounce_ms > 0);
    CHECK(render.statistics.bounced_light > 0.1);
    static_cast<void>(render(scene, bouncing(5), test::camera_at({3, 2, 3})));
    CHECK(render.statistics.bounce_ms == 0);
    CHECK(render.statistics.vertices_relit < render.statistics.vertices);
    scene.set_environment(test::falling_light(3, true), glm::dmat3(1), 1);
    static_cast<void>(render(scene, bouncing(5)));
    CHECK(render.statistics.bounce_ms > 0);
    CHECK(render.statistics.vertices_traced == 0);
}

IMAGE_TEST_CASE("no camera makes bounces bake or project again, be it near or far") {
    test::Studio render(context);
    const Scene scene = colored_corner();
    RenderOptions options = bouncing(5);
    options.shade_at = ShadeAt::automatic;
    options.executor = Executor::cpu;
    // From afar, vertices would do for this tolerance, and from near they would not.
    options.tolerance = 0.06;
    const Camera near = test::camera_at({0.9, 0.4, 0.9}, {0, -0.3, 0}), far = test::camera_at({20, 30, 40});
    static_cast<void>(render(scene, options, far));
    static_cast<void>(render(scene, options, near));
    for (const Camera& camera : {far, near}) {
        static_cast<void>(render(scene, options, camera));
        CHECK(render.statistics.bake_ms == 0);
        CHECK(render.statistics.materials_projected == 0);
    }
}

IMAGE_TEST_CASE(
    "bounced light that stays apart at pixels makes the picture that it makes as part of all light") {
    test::Studio render(context, 32, 24);
    const MaterialPtr metal = test::some_metal(0.4);
    Scene scene = corner(diffuse({0.6}), metal, metal);
    scene.set_environment(test::falling_light(3, false), glm::dmat3(1), 1);
    RenderOptions options = bouncing(5);
    options.executor = Executor::cpu;
    const StokesImage apart = render(scene, options);
    const std::uint64_t bytes = render.statistics.transfer_bytes;
    options.disabled_optimisations = skip_light_components;
    const StokesImage whole = render(scene, options);
    CHECK(render.statistics.transfer_bytes > bytes);
    CHECK(rms_difference(apart, whole) < 2e-3 * rms(whole));
}

IMAGE_TEST_CASE("after any change, bounced light is that of a fresh start") {
    test::Studio render(context);
    Scene scene = colored_corner();
    static_cast<void>(render(scene, bouncing(2)));
    const auto check_fresh = [&] {
        const StokesImage image = render(scene, bouncing(5));
        test::Studio fresh(context);
        CHECK(rms_difference(image, fresh(scene, bouncing(5))) < 1e-5 * rms(image));
    };
    check_fresh();
    scene.set_transform(0, test::at(0.4, -0.2, 0.3, 0.6));
    check_fresh();
    scene.set_material(2, diffuse({0.1, 0.9, 0.3}));
    check_fresh();
    scene.set_environment(test::falling_light(3, false), kTurned, 1);
    check_fresh();
    scene.set_environment(test::falling_light(3, true), glm::dmat3(1), 1);
    check_fresh();
    const std::uint32_t lamp = scene.add_light({});
    check_fresh();
    scene.remove_light(lamp);
    check_fresh();
}

IMAGE_TEST_CASE("a light that turns has bounces that were baked, and not to be summed again") {
    test::Studio render(context);
    Scene scene = colored_corner();
    static_cast<void>(render(scene, bouncing(5)));
    const std::uint64_t links = render.statistics.bounce_links;
    CHECK(render.statistics.bake_ms > 0);
    scene.set_environment(test::falling_light(3, false), kTurned, 1);
    static_cast<void>(render(scene, bouncing(5)));
    CHECK(render.statistics.bake_ms == 0);
    CHECK(render.statistics.bounce_ms > 0);
    CHECK(render.statistics.bounce_links == links);
}

IMAGE_TEST_CASE("the series of bounces ends earlier for a larger tolerance, and its error is predicted") {
    test::Studio render(context);
    const MaterialPtr bright = diffuse({0.8});
    Scene scene = corner(bright, bright, bright);
    scene.set_environment(constant_environment({1}), glm::dmat3(1), 1);
    RenderOptions options = bouncing(kUnlimitedDepth);
    options.tolerance = 0.004;
    const StokesImage exact = render(scene, options);
    const std::uint64_t rounds = render.statistics.bounce_rounds;
    CHECK(render.statistics.bounced_left < 0.001);
    options.tolerance = 0.2;
    const StokesImage rough = render(scene, options);
    CHECK(render.statistics.bounce_rounds < rounds);
    CHECK(render.statistics.bounced_left < 0.05);
    CHECK(rms_difference(rough, exact) < 0.05 * rms(exact));
    CHECK(render.statistics.bounce_error > render.statistics.bounced_left);
    CHECK(render.statistics.predicted_error >= render.statistics.bounce_error);
}

IMAGE_TEST_CASE("the memory estimate covers bounced light") {
    test::Studio render(context);
    const Scene scene = colored_corner();
    const auto measured = [&](int max_depth) {
        RenderOptions options = bouncing(max_depth);
        options.refine_tolerance = 0;
        static_cast<void>(render(scene, options));
        return std::pair(render.statistics.transfer_bytes, estimate_memory(scene, options).transfer);
    };
    const auto [direct, direct_estimate] = measured(2);
    const auto [all, all_estimate] = measured(5);
    CHECK(all > direct);
    CHECK(all_estimate - direct_estimate >= all - direct);
}

IMAGE_TEST_CASE("compute shaders add the same bounced light") {
    test::Studio render(context);
    const Scene scene = colored_corner();
    for (const ShadeAt where : {ShadeAt::pixels, ShadeAt::vertices}) {
        RenderOptions options = bouncing(5);
        options.shade_at = where;
        options.executor = Executor::cpu;
        const StokesImage threads = render(scene, options);
        options.executor = Executor::compute;
        CHECK(rms_difference(render(scene, options), threads) < 2e-5 * rms(threads));
    }
}
