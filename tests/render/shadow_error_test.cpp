// SPDX-License-Identifier: MIT
#include "render/shadow_error.hpp"

#include <functional>
#include <memory>
#include <numbers>

#include "directions.hpp"
#include "render/scenes.hpp"
#include "scene/camera.hpp"
#include "surfaces/scene_geometry.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr std::uint32_t kCells = 16;

// A square from (-1, -1, 0) to (1, 1, 0) of kCells x kCells cells, which faces +z.
std::shared_ptr<const Mesh> grid() {
    Mesh mesh;
    for (std::uint32_t j = 0; j <= kCells; ++j)
        for (std::uint32_t i = 0; i <= kCells; ++i) {
            mesh.positions.emplace_back(2.0F * static_cast<float>(i) / kCells - 1,
                                        2.0F * static_cast<float>(j) / kCells - 1, 0);
            mesh.normals.emplace_back(0, 0, 1);
        }
    for (std::uint32_t j = 0; j < kCells; ++j)
        for (std::uint32_t i = 0; i < kCells; ++i) {
            const std::uint32_t v = j * (kCells + 1) + i;
            mesh.triangles.emplace_back(v, v + 1, v + kCells + 2);
            mesh.triangles.emplace_back(v, v + kCells + 2, v + kCells + 1);
        }
    return std::make_shared<const Mesh>(std::move(mesh));
}

// Returns visibility with which the irradiance of even light is a function of x: of the directions, those up
// to an azimuth are seen.
Visibility lit(const WorldGeometry& geometry, const DirectionSet& directions,
               const std::function<double(double)>& irradiance) {
    Visibility out(directions.size(), geometry.positions.size());
    for (std::size_t v = 0; v < out.vertices(); ++v) {
        const double most = 2 * irradiance(static_cast<double>(geometry.positions[v].x)) - 1;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const glm::dvec3 d(directions.directions()[i]);
            if (d.z > 0 && std::atan2(d.y, d.x) <= most * std::numbers::pi)
                out.at(v)[i / 64] |= std::uint64_t{1} << (i % 64);
        }
    }
    return out;
}

}  // namespace

TEST_CASE("shadows between vertices err as the curvature of their irradiance says, in what an image shows") {
    Scene scene;
    scene.add({.mesh = grid(), .material = diffuse({0.5})});
    SceneGeometry surfaces;
    surfaces.update(scene);
    const DirectionSet directions(16384);
    const auto from = [](double x, double fov) {
        Camera camera = test::camera_at({x, 0, 5}, {x, 0, 0});
        camera.fov = fov;
        return project(camera, 64, 64);
    };
    const Projection whole = from(0, 24), left = from(-0.75, 6);
    const auto state_of = [&](const Visibility& visibility) {
        return SurfaceState{.geometry = surfaces.geometry(),
                            .visibility = &visibility,
                            .directions = &directions,
                            .versions = {.geometry = 1, .visibility = 1},
                            .materials = 1};
    };
    SeenTriangles triangles;
    triangles.update(surfaces.geometry(), 1);
    const auto seen = [&](const std::function<double(double)>& irradiance, const Projection& projection) {
        const Visibility visibility = lit(surfaces.geometry(), directions, irradiance);
        ShadowError error;
        return error.of(state_of(visibility), true, triangles, projection);
    };
    const auto linear = [](double x) { return 0.5 + 0.4 * x; };
    const auto square = [](double x) { return 0.1 + 0.8 * x * x; };
    // A parabola of second derivative k misses k h^2 / sqrt(120) in edges of length h.
    const double h = 2.0 / kCells;
    const double rms = std::sqrt(0.01 + 0.16 / 3 + 0.64 / 5);
    const double missed = 1.6 * h * h / std::sqrt(120.0) / rms;
    CHECK(seen(square, whole).error == doctest::Approx(missed).epsilon(0.25));
    CHECK(seen(linear, whole).error < 0.25 * missed);

    CHECK(seen(linear, whole).brightness == doctest::Approx(1).epsilon(0.1));
    // The error on all surfaces does not depend on the image.
    for (const Projection& projection : {whole, left}) {
        ShadowError error;
        const Visibility visibility = lit(surfaces.geometry(), directions, square);
        CHECK(error.of_all() == 0);
        (void)error.of(state_of(visibility), true, triangles, projection);
        CHECK(error.of_all() == doctest::Approx(missed).epsilon(0.25));
        (void)error.of({.geometry = surfaces.geometry(),
                        .visibility = nullptr,
                        .directions = nullptr,
                        .versions = {},
                        .materials = 1},
                       true, triangles, projection);
        CHECK(error.of_all() == 0);
    }

    CHECK(seen(linear, left).brightness == doctest::Approx(0.04 / (0.25 + 0.16 / 3)).epsilon(0.1));

    ShadowError none;
    const ShadowError::Seen unshadowed = none.of({.geometry = surfaces.geometry(),
                                                  .visibility = nullptr,
                                                  .directions = nullptr,
                                                  .versions = {.geometry = 1, .visibility = 0},
                                                  .materials = 1},
                                                 true, triangles, whole);
    CHECK(unshadowed.error == 0);
    CHECK(unshadowed.brightness == 1);
}

