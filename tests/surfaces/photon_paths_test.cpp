// SPDX-License-Identifier: MIT
#include "surfaces/photon_paths.hpp"

#include <memory>

#include "material/dielectric.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// A floor, balls of glass in a row above it, and lamps above these.
struct LitGlass {
    LitGlass(int balls, int lamps) {
        scene.add(
            {.mesh = test::rectangle(4), .material = diffuse({0.5}), .to_world = test::at(0, 0, -2, 9)});
        for (int i = 0; i < balls; ++i)
            scene.add({.mesh = test::coarse_sphere(6),
                       .material = dielectric({.int_ior = 1.5, .ext_ior = 1}),
                       .to_world = test::at(3.0 * i, 0, 0)});
        given.update(scene);
        surfaces.update(given, nullptr, {}, {});
        smooth.update(surfaces, rays, false);
        for (int i = 0; i < lamps; ++i) {
            LocalLight lamp;
            lamp.value = {20};
            lamp.to_world = test::at(0.1 * i, 0, 5);
            sources.push_back(light_source(lamp, glm::dmat4(1)));
        }
    }

    [[nodiscard]] std::shared_ptr<const FocusedLight> trace(int threads, const Progress::Callback& callback) {
        Workers workers({.threads = threads});
        Progress progress(callback);
        statistics = {};
        RenderRun run{.workers = workers, .progress = progress, .statistics = statistics};
        return focused_light({.geometry = surfaces.geometry(), .smooth = smooth, .events = 6, .channels = 1},
                             sources, run);
    }

    Scene scene;
    SceneGeometry given;
    RefinedSurfaces surfaces;
    DrawnRays rays;
    SmoothSurfaces smooth;
    std::vector<LightSourcePtr> sources;
    Statistics statistics;
};

}  // namespace

TEST_CASE("focused light does not depend on the number of threads, and takes no more memory than is said") {
    LitGlass one(2, 2);
    const auto first = one.trace(1, {}), second = one.trace(2, {});
    REQUIRE(first != nullptr);
    CHECK(first->photons() > 10'000);
    CHECK(first->photons() == second->photons());
    CHECK(first->bytes() == second->bytes());
    CHECK(first->bytes() <= most_focused_bytes(2, 2, 1));
    // Each path has a ray from the lamp, and at least two that pass a ball if it ends on the floor.
    CHECK(one.statistics.light_rays > 3 * first->photons());
}

TEST_CASE("a search for focused light ends when it is told to") {
    LitGlass many(20, 50);
    int asked = 0;
    check_error(
        ErrorCode::cancelled,
        [&] {
            static_cast<void>(many.trace(1, [&](const char* verb, double fraction) {
                CHECK(std::string(verb) == "shade");
                CHECK(fraction < 1);
                return ++asked < 1;
            }));
        },
        "the progress callback asked to stop");
    CHECK(asked == 1);
    CHECK(many.statistics.light_rays == 0);
}
