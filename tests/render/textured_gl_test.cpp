// SPDX-License-Identifier: MIT
// Tests of textured materials shaded at pixels.
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "material/chiral_material.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::falling_light;
using test::minus;
using test::rms;
using test::Studio;
using test::texture_of;

namespace {

RenderOptions options(int order_high = 9, bool shadows = true) {
    return {.executor = Executor::cpu,
            .shadows = shadows,
            .bake_directions = 512,
            .order_low = 4,
            .order_high = order_high,
            .shade_at = ShadeAt::pixels};
}

/// Returns a texture of equal values that does not count as constant.
TexturePtr even(const glm::vec4& value, int channels = 3) {
    return texture_of([value](const TexturePoint&) { return value; }, channels);
}
TexturePtr ramp() {
    return texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x); }, 1);
}
/// Returns 0 or 1 in a checkerboard of eight squares across.
float check(const glm::vec2& uv) {
    const glm::ivec2 cell(glm::floor(8.0F * uv));
    return (cell.x + cell.y) % 2 == 0 ? 0.0F : 1.0F;
}
TexturePtr checks() {
    return texture_of([](const TexturePoint& p) { return glm::vec4(check(p.uv)); }, 1);
}

std::shared_ptr<const Mesh> textured_floor() {
    static const auto mesh = test::with_texcoords(make_rectangle(1));
    return mesh;
}

/// Returns a ball over a floor of two triangles, which its shadow splits.
Scene ball_over(const MaterialPtr& floor, bool polarized = true,
                const glm::dmat4& floor_to_world = test::plate_at(-1, 2)) {
    static const MaterialPtr grey = diffuse({0.5});
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(6), .material = grey, .to_world = test::at(0.2, 0, 0.1, 0.7)});
    scene.add({.mesh = textured_floor(), .material = floor, .to_world = floor_to_world});
    scene.set_environment(falling_light(9, polarized, 3),
                          theta_phi_frame(glm::normalize(glm::dvec3(1, -2, 0.7))), 0.7);
    return scene;
}

MaterialPtr plastic(double alpha = 0.3) {
    return pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = alpha});
}

/// An image, and its pixels' texture coordinates on the floor (negative elsewhere).
struct Seen {
    StokesImage image;
    std::vector<glm::vec2> uv;
};
Seen see(const std::shared_ptr<gl::Context>& context, const Scene& scene, RenderOptions options,
         const Camera& camera = test::some_camera()) {
    Renderer renderer(context);
    Framebuffer target(context, 96, 72, scene.channels());
    options.aovs = aov_positions | aov_instances;
    renderer.render(scene, camera, options, target);
    Seen out{.image = target.image(), .uv = {}};
    const Aovs& aovs = target.aovs();
    for (std::size_t p = 0; p < aovs.instances.size(); ++p) {
        const bool floor = aovs.instances[p] == 1;
        out.uv.emplace_back(floor ? 0.5F + 0.25F * aovs.positions[3 * p] : -1,
                            floor ? 0.5F + 0.25F * aovs.positions[3 * p + 2] : -1);
    }
    return out;
}

/// Calls body(x, y, uv) for every pixel of the floor.
template <class Body>
void for_floor(const Seen& seen, const Body& body) {
    const int width = seen.image.width;
    int count = 0;
    for (int p = 0; p < static_cast<int>(seen.uv.size()); ++p) {
        if (seen.uv[static_cast<std::size_t>(p)].x < 0) continue;
        ++count;
        body(p % width, p / width, seen.uv[static_cast<std::size_t>(p)]);
    }
    CHECK(count > 500);
}

}  // namespace

IMAGE_TEST_CASE("textures of one value give the picture without any") {
    const MaterialPtr metal = test::some_metal(0.2);
    for (const bool polarized : {false, true})
        for (const int order_high : {4, 9})
            for (const MaterialPtr& plain : {twosided(plastic()), metal, diffuse({0.2, 0.5, 0.9})}) {
                CAPTURES(polarized, order_high);
                // Both are first images, which by default refine what they show alone.
                Studio render_plain(context), render(context);
                const StokesImage expected =
                    render_plain(ball_over(scaled(plain, constant_texture(glm::vec4(0.25), 1)), polarized),
                                 options(order_high));
                CHECK(render_plain.statistics.vertices_added > 0);
                const MaterialPtr textured =
                    normal_mapped(scaled(blend(plain, plain, even(glm::vec4(0.3F))), even(glm::vec4(0.25))),
                                  test::flat_normals());
                const StokesImage image = render(ball_over(textured, polarized), options(order_high));
                CHECK(render.statistics.pixels_shaded > 500);
                CHECK(rms(minus(image, expected)) < 1e-5 * rms(expected));
            }
}

