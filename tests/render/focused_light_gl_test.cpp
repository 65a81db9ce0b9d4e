// SPDX-License-Identifier: MIT
// Tests of light of lamps that glass and mirrors send to other surfaces.
#include <optional>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/dielectric.hpp"
#include "render/memory_estimate.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::rms;
using test::rms_difference;

namespace {

RenderOptions bouncing(int max_depth) {
    return {.bake_directions = 512, .shade_at = ShadeAt::automatic, .max_depth = max_depth};
}

LocalLight lamp_at(const glm::dvec3& place) {
    LocalLight lamp;
    lamp.value = {20};
    lamp.to_world = test::at(place.x, place.y, place.z);
    return lamp;
}

/// Returns the light of a place (0, 0, 0) on a floor in each of three channels.
std::array<double, 3> shown_floor(test::Studio& studio, Scene& scene, int max_depth,
                                  const InstanceRoles& roles = {}) {
    scene.set_roles(scene.add({.mesh = test::rectangle(8), .material = diffuse({0.5, 0.5, 0.5})}), roles);
    Camera camera = test::camera_at({0, 5, 1});
    camera.fov = 0.2;
    const StokesImage image = studio(scene, bouncing(max_depth), camera);
    std::array<double, 3> out{};
    for (std::size_t c = 0; c < out.size(); ++c) {
        for (int i = 0; i < 64; ++i)
            out[c] += static_cast<double>(image.stokes(static_cast<int>(c), i / 8, i % 8)[0]) / 64;
    }
    return out;
}

}  // namespace

IMAGE_TEST_CASE("a lamp behind a block of glass lights a floor as from nearer by, in each channel") {
    test::Studio studio(context, 8, 8);
    const std::vector<double> absorption{0.7, 0, 0.1};
    const auto lit = [&](bool glass) {
        Scene scene;
        if (glass)
            scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                       .material = dielectric({.int_ior = 1.5, .ext_ior = 1, .absorption = absorption}),
                       .to_world = test::at(0, 0, 2, 0.5)});
        scene.add_light(lamp_at({0, 0, 6}));
        return shown_floor(studio, scene, 4);
    };
    const auto open = lit(false), behind = lit(true);
    // A block of thickness 1 brings the lamp nearer by 1 - 1 / 1.5.
    const double nearer = std::pow(6 / (6 - (1 - 1 / 1.5)), 2);
    for (std::size_t c = 0; c < 3; ++c) {
        CAPTURE(c);
        CHECK(behind[c] / open[c] ==
              doctest::Approx(0.96 * 0.96 * nearer * std::exp(-absorption[c])).epsilon(0.03));
    }
}

IMAGE_TEST_CASE(
    "a mirror lights a floor by the mirror image of a lamp, whether the camera sees the mirror or not") {
    test::Studio studio(context, 8, 8);
    const auto lit = [&](const std::optional<InstanceRoles>& mirror) {
        Scene scene;
        if (mirror)
            scene.set_roles(
                scene.add({.mesh = test::rectangle(1),
                           .material = conductor({{0.0, -100.0}}),
                           .to_world = test::at(-2, 0, 0, 6) *
                                       glm::rotate(glm::dmat4(1), glm::radians(90.0), glm::dvec3(0, 1, 0))}),
                *mirror);
        scene.add_light(lamp_at({0, 0, 3}));
        return shown_floor(studio, scene, 3)[1];
    };
    const double direct = 1 / 9.0, mirrored = 3 / std::pow(5, 3), alone = lit({});
    CHECK(lit(InstanceRoles{}) / alone == doctest::Approx(1 + mirrored / direct).epsilon(0.03));
    CHECK(lit(InstanceRoles{.visible = false}) / alone ==
          doctest::Approx(1 + mirrored / direct).epsilon(0.03));
    CHECK(lit(InstanceRoles{.casts_shadows = false}) / alone == doctest::Approx(1).epsilon(1e-3));
}

IMAGE_TEST_CASE("focused light meets surfaces as shadow rays do") {
    test::Studio studio(context, 8, 8);
    struct Roles {
        std::optional<InstanceRoles> sheet = {};  // of a black sheet between glass and floor
        InstanceRoles glass = {};
        InstanceRoles floor = {};
    };
    const auto lit = [&](const Roles& roles, bool glass = true) {
        Scene scene;
        if (glass)
            scene.set_roles(scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                                       .material = dielectric({.int_ior = 1.5, .ext_ior = 1}),
                                       .to_world = test::at(0, 0, 2, 0.5)}),
                            roles.glass);
        if (roles.sheet)
            scene.set_roles(scene.add({.mesh = test::rectangle(1),
                                       .material = diffuse({0, 0, 0}),
                                       .to_world = test::at(0, 0, 0.5, 0.6)}),
                            *roles.sheet);
        scene.add_light(lamp_at({0, 0, 6}));
        return shown_floor(studio, scene, 4, roles.floor)[1];
    };
    const double open = lit({}, false), focused = lit({});
    CHECK(focused > 1.01 * open);
    CHECK(lit({.sheet = InstanceRoles{}}) < 0.01 * open);
    CHECK(lit({.sheet = InstanceRoles{.visible = false}}) < 0.01 * open);
    // The sheet takes half the photons, and the others twice the power.
    CHECK(lit({.sheet = InstanceRoles{.casts_shadows = false}}) == doctest::Approx(focused).epsilon(0.1));
    CHECK(lit({.glass = {.casts_shadows = false}}) == doctest::Approx(open).epsilon(1e-3));
    CHECK(lit({.glass = {.visible = false}}) == doctest::Approx(open).epsilon(1e-3));
    CHECK(lit({.floor = {.receives_shadows = false}}) == doctest::Approx(open).epsilon(1e-3));
}

