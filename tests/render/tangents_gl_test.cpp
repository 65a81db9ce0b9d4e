// SPDX-License-Identifier: MIT
// Tests of a mesh's tangents and of rotated anisotropic materials: pictures of one surface described in two
// ways.
#include <numbers>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::rms;
using test::rms_difference;

namespace {

constexpr double kAngle = 0.6;
const float kCosine = std::cos(static_cast<float>(kAngle)), kSine = std::sin(static_cast<float>(kAngle));

using MeshPtr = std::shared_ptr<const Mesh>;

// Returns a floor whose u grows along (x, y) and whose v falls along (-y, x), or (y, -x) if `mirrored`.
MeshPtr floor_along(const glm::vec2& along, bool mirrored = false) {
    Mesh mesh = *test::with_texcoords(make_rectangle(6));
    const glm::vec2 across = (mirrored ? -1.0F : 1.0F) * glm::vec2(-along.y, along.x);
    for (glm::vec2& uv : mesh.texcoords) {
        const glm::vec2 place(uv.x - 0.5F, 0.5F - uv.y);
        uv = {0.5F + glm::dot(place, along), 0.5F - glm::dot(place, across)};
    }
    return std::make_shared<const Mesh>(std::move(mesh));
}

// Returns the floor with one tangent everywhere.
MeshPtr with_tangent(const MeshPtr& floor, const glm::vec4& tangent) {
    Mesh mesh = *floor;
    mesh.tangents.assign(mesh.texcoords.size(), tangent);
    return std::make_shared<const Mesh>(std::move(mesh));
}

Scene scene_of(const MeshPtr& floor, const MaterialPtr& material, const glm::dvec3& sizes) {
    EquirectImage image(64, 33, 1);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) image.at(0, y, x)[0] = (x / 4 + y / 4) % 2 == 0 ? 1.5F : 0.5F;
    Scene scene;
    scene.set_environment(image_environment(image), glm::dmat3(1), 1);
    scene.add({.mesh = floor,
               .material = material,
               .to_world = test::plate_at(-1, 2) * glm::scale(glm::dmat4(1), sizes)});
    return scene;
}

}  // namespace

IMAGE_TEST_CASE("tangents, an angle and a texture of directions rotate brushed metal as u and v do") {
    const MaterialPtr metal = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.05, .alpha_v = 0.4});
    const TexturePtr directions = test::texture_of(
        [](const TexturePoint&) { return glm::vec4(0.5F + 0.5F * kCosine, 0.5F + 0.5F * kSine, 1, 1); });
    test::Studio studio(context, 48, 36);
    RenderOptions fast{.bake_directions = 256,
                       .order_low = 2,
                       .order_high = 2,
                       .shade_at = ShadeAt::pixels,
                       .bsdf_samples = 8};
    for (const Method method : {Method::factored, Method::reference})
        for (const bool mirrored : {false, true})
            for (const bool below : {false, true}) {
                CAPTURES(method, mirrored, below);
                const MaterialPtr sheet = below ? twosided(metal) : metal;
                const glm::dvec3 sizes(mirrored ? -1 : 1, 1, 1);
                const Camera camera = test::camera_at({1, below ? -3.0 : 2.0, 3});
                RenderOptions options = fast;
                options.method = method;
                options.samples = 4;
                const auto picture = [&](const MeshPtr& floor, const MaterialPtr& material) {
                    return studio(scene_of(floor, material, sizes), options, camera);
                };
                const StokesImage expected = picture(floor_along({kCosine, kSine}), sheet);
                const auto same = [&](const MeshPtr& floor, const MaterialPtr& material,
                                      double tolerance = 1e-4) {
                    return rms_difference(picture(floor, material), expected) < tolerance * rms(expected);
                };
                CHECK_FALSE(same(floor_along({1, 0}), sheet));
                CHECK(same(floor_along({1, 0}), rotated(sheet, nullptr, kAngle)));
                CHECK(same(floor_along({1, 0}), rotated(sheet, directions, 0)));
                CHECK(same(with_tangent(floor_along({1, 0}), {kCosine, kSine, 0, 1}), sheet));
                CHECK(same(with_tangent(floor_along({0, 1}), {1, 0, 0, 1}), rotated(sheet, nullptr, kAngle)));
                CHECK(
                    same(with_tangent(floor_along({0, 1}), {1, 0, 0, -1}), rotated(sheet, nullptr, -kAngle)));
                // The opposite direction gives the same surface, but rays other noise, and exchanges the
                // nodes of a lobe's pairs, whose first ones say where the light leans.
                if (method == Method::reference) continue;
                CHECK(same(floor_along({1, 0}), rotated(sheet, directions, std::numbers::pi), 5e-3));
                CHECK(same(floor_along({-1, 0}, true), rotated(sheet, nullptr, -kAngle), 5e-3));
            }
}

IMAGE_TEST_CASE("normal maps follow a mesh's tangents") {
    const glm::vec3 local = glm::normalize(glm::vec3(0.3F, -0.2F, 1));
    const MaterialPtr plain = pplastic({.diffuse_reflectance = {0.5}, .alpha = 0.2});
    const MaterialPtr sheet = twosided(normal_mapped(
        plain, test::texture_of([&](const TexturePoint&) { return glm::vec4(0.5F + 0.5F * local, 1); }),
        {.mirrored_y = true}));
    test::Studio studio(context, 48, 36);
    const RenderOptions options{.executor = Executor::cpu,
                                .bake_directions = 256,
                                .order_low = 2,
                                .order_high = 6,
                                .shade_at = ShadeAt::pixels};
    for (const bool mirrored : {false, true})
        for (const bool below : {false, true}) {
            CAPTURES(mirrored, below);
            const Camera camera = test::camera_at({1, below ? -3.0 : 2.0, 3});
            const auto picture = [&](const MeshPtr& floor) {
                return studio(scene_of(floor, sheet, {mirrored ? -1 : 1, 1, 1}), options, camera);
            };
            for (const bool turned : {false, true}) {
                const StokesImage expected = picture(floor_along({kCosine, kSine}, turned));
                const StokesImage other = picture(floor_along({1, 0}));
                CHECK(rms_difference(other, expected) > 0.01 * rms(expected));
                const StokesImage image =
                    picture(with_tangent(floor_along({1, 0}), {kCosine, kSine, 0, turned ? -1.0F : 1.0F}));
                CHECK(rms_difference(image, expected) < 1e-4 * rms(expected));
            }
        }
}