// Both have one lobe width, because visible fractions of high orders belong to surfaces, not to layers.
IMAGE_TEST_CASE("a checkerboard of two materials is one or the other") {
    const MaterialPtr first = plastic(0.3);
    const MaterialPtr second = test::some_metal(0.3);
    const Seen seen = see(context, ball_over(blend(first, second, checks())), options());
    const StokesImage a = see(context, ball_over(first), options()).image;
    const StokesImage b = see(context, ball_over(second), options()).image;
    double worst = 0;
    for_floor(seen, [&](int x, int y, const glm::vec2& uv) {
        // Pixels at square borders are skipped, because positions are rounded.
        if (check(uv - 1e-4F) != check(uv + 1e-4F)) return;
        for (int c = 0; c < 3; ++c) {
            const StokesImage& expected = check(uv) == 0 ? a : b;
            for (std::size_t p = 0; p < 4; ++p)
                worst = std::max(worst, static_cast<double>(
                                            std::abs(seen.image.at(c, y, x)[p] - expected.at(c, y, x)[p])));
        }
    });
    CHECK(worst < 1e-5 * rms(a));
    CHECK(rms(minus(a, b)) > 0.1 * rms(a));
}

IMAGE_TEST_CASE("a blend of 0.3 is 0.7 of one and 0.3 of the other") {
    Studio render(context);
    const MaterialPtr first = plastic(0.3);
    struct Case {
        MaterialPtr second;
        bool shadows;
    };
    for (const auto& [second, shadows] : {Case{test::some_metal(0.3), false},
                                          {test::some_metal(0.3), true},
                                          // The materials have two pairings and one.
                                          {test::chiral(test::some_metal(0.3)), false}}) {
        RenderOptions with_shadows = options(9, shadows);
        // By default the first image alone refines what it shows alone.
        with_shadows.disabled_optimisations = skip_rays;
        const auto image = [&](const MaterialPtr& floor) { return render(ball_over(floor), with_shadows); };
        StokesImage expected = image(first);
        const StokesImage other = image(second);
        for (std::size_t i = 0; i < expected.data.size(); ++i)
            expected.data[i] = 0.7F * expected.data[i] + 0.3F * other.data[i];
        CHECK(rms(minus(image(blend(first, second, even(glm::vec4(0.3F)))), expected)) <
              1e-5 * rms(expected));
    }
}

IMAGE_TEST_CASE("a ramp is exact on a floor that shadows split, on both sides and mirrored") {
    for (const bool below : {false, true})
        for (const bool mirrored : {false, true}) {
            CAPTURES(below, mirrored);
            glm::dmat4 to_world = test::plate_at(-1, 2);
            if (mirrored) to_world *= glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
            const MaterialPtr white = twosided(diffuse({1.0}));
            const Camera camera = test::camera_at({2, below ? -4.0 : 3.0, 4});
            const Seen seen =
                see(context, ball_over(scaled(white, ramp()), false, to_world), options(4), camera);
            const StokesImage plain =
                see(context, ball_over(white, false, to_world), options(4), camera).image;
            double worst = 0;
            for_floor(seen, [&](int x, int y, const glm::vec2& uv) {
                const float u = mirrored ? 1 - uv.x : uv.x;
                const float ratio = seen.image.at(1, y, x)[0] / plain.at(1, y, x)[0];
                worst = std::max(worst, static_cast<double>(std::abs(ratio - u)));
            });
            CHECK(worst < gl::tolerance_of(context) * 2e-5);
        }
}