IMAGE_TEST_CASE("focused light is counted when it is found, and its memory is estimated") {
    test::Studio studio(context, 16, 16);
    Scene scene;
    scene.add({.mesh = test::rectangle(8), .material = diffuse({0.5}), .to_world = test::plate_at(-1.2, 3)});
    const std::uint32_t ball =
        scene.add({.mesh = test::fine_sphere(), .material = dielectric({.int_ior = 1.5, .ext_ior = 1})});
    const std::uint32_t lamp = scene.add_light(lamp_at({0, 4, 1}));
    RenderOptions options = bouncing(4);
    options.refine_tolerance = 0;
    const auto render = [&](const Camera& camera) {
        static_cast<void>(studio(scene, options, camera));
        return studio.statistics;
    };
    constexpr std::uint64_t paths = 1 << 17;
    const Statistics first = render(test::camera_at({0, 1, 6}));
    CHECK(first.light_rays > paths);
    CHECK(first.focus_ms > 0);
    CHECK(first.light_ms >= first.focus_ms);
    CHECK(first.shade_ms >= first.light_ms);
    const auto estimated = [&] {
        const MemoryEstimate estimate = estimate_memory(scene, options);
        return estimate.transfer + estimate.focused;
    };
    CHECK(first.transfer_bytes <= estimated());
    const Statistics moved = render(test::camera_at({0, 1.1, 6}));
    CHECK(moved.light_rays < paths);
    CHECK(moved.focus_ms < first.focus_ms);
    LocalLight other = lamp_at({0.5, 4, 1});
    scene.set_light(lamp, other);
    CHECK(render(test::camera_at({0, 1, 6})).light_rays > paths);
    const std::uint64_t with = estimated();
    scene.set_material(ball, diffuse({0.5}));
    CHECK(estimated() + 64 * paths < with);
    const Statistics without = render(test::camera_at({0, 1, 6}));
    CHECK(without.focus_ms == 0);
    CHECK(without.transfer_bytes + 64 * paths / 8 < first.transfer_bytes);
}

IMAGE_TEST_CASE("focused light goes with its lamps") {
    test::Studio studio(context, 16, 16);
    Scene scene;
    scene.add({.mesh = test::rectangle(8), .material = diffuse({0.5}), .to_world = test::plate_at(-1.2, 3)});
    scene.add({.mesh = test::fine_sphere(), .material = dielectric({.int_ior = 1.5, .ext_ior = 1})});
    RenderOptions options = bouncing(4);
    options.refine_tolerance = 0;
    const auto kept = [&] {
        static_cast<void>(studio(scene, options));
        return studio.statistics.transfer_bytes;
    };
    const std::uint64_t before = kept();
    const std::uint32_t lamp = scene.add_light(lamp_at({0, 4, 1}));
    CHECK(kept() > before + 1'000'000);
    scene.remove_light(lamp);
    CHECK(kept() < before + 100'000);
    scene.add_light(lamp_at({0, 4, 1}));
    CHECK(kept() > before + 1'000'000);
    // Without shadows no rays are followed.
    options.max_depth = 2;
    options.shadows = false;
    CHECK(kept() < before + 100'000);
}

IMAGE_TEST_CASE("a ball of glass focuses the light of a lamp on a floor as by rays") {
    test::Studio studio(context, 32, 24);
    Scene scene;
    scene.add({.mesh = test::rectangle(16), .material = diffuse({0.5}), .to_world = test::plate_at(-1.2, 3)});
    scene.add({.mesh = test::fine_sphere(), .material = dielectric({.int_ior = 1.5, .ext_ior = 1})});
    scene.add({.mesh = test::fine_sphere(),
               .material = diffuse({0}),
               .to_world = test::at(-1.5, 4, -1, 0.6),
               .emission = std::make_shared<const Emission>(Emission{.radiance = {10}})});
    RenderOptions options = bouncing(6);
    options.pixel_samples = 16;
    const StokesImage image = studio(scene, options);
    const StokesImage rays = studio(scene, {.method = Method::reference, .samples = 4096, .max_depth = 6});
    CHECK(rms_difference(image, rays) < 0.08 * rms(rays));
    // The glass alone would dim the light.
    options.max_depth = 2;
    CHECK(rms_difference(studio(scene, options), rays) > 0.2 * rms(rays));
}
