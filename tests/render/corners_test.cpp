// SPDX-License-Identifier: MIT
// Tests of texture coordinates and colours at triangle corners.
#include <span>

#include "render/scene_visibility.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::at;

namespace {

/// Returns the texture coordinates at a point of the floor below.
glm::vec2 texcoord_at(const glm::vec3& p) {
    return {0.5F + 0.25F * p.x, 0.5F + 0.25F * p.z};
}
glm::vec3 color_at(const glm::vec3& p) {
    return {0.5F + 0.25F * p.x, 0.5F + 0.25F * p.z, 0.25F};
}

/// Colours of the two triangles of the floor, which meet at x = -z.
const std::vector<glm::vec3> face_colors{{1, 0.5F, 0.25F}, {0, 0.75F, 0.125F}};

std::shared_ptr<const Mesh> floor() {
    Mesh mesh = *test::with_texcoords(make_rectangle(1));
    for (const glm::vec3& p : mesh.positions)
        mesh.colors.emplace_back(0.5F + 0.5F * p.x, 0.5F - 0.5F * p.y, 0.25F);
    mesh.face_colors = face_colors;
    return std::make_shared<const Mesh>(std::move(mesh));
}

/// Returns a ball (id 0) on a floor (id 1).
Scene ball_on_floor(const MaterialPtr& material, bool mirrored) {
    Scene scene;
    scene.set_environment(test::falling_light(3, false, 1), glm::dmat3(1), 1);
    Mesh ball = *test::coarse_sphere(2);
    ball.texcoords.clear();
    ball.texcoord_triangles.clear();
    scene.add({.mesh = std::make_shared<const Mesh>(std::move(ball)),
               .material = diffuse({0.5}),
               .to_world = at(0.3, 0.4, 0, 0.4)});
    glm::dmat4 to_world = test::plate_at(0, 2);
    Mesh mesh = *floor();
    if (mirrored) {
        // Mirroring both mesh and transform gives the original floor.
        const glm::dmat4 mirror = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
        mesh = transformed(mesh, mirror);
        to_world *= mirror;
    }
    scene.add({.mesh = std::make_shared<const Mesh>(mesh), .material = material, .to_world = to_world});
    return scene;
}

struct Surfaces {
    void update(const Scene& scene, double tolerance) {
        geometry.update(scene);
        SurfaceRays rays(geometry);
        const Projection view = project(Camera(), 8, 8);
        visibility.update(geometry, rays, true, {.needs = ImageNeeds::all, .views = {&view, 1}},
                          {.bake_directions = 512, .refine_tolerance = tolerance, .max_vertices = 4096},
                          workers, progress, statistics);
        visibility.count(geometry, statistics);
    }
    [[nodiscard]] const WorldGeometry& world() const { return visibility.surfaces().geometry(); }

    SceneGeometry geometry;
    SceneVisibility visibility;
    Workers workers{{.threads = 2}};
    Progress::Callback nobody;
    Progress progress{nobody};
    Statistics statistics;
};

/// Checks every corner against its position. The ball has no coordinates or colours of its own.
void check_corners(const Surfaces& surfaces, bool texcoords, bool colors) {
    const WorldGeometry& world = surfaces.world();
    const glm::mat4 to_world(surfaces.visibility.surfaces().to_world());
    REQUIRE(world.texcoords.size() == (texcoords ? world.triangles.size() : 0));
    REQUIRE(world.colors.size() == (colors ? world.triangles.size() : 0));
    for (std::size_t i = 0; i < world.triangles.size(); ++i) {
        const bool on_floor = world.triangles[i].x >= world.ranges[1].first;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = world.triangles[i][static_cast<glm::length_t>(k)];
            const glm::vec3 p(to_world * glm::vec4(world.positions[v], 1));
            const glm::vec2 uv = on_floor ? texcoord_at(p) : glm::vec2(0);
            if (texcoords) CHECK(glm::distance(world.texcoords[i][k], uv) < 1e-6F);
            const glm::vec3 color = on_floor ? color_at(p) : glm::vec3(1);
            if (colors) CHECK(glm::distance(world.colors[i][k], color) < 1e-6F);
        }
    }
}

}  // namespace