IMAGE_TEST_CASE("vertex colours are interpolated") {
    Mesh mesh = *textured_floor();
    for (const glm::vec3& p : mesh.positions)
        mesh.colors.emplace_back(0.5F + 0.5F * p.x, 0.25F, 0.5F - 0.5F * p.y);
    const auto colored = std::make_shared<const Mesh>(std::move(mesh));
    const auto scene = [&](const MaterialPtr& floor) {
        Scene out;
        out.add({.mesh = test::coarse_sphere(2), .material = diffuse({0.5}), .to_world = test::at(0, 9, 0)});
        out.add({.mesh = colored, .material = floor, .to_world = test::plate_at(-1, 2)});
        out.set_environment(falling_light(4, true, 1), glm::dmat3(1), 1);
        return out;
    };
    const Seen seen =
        see(context, scene(scaled(plastic(), test::mesh_colors(ColorsOf::vertices))), options(4));
    const StokesImage plain = see(context, scene(plastic()), options(4)).image;
    double worst = 0;
    for_floor(seen, [&](int x, int y, const glm::vec2& uv) {
        const glm::vec3 color(uv.x, 0.25F, uv.y);
        for (int c = 0; c < 3; ++c)
            for (std::size_t p = 0; p < 4; ++p)
                worst = std::max(worst, static_cast<double>(std::abs(seen.image.at(c, y, x)[p] -
                                                                     color[c] * plain.at(c, y, x)[p])));
    });
    CHECK(worst < gl::tolerance_of(context) * 1e-5 * rms(plain));
}

IMAGE_TEST_CASE("colours of faces are the same across each, by every method") {
    const glm::vec3 colors[] = {{1, 0.25F, 0.5F}, {0.125F, 1, 0.75F}};
    Mesh mesh = *textured_floor();
    mesh.face_colors.assign(std::begin(colors), std::end(colors));
    mesh.colors.resize(mesh.positions.size(), glm::vec3(0));  // colours of another kind of texture
    const auto colored = std::make_shared<const Mesh>(std::move(mesh));
    RenderOptions reference = options(4);
    reference.method = Method::reference;
    reference.samples = 16;
    for (const RenderOptions& method : {options(4), reference}) {
        CAPTURE(method.method);
        const auto image = [&](const MaterialPtr& floor) {
            Scene scene;
            scene.add(
                {.mesh = test::coarse_sphere(2), .material = diffuse({0.5}), .to_world = test::at(0, 9, 0)});
            scene.add({.mesh = colored, .material = floor, .to_world = test::plate_at(-1, 2)});
            scene.set_environment(falling_light(4, true, 1), glm::dmat3(1), 1);
            return see(context, scene, method);
        };
        const Seen seen = image(scaled(plastic(), mesh_color_texture(ColorsOf::faces)));
        const StokesImage expected[] = {image(scaled(plastic(), even(glm::vec4(colors[0], 1)))).image,
                                        image(scaled(plastic(), even(glm::vec4(colors[1], 1)))).image};
        const auto face_at = [](const glm::vec2& uv) { return uv.x + uv.y > 1 ? 0 : 1; };
        double worst = 0;
        for_floor(seen, [&](int x, int y, const glm::vec2& uv) {
            if (face_at(uv - 0.05F) != face_at(uv + 0.05F)) return;
            for (int c = 0; c < 3; ++c)
                for (std::size_t p = 0; p < 4; ++p)
                    worst =
                        std::max(worst, static_cast<double>(std::abs(seen.image.at(c, y, x)[p] -
                                                                     expected[face_at(uv)].at(c, y, x)[p])));
        });
        CHECK(worst < 1e-5 * rms(expected[0]));
    }
}

