// SPDX-License-Identifier: MIT
#include "surfaces/photon_paths.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "material/conductor.hpp"
#include "material/dielectric.hpp"
#include "render/scenes.hpp"
#include "surfaces/photon_rays.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// A scene with lamps, whose light smooth surfaces focus.
struct Lit {
    void prepare() {
        given.update(scene);
        surfaces.update(given, nullptr, {}, {});
        smooth.update(surfaces, rays, false);
    }

    void add_lamp(const glm::dvec3& place) {
        LocalLight lamp;
        lamp.value = {20};
        lamp.to_world = test::at(place.x, place.y, place.z);
        sources.push_back(light_source(lamp, glm::dmat4(1)));
    }

    [[nodiscard]] std::shared_ptr<const FocusedLight> trace(int threads, const Progress::Callback& callback,
                                                            int events = 6) {
        Workers workers({.threads = threads});
        Progress progress(callback);
        statistics = {};
        RenderRun run{.workers = workers, .progress = progress, .statistics = statistics};
        return focused_light(
            {.geometry = surfaces.geometry(), .smooth = smooth, .events = events, .channels = 1}, sources,
            run);
    }

    Scene scene;
    SceneGeometry given;
    RefinedSurfaces surfaces;
    DrawnRays rays;
    SmoothSurfaces smooth;
    std::vector<LightSourcePtr> sources;
    Statistics statistics;
};

/// A floor, balls of glass in a row above it, and lamps above these.
struct LitGlass : Lit {
    LitGlass(int balls, int lamps) {
        scene.add(
            {.mesh = test::rectangle(4), .material = diffuse({0.5}), .to_world = test::at(0, 0, -2, 9)});
        for (int i = 0; i < balls; ++i)
            scene.add({.mesh = test::coarse_sphere(6),
                       .material = dielectric({.int_ior = 1.5, .ext_ior = 1}),
                       .to_world = test::at(3.0 * i, 0, 0)});
        prepare();
        for (int i = 0; i < lamps; ++i) add_lamp({0.1 * i, 0, 5});
    }
};

/// Returns the light of the mean channel at a place of a horizontal surface.
double light_at(const FocusedLight& focused, const glm::vec3& place) {
    LaneLight out;
    focused.gather(std::array{place}, std::array{glm::vec3(0, 0, 1)}, out);
    return out.points == 0 ? 0 : static_cast<double>(out.irradiance[0][0][0] * vector_at(out.towards, 0).z);
}

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

TEST_CASE("light goes on behind a small surface far away that casts no shadow") {
    Lit lit;
    lit.scene.add(
        {.mesh = test::rectangle(4), .material = diffuse({0.5}), .to_world = test::at(0, 0, -1, 9)});
    lit.scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                   .material = dielectric({.int_ior = 1.5, .ext_ior = 1}),
                   .to_world = test::at(0, 0, 8)});
    const std::uint32_t ball = lit.scene.add(
        {.mesh = test::coarse_sphere(6), .material = diffuse({0.5}), .to_world = test::at(0, 0, 0, 0.15)});
    lit.scene.set_roles(ball, {.casts_shadows = false});
    lit.prepare();
    SUBCASE("and meets no surface twice") {
        const PhotonRays rays(lit.surfaces.geometry(), lit.smooth);
        int through = 0;
        for (int i = 0; i < 400; ++i) {
            const glm::dvec3 target(0.01 * (i % 20 - 10), 0.01 * (i / 20 - 10), 0);
            Ray ray{.origin = {0, 0, 6.7}, .direction = glm::normalize(target - glm::dvec3(0, 0, 6.7))};
            double before = 0;
            int hits = 0;
            while (const std::optional<RayHit> hit = rays.first(ray)) {
                REQUIRE(hit->distance > before);
                before = hit->distance;
                ray.nearest = rays.beyond(*hit);
                ++hits;
            }
            CHECK(hits > 0);
            if (hits > 1) ++through;
        }
        CHECK(through > 100);
    }
    SUBCASE("and a search for all of it ends") {
        lit.add_lamp({0, 0, 12});
        const auto focused = lit.trace(2, {}, 4);
        REQUIRE(focused != nullptr);
        CHECK(light_at(*focused, {0.02F, 0.03F, -1}) > 0);
    }
}