TEST_CASE("what a change of shadows keeps is not measured again, and the rest is") {
    Scene scene;
    scene.add({.mesh = grid(), .material = diffuse({0.5})});
    SceneGeometry surfaces;
    surfaces.update(scene);
    const WorldGeometry& geometry = surfaces.geometry();
    const DirectionSet directions(1024);
    const Projection projection = project(test::camera_at({0, 0, 5}, {0, 0, 0}), 64, 64);
    SeenTriangles triangles;
    triangles.update(geometry, 1);
    const Visibility square = lit(geometry, directions, [](double x) { return 0.1 + 0.8 * x * x; });
    const Visibility half =
        lit(geometry, directions, [](double x) { return x < 0 ? 0.6 : 0.1 + 0.8 * x * x; });
    std::vector<std::uint32_t> former(geometry.positions.size());
    for (std::uint32_t v = 0; v < former.size(); ++v) former[v] = geometry.positions[v].x < 0 ? kNoVertex : v;
    const std::vector<std::uint8_t> same_places(former.size(), 1);
    std::vector<std::uint8_t> same_normals;  // empty: all are the same
    const auto error_of = [&](ShadowError& error, const Visibility& visibility, Version version,
                              Version before) {
        SurfaceState state{.geometry = geometry,
                           .visibility = &visibility,
                           .directions = &directions,
                           .versions = {.geometry = 1, .visibility = version},
                           .materials = 1};
        if (before != 0)
            state.change = SurfaceChange{.before = {.geometry = 1, .visibility = before},
                                         .former = former,
                                         .same_places = same_places,
                                         .same_normals = same_normals};
        return error.of(state, true, triangles, projection).error;
    };
    ShadowError fresh, followed, missed, kept;
    const double wanted = error_of(fresh, half, 2, 0);
    const double before = error_of(followed, square, 1, 0);
    CHECK(std::abs(before - wanted) > 0.01 * wanted);
    CHECK(error_of(followed, half, 2, 1) == wanted);
    // A state in between was not measured.
    (void)error_of(missed, square, 1, 0);
    former.assign(former.size(), 0);
    CHECK(error_of(missed, half, 3, 2) == wanted);
    (void)error_of(kept, square, 1, 0);
    CHECK(error_of(kept, half, 2, 1) == 0);
    // Vertices with other normals keep nothing.
    ShadowError bent;
    (void)error_of(bent, square, 1, 0);
    same_normals.assign(former.size(), 0);
    CHECK(error_of(bent, half, 2, 1) == wanted);
}