IMAGE_TEST_CASE("a surface emits the colours of its mesh") {
    Mesh mesh = *textured_floor();
    for (const glm::vec3& p : mesh.positions)
        mesh.colors.emplace_back(0.5F + 0.5F * p.x, 0.25F, 0.5F - 0.5F * p.y);
    mesh.face_colors = {{1, 0.25F, 0.5F}, {0.125F, 1, 0.75F}};
    const auto colored = std::make_shared<const Mesh>(std::move(mesh));
    RenderOptions reference = options(4);
    reference.method = Method::reference;
    reference.samples = 64;
    for (const ColorsOf of : {ColorsOf::vertices, ColorsOf::faces})
        for (const RenderOptions& method : {options(4), reference}) {
            CAPTURE(method.method);
            Scene scene;
            scene.add(
                {.mesh = test::coarse_sphere(2), .material = diffuse({0.5}), .to_world = test::at(0, 9, 0)});
            scene.add({.mesh = colored,
                       .material = diffuse({0}),
                       .to_world = test::plate_at(-1, 2),
                       .emission = std::make_shared<const Emission>(
                           Emission{.radiance = {2}, .texture = mesh_color_texture(of)})});
            const Seen seen = see(context, scene, method);
            const auto color_at = [&](const glm::vec2& uv) {
                if (of == ColorsOf::vertices) return glm::vec3(uv.x, 0.25F, uv.y);
                return colored->face_colors[uv.x + uv.y > 1 ? 0 : 1];
            };
            double worst = 0;
            for_floor(seen, [&](int x, int y, const glm::vec2& uv) {
                // A pixel of the reference method is a mean over places.
                const float around = method.method == Method::reference ? 0.05F : 1e-3F;
                if (color_at(uv - around).y != color_at(uv + around).y) return;
                if (glm::clamp(uv, around, 1 - around) != uv) return;
                for (int c = 0; c < 3; ++c)
                    worst = std::max(worst, static_cast<double>(
                                                std::abs(seen.image.at(c, y, x)[0] - 2 * color_at(uv)[c])));
            });
            // Graphics processors interpolate with fewer bits than Mesa's software.
            CHECK(worst < (method.method == Method::reference ? 0.02 : 1e-4));
        }
    Scene scene;
    const auto add = [&](const std::shared_ptr<const Mesh>& of, ColorsOf colors) {
        scene.add(
            {.mesh = of,
             .material = diffuse({0}),
             .to_world = test::plate_at(-1, 2),
             .emission = std::make_shared<const Emission>(Emission{.texture = mesh_color_texture(colors)})});
    };
    check_error(ErrorCode::invalid_argument, CALL(add(textured_floor(), ColorsOf::vertices)),
                "the colours of vertices, and the mesh has none");
    check_error(ErrorCode::invalid_argument, CALL(add(textured_floor(), ColorsOf::faces)),
                "the colours of faces, and the mesh has none");
    Mesh dark = *colored;
    dark.colors[1].z = -0.1F;
    check_error(ErrorCode::invalid_argument,
                CALL(add(std::make_shared<const Mesh>(dark), ColorsOf::vertices)), "below 0");
}

IMAGE_TEST_CASE("a roughness texture of a few values is exact, and smooth between others") {
    const auto rough = [](double alpha) { return test::some_metal(alpha); };
    const TexturePtr two = checkerboard_texture(glm::vec3(0.2F), glm::vec3(0.4F), 1);
    const Seen seen = see(context, ball_over(with_roughness(rough, two)), options(4));
    const StokesImage a = see(context, ball_over(rough(0.2)), options(4)).image;
    const StokesImage b = see(context, ball_over(rough(0.4)), options(4)).image;
    double worst = 0;
    for_floor(seen, [&](int x, int y, const glm::vec2& uv) {
        const bool even = (uv.x < 0.5F) == (uv.y < 0.5F);
        const glm::vec2 edge = glm::abs(2.0F * uv - glm::round(2.0F * uv));
        if (glm::any(glm::lessThan(edge, glm::vec2(0.12F)))) return;  // pixels of several squares
        for (std::size_t p = 0; p < 4; ++p)
            worst = std::max(worst, static_cast<double>(
                                        std::abs(seen.image.at(0, y, x)[p] - (even ? a : b).at(0, y, x)[p])));
    });
    CHECK(worst < 3e-5 * rms(a));

    // Pixels of the ramp are close to those of a constant roughness. The layers are 20 % apart.
    const TexturePtr alphas =
        texture_of([](const TexturePoint& p) { return glm::vec4(0.2F + 0.2F * p.uv.x); }, 1);
    const StokesImage ramped = see(context, ball_over(with_roughness(rough, alphas)), options(4)).image;
    for (const double alpha : {0.25, 0.3, 0.35}) {
        const StokesImage plain = see(context, ball_over(rough(alpha)), options(4)).image;
        double error = 0;
        int near = 0;
        for_floor(seen, [&](int x, int y, const glm::vec2& uv) {
            if (std::abs(0.2F + 0.2F * uv.x - static_cast<float>(alpha)) > 2e-3F) return;
            ++near;
            for (std::size_t p = 0; p < 4; ++p)
                error = std::max(error,
                                 static_cast<double>(std::abs(ramped.at(0, y, x)[p] - plain.at(0, y, x)[p])));
        });
        CHECK(near > 5);
        CHECK(error < 0.02 * rms(plain));
    }
}