TEST_CASE("corners have what the mesh has there: on both sides, mirrored and split") {
    for (const bool two_sided : {false, true})
        for (const bool mirrored : {false, true})
            for (const double tolerance : {0.0, 0.02}) {
                CAPTURES(two_sided, mirrored, tolerance);
                const MaterialPtr plain = two_sided ? twosided(diffuse({0.5})) : diffuse({0.5});
                const MaterialPtr by_texture =
                    scaled(plain, test::texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x); }));
                const MaterialPtr by_color = scaled(plain, test::mesh_colors(ColorsOf::vertices));
                Scene scene = ball_on_floor(plain, mirrored);
                Surfaces surfaces;
                surfaces.update(scene, tolerance);
                CHECK((surfaces.statistics.vertices_added > 20) == (tolerance > 0));
                check_corners(surfaces, false, false);

                // Other materials do not change the geometry.
                const Version geometry = surfaces.visibility.surfaces().version();
                Version materials = surfaces.visibility.surfaces().material_version();
                struct Case {
                    MaterialPtr material;
                    bool texcoords, colors;
                };
                for (const Case& one : {Case{by_texture, true, false},
                                        {by_color, false, true},
                                        {normal_mapped(by_color, test::flat_normals()), true, true},
                                        {plain, false, false}}) {
                    CAPTURES(one.texcoords, one.colors);
                    scene.set_material(1, one.material);
                    surfaces.update(scene, tolerance);
                    check_corners(surfaces, one.texcoords, one.colors);
                    CHECK(surfaces.visibility.surfaces().version() == geometry);
                    CHECK(surfaces.visibility.surfaces().material_version() != materials);
                    materials = surfaces.visibility.surfaces().material_version();
                    Surfaces fresh;
                    fresh.update(scene, tolerance);
                    check_corners(fresh, one.texcoords, one.colors);
                }

                // The geometry changes while the materials stay.
                scene.set_material(1, by_texture);
                scene.set_transform(0, at(-0.3, 0.5, 0.2, 0.4));
                surfaces.update(scene, tolerance);
                check_corners(surfaces, true, false);
                CHECK(surfaces.visibility.surfaces().version() != geometry);
            }
}

TEST_CASE("corners have the colour of their face: on both sides, mirrored and split") {
    for (const bool two_sided : {false, true})
        for (const bool mirrored : {false, true})
            for (const double tolerance : {0.0, 0.02}) {
                CAPTURES(two_sided, mirrored, tolerance);
                const MaterialPtr plain = two_sided ? twosided(diffuse({0.5})) : diffuse({0.5});
                Surfaces surfaces;
                surfaces.update(ball_on_floor(scaled(plain, test::mesh_colors(ColorsOf::faces)), mirrored),
                                tolerance);
                const WorldGeometry& world = surfaces.world();
                const glm::mat4 to_world(surfaces.visibility.surfaces().to_world());
                REQUIRE(world.colors.size() == world.triangles.size());
                std::array<int, 2> of_face{};
                for (std::size_t i = 0; i < world.triangles.size(); ++i) {
                    const glm::uvec3& t = world.triangles[i];
                    if (t.x < world.ranges[1].first) {
                        CHECK(world.colors[i][0] == glm::vec3(1));
                        continue;
                    }
                    const glm::vec3 middle(
                        to_world *
                        glm::vec4((world.positions[t.x] + world.positions[t.y] + world.positions[t.z]) / 3.0F,
                                  1));
                    const std::size_t face = middle.x + middle.z > 0 ? 0 : 1;
                    ++of_face[face];
                    for (const glm::vec3& color : world.colors[i])
                        CHECK(glm::distance(color, face_colors[face]) < 1e-6F);
                }
                CHECK(of_face[0] > 0);
                CHECK(of_face[1] > 0);
            }
}
