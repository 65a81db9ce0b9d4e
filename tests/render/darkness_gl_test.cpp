// SPDX-License-Identifier: MIT
// Tests that light which is 0 costs nothing and changes nothing.
#include <vector>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::at;

namespace {

/// Returns a ball on a plate under a lamp.
Scene lamp_lit() {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(8), .material = test::some_metal(0.3)});
    scene.add({.mesh = test::rectangle(9), .material = diffuse({0.5}), .to_world = test::plate_at(-1, 3)});
    scene.add_light({.kind = LocalLight::Kind::point, .value = {30}, .to_world = at(1, 3, 2)});
    return scene;
}

EnvironmentPtr black_photograph() {
    return image_environment(EquirectImage(64, 33, 1));
}

}  // namespace

IMAGE_TEST_CASE("an environment that gives no light is no environment") {
    struct Case {
        const char* what;
        EnvironmentPtr environment;
        double scale;
    };
    const Case cases[] = {{"scaled by 0", test::falling_light(5, true, 1), 0},
                          {"constant", constant_environment({0}), 1},
                          {"photograph", black_photograph(), 2}};
    for (const Method method : {Method::factored, Method::reference}) {
        const RenderOptions options{.method = method, .executor = Executor::cpu, .samples = 4};
        test::Studio render(context);
        const StokesImage expected = render(lamp_lit(), options);
        for (const Case& one : cases) {
            CAPTURES(static_cast<int>(method), one.what);
            Scene scene = lamp_lit();
            scene.set_environment(one.environment, glm::dmat3(1), one.scale);
            CHECK(render(scene, options).data == expected.data);
            CHECK(render.statistics.bake_rays == 0);
        }
    }
}

IMAGE_TEST_CASE("lights that give no light are not asked for any") {
    const RenderOptions options{.executor = Executor::cpu};
    test::Studio render(context);
    const StokesImage expected = render(lamp_lit(), options);
    const std::uint64_t rays = render.statistics.light_rays;
    Scene scene = lamp_lit();
    for (const LocalLight::Kind kind : {LocalLight::Kind::point, LocalLight::Kind::directional})
        scene.add_light({.kind = kind, .value = {0}, .to_world = at(-1, 3, 2)});
    scene.add({.mesh = test::coarse_sphere(2),
               .material = diffuse({0.5}),
               .to_world = at(90, 90, 90),
               .emission = std::make_shared<const Emission>(Emission{.radiance = {0}})});
    CHECK(test::rms(test::minus(render(scene, options), expected)) < 1e-6 * test::rms(expected));
    CHECK(render.statistics.local_lights == 1);
    CHECK(render.statistics.light_rays == rays);
    // A spot that points past everything.
    scene.add_light({.kind = LocalLight::Kind::spot, .value = {30}, .to_world = at(-1, 3, 2)});
    CHECK(test::rms(test::minus(render(scene, options), expected)) < 1e-6 * test::rms(expected));
    CHECK(render.statistics.light_rays == rays);
}