IMAGE_TEST_CASE("a map or a bump of one slope is the picture of normals that are tilted so") {
    // u grows along x and v falls along y in the rectangle's axes.
    const glm::vec3 tilted = glm::normalize(glm::vec3(0.3F, -0.2F, 1));
    Mesh mesh = *textured_floor();
    for (glm::vec3& normal : mesh.normals) normal = tilted;
    const auto expected_mesh = std::make_shared<const Mesh>(mesh);
    const auto scene = [](const std::shared_ptr<const Mesh>& floor, const MaterialPtr& material) {
        Scene out;
        out.add({.mesh = floor, .material = material, .to_world = test::plate_at(-1, 2)});
        out.set_environment(falling_light(9, true, 3), theta_phi_frame(glm::dvec3(0, 0.6, 0.8)), 1);
        return out;
    };
    Mesh mirrored = *textured_floor();
    for (glm::vec2& uv : mirrored.texcoords) uv.x = 1 - uv.x;
    const auto mirrored_mesh = std::make_shared<const Mesh>(std::move(mirrored));
    const TexturePtr map = even(glm::vec4(0.5F + 0.5F * tilted, 1));
    // Half a unit of u or v is one unit of length in the mesh's axes and two in the world's.
    const TexturePtr heights = texture_of(
        [&](const TexturePoint& p) {
            return glm::vec4(4 * (-tilted.x / tilted.z * p.uv.x + tilted.y / tilted.z * p.uv.y));
        },
        1);
    Studio render(context);
    for (const int order_high : {4, 9})
        for (const bool two_sided : {false, true}) {
            const MaterialPtr plain = two_sided ? twosided(plastic()) : plastic();
            const Camera above = test::some_camera();
            const StokesImage expected =
                render(scene(expected_mesh, plain), options(order_high, false), above);
            const auto check = [&](const std::shared_ptr<const Mesh>& floor, const MaterialPtr& material) {
                const StokesImage image = render(scene(floor, material), options(order_high, false), above);
                CHECK(rms(minus(image, expected)) < 2e-5 * rms(expected));
            };
            CAPTURES(order_high, two_sided);
            check(textured_floor(), normal_mapped(plain, map));
            check(textured_floor(), normal_mapped(plain, map, {.mirrored_y = true}));
            check(textured_floor(), bump_mapped(plain, heights, 1));
            // u falls along x here, so the map's x falls, and y in a right-handed frame.
            check(mirrored_mesh,
                  normal_mapped(plain, even(glm::vec4(0.5F - 0.5F * tilted.x, 0.5F - 0.5F * tilted.y,
                                                      0.5F + 0.5F * tilted.z, 1))));
            check(mirrored_mesh, normal_mapped(plain,
                                               even(glm::vec4(0.5F - 0.5F * tilted.x, 0.5F + 0.5F * tilted.y,
                                                              0.5F + 0.5F * tilted.z, 1)),
                                               {.mirrored_y = true}));
        }

    // The back of a map inside a two-sided material is the mirror image of the front in the surface; that of
    // a map around it has the reversed normal.
    Camera below = test::camera_at({2, -5, 4});
    const MaterialPtr sheet = twosided(plastic());
    Mesh back = *textured_floor();
    for (glm::uvec3& t : back.triangles) std::swap(t.y, t.z);
    for (const bool around : {false, true}) {
        CAPTURE(around);
        for (glm::vec3& normal : back.normals)
            normal = around ? -tilted : glm::vec3(tilted.x, tilted.y, -tilted.z);
        const StokesImage expected =
            render(scene(std::make_shared<const Mesh>(back), sheet), options(9, false), below);
        const MaterialPtr mapped =
            around ? normal_mapped(sheet, map) : twosided(normal_mapped(plastic(), map));
        const StokesImage image = render(scene(textured_floor(), mapped), options(9, false), below);
        CHECK(rms(minus(image, expected)) < 2e-5 * rms(expected));
    }
}

