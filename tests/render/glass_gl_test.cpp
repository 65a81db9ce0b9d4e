// SPDX-License-Identifier: MIT
// Tests of scenes with glass that light passes.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/dielectric.hpp"
#include "render/scenes.hpp"

using namespace nicol;

IMAGE_TEST_CASE("methods but the reference refuse glass that light passes") {
    test::Studio render(context);
    const Camera camera = test::camera_at({1, 2, 6});
    for (const MaterialPtr& glass : {dielectric({}), thin_dielectric({})}) {
        Scene scene;
        const auto mesh = test::coarse_sphere(6);
        scene.add({.mesh = mesh, .material = diffuse({0.5}), .to_world = test::at(-1.1, 0, 0)});
        scene.add({.mesh = mesh, .material = glass, .to_world = test::at(1.1, 0, 0)});
        scene.set_environment(constant_environment({1}), glm::dmat3(1), 1);
        for (const Method method : {Method::factored, Method::dense})
            check_error(ErrorCode::unsupported, CALL(render(scene, {.method = method}, camera)),
                        "the material of instance 1 ", "glass that light passes", "set method to reference");
        CHECK(test::rms(render(scene, {.method = Method::reference, .samples = 4, .max_depth = 8}, camera)) >
              0.1);
    }
}
