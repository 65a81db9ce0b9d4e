// SPDX-License-Identifier: MIT
// Tests of splitting lamps off the environment, and of the light that remains for the harmonics.
#include "render/light_split.hpp"

#include "render/memory_estimate.hpp"
#include "render/order_selector.hpp"
#include "render/scenes.hpp"
#include "surfaces/scene_geometry.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

// Returns three lamps in a room of radiance 1.
EnvironmentPtr lamps() {
    EquirectImage image(128, 65, 1);
    for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = 1;
    for (const int column : {20, 60, 100}) image.at(0, 10 + column / 10, column)[0] = 3000;
    return image_environment(image);
}

}  // namespace

TEST_CASE("lights are extracted for the factored method, as many as the options allow, once") {
    const EnvironmentPtr light = lamps();
    LightSplit split;
    Statistics statistics;
    for (const auto& [method, most, expected] : {std::tuple{Method::factored, 2, 2U},
                                                 {Method::factored, 64, 3U},
                                                 {Method::factored, 0, 0U},
                                                 {Method::dense, 64, 0U}}) {
        CAPTURES(static_cast<int>(method), most);
        const RenderOptions options{.method = method, .split_lights = most};
        split.update(light, options, statistics);
        CHECK(split.extracted_lights().size() == expected);
        CHECK(statistics.lights_split == expected);
        CHECK((split.rest() == light) == (expected == 0));

        const EnvironmentPtr rest = split.rest();
        Statistics again;
        split.update(light, options, again);
        CHECK(split.rest() == rest);
        CHECK(again.project_ms == 0);
        CHECK(again.lights_split == expected);
    }
    split.update(nullptr, {.split_lights = 64}, statistics);
    CHECK(split.rest() == nullptr);
    CHECK(split.extracted_lights().empty());
}

TEST_CASE("without lamps a tolerance is reached with fewer orders, relative to all light") {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(8), .material = pplastic({.alpha = 0.3})});
    scene.set_environment(lamps(), glm::dmat3(1), 1);
    SceneGeometry surfaces;
    surfaces.update(scene);
    const SurfaceState unshadowed = test::without_shadows(surfaces);
    const RenderOptions options{.tolerance = 1e-3, .split_lights = 64};
    LightSplit split;
    Statistics statistics;
    split.update(scene.environment(), options, statistics);
    KeptProjection projection;
    OrderSelector selector;
    const auto choose = [&](const EnvironmentPtr& projected) {
        return selector.choose(scene, {projected, SampledTerms::none}, unshadowed, true, options,
                               MemoryLimit::kNone, projection);
    };
    const auto whole = choose(scene.environment());
    const auto rest = choose(split.rest());
    CHECK(whole.high > 9);
    CHECK(rest.high == 0);
    CHECK(rest.error <= 1e-3);
    CHECK(rest.rms == doctest::Approx(whole.rms).epsilon(1e-9));
    CHECK(choose(scene.environment()).high == whole.high);
}