IMAGE_TEST_CASE("a texture learns how far its neighbours are") {
    for (const bool orthographic : {false, true}) {
        Camera camera = test::some_camera();
        camera.orthographic = orthographic;
        if (orthographic) camera.to_world = camera.to_world * glm::dmat4(glm::dmat3(2.0));
        const MaterialPtr white = diffuse({1.0});
        const auto ratios = [&](const std::function<float(const TexturePoint&)>& value) {
            const MaterialPtr material =
                scaled(white, texture_of([value](const TexturePoint& p) { return glm::vec4(value(p)); }, 1));
            StokesImage image = see(context, ball_over(material, false), options(4), camera).image;
            const StokesImage plain = see(context, ball_over(white, false), options(4), camera).image;
            for (std::size_t i = 0; i < image.data.size(); ++i)
                image.data[i] = plain.data[i] > 0 ? image.data[i] / plain.data[i] : 0;
            return image;
        };
        const Seen seen = see(context, ball_over(white, false), options(4), camera);
        const StokesImage u = ratios([](const TexturePoint& p) { return p.uv.x; });
        const StokesImage v = ratios([](const TexturePoint& p) { return p.uv.y; });
        const StokesImage du = ratios([](const TexturePoint& p) { return 1 + p.du.x; });
        const StokesImage dv = ratios([](const TexturePoint& p) { return 1 + p.dv.y; });
        int checked = 0;
        for_floor(seen, [&](int x, int y, const glm::vec2&) {
            const auto on_floor = [&](int i, int j) {
                return i >= 0 && i < 96 && j >= 0 && j < 72 &&
                       seen.uv[static_cast<std::size_t>(j * 96 + i)].x >= 0;
            };
            if (!on_floor(x - 1, y) || !on_floor(x + 1, y) || !on_floor(x, y - 1) || !on_floor(x, y + 1))
                return;
            ++checked;
            const float across = (u.at(0, y, x + 1)[0] - u.at(0, y, x - 1)[0]) / 2;
            const float down = (v.at(0, y + 1, x)[0] - v.at(0, y - 1, x)[0]) / 2;
            CHECK(std::abs(du.at(0, y, x)[0] - 1 - across) < 2e-4F + 0.02F * std::abs(across));
            CHECK(std::abs(dv.at(0, y, x)[0] - 1 - down) < 2e-4F + 0.02F * std::abs(down));
        });
        CHECK(checked > 400);
    }
}

IMAGE_TEST_CASE("a change of textures ends where a fresh start does") {
    Studio render(context);
    Scene scene = ball_over(plastic());
    const auto as_fresh = [&] {
        // By default vertices keep their light if a move hides almost nothing more from them.
        RenderOptions exact = options(5);
        exact.disabled_optimisations = skip_rays;
        const StokesImage image = render(scene, exact);
        CHECK(rms(minus(image, Studio(context)(scene, exact))) < 1e-5 * rms(image));
    };
    as_fresh();
    scene.set_material(1, scaled(plastic(), ramp()));
    as_fresh();
    scene.set_material(1, blend(plastic(), test::some_metal(0.3), checks()));
    as_fresh();
    scene.set_transform(0, test::at(-0.3, 0.1, 0, 0.5));
    as_fresh();
    scene.set_material(0, scaled(plastic(0.4), ramp()));
    as_fresh();
    scene.set_material(1, plastic());
    as_fresh();
}

IMAGE_TEST_CASE("what has no textures is refused, and nothing else") {
    Studio render(context);
    const Scene varying = ball_over(scaled(plastic(), ramp()));
    const Scene plain = ball_over(plastic());
    struct Case {
        RenderOptions options;
        const char* field;
    };
    RenderOptions vertices = options();
    vertices.shade_at = ShadeAt::vertices;
    RenderOptions dense = options(4);
    dense.method = Method::dense;
    for (const Case& one : {Case{vertices, "shade_at"}, {dense, "method"}}) {
        CAPTURES(one.field);
        check_error(ErrorCode::unsupported, CALL(render(varying, one.options)), "texture", one.field);
    }
    CHECK_NOTHROW(render(plain, vertices));
    CHECK_NOTHROW(render(plain, dense));
    RenderOptions any = options();
    any.shade_at = ShadeAt::automatic;
    any.pixel_samples = 4;
    CHECK_NOTHROW(render(varying, any));
    CHECK(render.statistics.pixels_shaded > 0);
}
