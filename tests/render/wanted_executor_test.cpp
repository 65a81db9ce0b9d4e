// SPDX-License-Identifier: MIT
#include "render/wanted_executor.hpp"

#include "material/dielectric.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("threads shade what rays are followed from, unless users choose compute shaders") {
    const std::complex<double> index(0.2, -3.0);
    const MaterialPtr mirror = rough_conductor({.eta = {index}, .alpha = 0}),
                      narrow = rough_conductor({.eta = {index}, .alpha = 0.1}),
                      wide = rough_conductor({.eta = {index}, .alpha = 0.4}), glass = dielectric({});
    constexpr Executor automatic = Executor::automatic, cpu = Executor::cpu, compute = Executor::compute;
    const struct {
        MaterialPtr material;
        RenderOptions options;
        Executor wanted;
        ShadeAt shade_at = ShadeAt::automatic;
    } rows[] = {
        {wide, {.max_depth = 12}, automatic},
        {wide, {.executor = cpu}, cpu},
        {narrow, {.max_depth = 2}, automatic},
        {narrow, {.max_depth = 3}, cpu},
        {narrow, {.max_depth = 3}, automatic, ShadeAt::vertices},
        {narrow, {.executor = compute, .max_depth = 3}, compute},
        {mirror, {}, cpu},
        {mirror, {.method = Method::dense}, automatic},
        {mirror, {.executor = compute}, compute},
        {glass, {.executor = compute}, cpu},
    };
    for (const auto& row : rows) {
        CAPTURE(row.material->content_key());
        CAPTURE(row.options.max_depth);
        Scene scene;
        scene.add({.mesh = test::coarse_sphere(4), .material = diffuse({0.5, 0.5, 0.5})});
        scene.add({.mesh = test::coarse_sphere(4), .material = row.material});
        RenderOptions options = row.options;
        options.shade_at = row.shade_at;
        CHECK(wanted_executor(scene, options) == row.wanted);
    }
}