TEST_CASE("rays to a lamp far from the origin end before the lamp's own surface") {
    constexpr double height = 20000;
    Lit lit;
    lit.scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                   .material = dielectric({.int_ior = 1.5, .ext_ior = 1}),
                   .to_world = test::at(0, 0, -height)});
    lit.scene.add(
        {.mesh = test::rectangle(1), .material = diffuse({0.5}), .to_world = test::at(0, 0, height - 1)});
    const std::uint32_t sheet = lit.scene.add(
        {.mesh = test::rectangle(1), .material = diffuse({0.5}), .to_world = test::at(0, 0, height - 0.5)});
    lit.scene.set_roles(sheet, {.casts_shadows = false});
    lit.prepare();
    const PhotonRays rays(lit.surfaces.geometry(), lit.smooth);
    float top = 0;
    for (const glm::vec3& position : lit.surfaces.geometry().positions) top = std::max(top, position.z);
    REQUIRE(top > 0.9 * height);
    // Coordinates there are multiples of 1/512, and rays leave the last 0.04 out.
    Ray ray{
        .origin = {0, 0, static_cast<double>(top) + 0.5}, .direction = {0, 0, -1}, .farthest = 1 + 0x1p-8};
    CHECK_FALSE(rays.occluded(ray));
    ray.farthest = 1.1;
    CHECK(rays.occluded(ray));
}

TEST_CASE("surfaces without shadows share the photons of a path, so that memory has a limit") {
    std::size_t photons = 0;
    const auto lit_floor = [&photons](int sheets) {
        Lit lit;
        lit.scene.add(
            {.mesh = test::rectangle(4), .material = diffuse({0.5}), .to_world = test::at(0, 0, 0, 9)});
        lit.scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                       .material = dielectric({.int_ior = 1.5, .ext_ior = 1}),
                       .to_world = test::at(0, 0, 4)});
        for (int i = 0; i < sheets; ++i)
            lit.scene.set_roles(lit.scene.add({.mesh = test::rectangle(1),
                                               .material = diffuse({0.5}),
                                               .to_world = test::at(0, 0, 0.1 * (i + 1), 3)}),
                                {.casts_shadows = false});
        lit.prepare();
        lit.add_lamp({0, 0, 9});
        const auto focused = lit.trace(2, {});
        REQUIRE(focused != nullptr);
        CHECK(focused->bytes() <= most_focused_bytes(1, 1, 1));
        double floor = 0, sheet = 0;
        for (int i = 0; i < 225; ++i) {
            const glm::vec3 place(0.1F * static_cast<float>(i % 15 - 7),
                                  0.1F * static_cast<float>(i / 15 - 7), 0);
            floor += light_at(*focused, place) / 225;
            sheet += light_at(*focused, place + glm::vec3(0, 0, 0.1F)) / 225;
        }
        if (sheets > 0) CHECK(sheet == doctest::Approx(floor).epsilon(0.05));
        photons = focused->photons();
        return floor;
    };
    const double open = lit_floor(0);
    const std::size_t of_floor = photons;
    CHECK(lit_floor(1) == doctest::Approx(open).epsilon(0.01));
    CHECK(photons == of_floor);
    CHECK(lit_floor(12) == doctest::Approx(open).epsilon(0.03));
    CHECK(photons == of_floor);
}

TEST_CASE("light between mirrors comes to an end") {
    Lit lit;
    Mesh inside = make_cube(2);
    for (glm::uvec3& corners : inside.triangles) std::swap(corners.y, corners.z);
    for (glm::vec3& normal : inside.normals) normal = -normal;
    const auto mesh = std::make_shared<const Mesh>(std::move(inside));
    const auto closed_by = [&](const MaterialPtr& mirror) {
        lit.scene.add({.mesh = mesh, .material = mirror});
    };
    std::uint64_t rays_of_path = 66;
    SUBCASE("after 64 reflections") {
        closed_by(conductor({{0.0, -100.0}}));
    }
    SUBCASE("when next to nothing is left") {
        closed_by(conductor({{1.5, -1.0}}));
        rays_of_path = 12;
    }
    lit.prepare();
    lit.add_lamp({0.1, 0.2, 0.3});
    CHECK(lit.trace(2, {}, std::numeric_limits<int>::max()) == nullptr);
    CHECK(lit.statistics.light_rays > 100'000);
    CHECK(lit.statistics.light_rays < rays_of_path << 17);
}
