// SPDX-License-Identifier: MIT
// Tests of hits by rays against drawn hits.
#include <glm/gtc/matrix_transform.hpp>

#include "draw/drawn_hits.hpp"
#include "draw/traced_hits.hpp"
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"
#include "surfaces/rigid_motion.hpp"

using namespace nicol;
using test::at;
using test::Studio;

namespace {

constexpr int kWidth = 60, kHeight = 44;

/// Surfaces of a scene as drawn, without refinement.
struct Surfaces {
    explicit Surfaces(const Scene& scene) {
        given.update(scene);
        drawn.update(given, nullptr, {}, {});
    }
    SceneGeometry given;
    RefinedSurfaces drawn;
};

/// Returns the hits of both finders: drawn, traced.
std::array<VisibilityBuffer, 2> hits_of(const std::shared_ptr<gl::Context>& context, const Surfaces& surfaces,
                                        const Camera& camera, int samples) {
    std::array<VisibilityBuffer, 2> out{VisibilityBuffer(context), VisibilityBuffer(context)};
    VertexBuffers buffers(context);
    AlphaMasks masks(context);
    DrawnHits drawn(context, buffers, masks);
    Workers workers{{.threads = 2}};
    DrawnRays rays;
    TracedHits traced(workers, rays);
    const Projection projection = in_axes(project(camera, kWidth, kHeight), surfaces.drawn.to_world());
    const HitRequest request{.surfaces = surfaces.drawn,
                             .projection = projection,
                             .width = kWidth,
                             .height = kHeight,
                             .offsets = sample_pattern(samples),
                             .kept = VisibilityBuffer::Kept::on_host};
    context->run([&] {
        const WorldGeometry& geometry = surfaces.drawn.geometry();
        buffers.update(geometry, surfaces.drawn.version(), 1);
        masks.update(geometry, surfaces.drawn.version(), surfaces.drawn.material_version(), buffers);
        drawn.find(request, out[0]);
        traced.find(request, out[1]);
    });
    return out;
}

/// Returns whether the triangles of two hits have a corner in common.
bool share(const Surfaces& surfaces, const Hit& a, const Hit& b) {
    const std::vector<glm::uvec3>& triangles = surfaces.drawn.geometry().triangles;
    for (glm::length_t i = 0; i < 3; ++i)
        for (glm::length_t k = 0; k < 3; ++k)
            if (triangles[a.triangle][i] == triangles[b.triangle][k]) return true;
    return false;
}

/// Returns a one-sided sphere before a two-sided wavy plate and a one-sided plate that is seen from behind.
Scene solids() {
    Mesh wavy = make_rectangle(40);
    for (glm::vec3& p : wavy.positions) p.z += 0.2F * std::sin(7 * p.x) * std::sin(5 * p.y);
    Scene scene;
    scene.add({.mesh = test::fine_sphere(), .material = diffuse({0.5}), .to_world = at(0.3, 0, 0, 0.6)});
    scene.add({.mesh = std::make_shared<const Mesh>(std::move(wavy)),
               .material = twosided(diffuse({0.5})),
               .to_world = test::plate_at(-0.5, 1.5)});
    scene.add({.mesh = test::rectangle(8),
               .material = diffuse({0.5}),
               .to_world = at(-0.8, 0.3, 0, 0.5) * glm::rotate(glm::dmat4(1), 3.0, glm::dvec3(0, 1, 0))});
    return scene;
}

/// Returns a plate with an opacity, over another.
Scene plate_with_opacity(bool translucent) {
    TextureImage image{.width = 16, .height = 16, .channels = 1};
    for (int i = 0; i < 256; ++i)
        image.values.push_back(0.1F + 0.8F * static_cast<float>(i * 37 % 256) / 255);
    Scene scene;
    scene.add({.mesh = test::with_texcoords(make_rectangle(16)),
               .material = masked(twosided(diffuse({0.5})), image_texture(std::move(image)), translucent),
               .to_world = test::plate_at(0.2, 1)});
    scene.add({.mesh = test::rectangle(16), .material = diffuse({0.5}), .to_world = test::plate_at(-0.4, 2)});
    return scene;
}

}  // namespace

IMAGE_TEST_CASE("rays find the hits that drawing finds, but where a sample is on an edge within rounding") {
    Camera inside = test::some_camera();
    inside.near_clip = 5;  // within the surfaces, so that both clipping planes cut them
    inside.far_clip = 6;
    inside.shift = {0.1, -0.07};
    inside.jitter = {0.2, -0.4};
    Camera parallel = test::some_camera();
    parallel.orthographic = true;
    parallel.near_clip = 5;
    parallel.far_clip = 5.8;
    const Camera below = test::camera_at({1, -3, 2});
    for (const Scene& scene : {solids(), plate_with_opacity(false), plate_with_opacity(true)}) {
        const Surfaces surfaces(scene);
        for (const Camera& camera : {test::some_camera(), inside, parallel, below})
            for (const int samples : {1, 8}) {
                const auto [drawn, traced] = hits_of(context, surfaces, camera, samples);
                int shown = 0, beside = 0, elsewhere = 0;
                for (std::size_t s = 0; s < static_cast<std::size_t>(samples); ++s)
                    for (std::size_t i = 0; i < kWidth * kHeight; ++i) {
                        const std::optional<Hit> a = drawn.at(s, i), b = traced.at(s, i);
                        shown += a ? 1 : 0;
                        if (VisibilityBuffer::texel(a) == VisibilityBuffer::texel(b)) continue;
                        const bool neighbours = a && b && a->front == b->front && share(surfaces, *a, *b);
                        (neighbours ? beside : elsewhere)++;
                    }
                CAPTURE(samples);
                CHECK(shown > samples * kWidth * kHeight / 50);
                // Rasterisation rounds corners to 1/256 of a pixel, which is much of the finest triangles.
                CHECK(beside <= 2 + shown / 50);
                CHECK(elsewhere <= 2 + shown / 1000);
            }
    }
}

IMAGE_TEST_CASE("pictures of many samples of triangles finer than pixels are traced, and equal drawn ones") {
    if (!context->info().software) return;  // a graphics processor draws
    Scene scene;
    scene.add({.mesh = test::fine_sphere(), .material = diffuse({0.5})});
    scene.set_environment(test::falling_light(4, true, 3), glm::dmat3(1), 1);
    RenderOptions options{.executor = Executor::cpu,
                          .bake_directions = 256,
                          .order_high = 4,
                          .shade_at = ShadeAt::pixels,
                          .pixel_samples = 16};
    Studio render(context, 12, 10);
    const StokesImage traced = render(scene, options);
    CHECK(render.statistics.camera_rays == 16 * 12 * 10);
    // One image of a sample is drawn, because a hierarchy would cost more than it.
    StokesImage drawn(12, 10, 3);
    options.pixel_samples = 1;
    Camera camera = test::some_camera();
    for (int s = 0; s < 16; ++s) {
        camera.jitter = sample_place(s, 16);
        const StokesImage image = render(scene, options, camera);
        CHECK(render.statistics.camera_rays == 0);
        for (std::size_t i = 0; i < drawn.data.size(); ++i) drawn.data[i] += image.data[i] / 16;
    }
    CHECK(test::rms_difference(traced, drawn) < 1e-4 * test::rms(drawn));
    options.pixel_samples = 16;
    Scene coarse;
    coarse.add({.mesh = test::coarse_sphere(4), .material = diffuse({0.5})});
    coarse.set_environment(test::falling_light(4, true, 3), glm::dmat3(1), 1);
    Studio another(context, 12, 10);
    static_cast<void>(another(coarse, options));
    CHECK(another.statistics.camera_rays == 0);
}

IMAGE_TEST_CASE("hits of a view are kept while light and materials change") {
    if (!context->info().software) return;  // a graphics processor draws, which nothing counts
    Scene scene;
    const std::uint32_t id = scene.add({.mesh = test::fine_sphere(), .material = diffuse({0.5})});
    // The scene's axes follow the largest object, so another one moves.
    const std::uint32_t small = scene.add(
        {.mesh = test::fine_sphere(), .material = diffuse({0.5}), .to_world = at(0.9, 0, 0.6, 0.3)});
    scene.set_environment(test::falling_light(4, true, 3), glm::dmat3(1), 1);
    RenderOptions options{.executor = Executor::cpu,
                          .bake_directions = 256,
                          .order_high = 4,
                          .shade_at = ShadeAt::pixels,
                          .pixel_samples = 8};
    Camera camera = test::some_camera();
    Studio render(context, 8, 6);
    StokesImage image;
    const auto count = [&] {
        image = render(scene, options, camera);
        return render.statistics.camera_rays;
    };
    constexpr std::uint64_t all = 8 * 8 * 6;
    CHECK(count() == all);
    scene.set_material(id, diffuse({0.3}));
    CHECK(count() == 0);
    scene.set_environment(test::falling_light(4, false, 3), glm::dmat3(1), 1);
    CHECK(count() == 0);
    const auto check_fresh = [&] {
        Studio fresh(context, 8, 6);
        // Vertices that the bake adds differ a little after a move.
        CHECK(test::rms_difference(image, fresh(scene, options, camera)) < 2e-3 * test::rms(image));
    };
    check_fresh();
    scene.set_transform(small, at(0.9, 0.2, 0.6, 0.3));
    CHECK(count() == all);
    scene.set_material(small, twosided(diffuse({0.5})));
    CHECK(count() == all);
    options.pixel_samples = 4;
    CHECK(count() == all / 2);
    check_fresh();
    options.pixel_samples = 8;
    camera.jitter = {0.25, 0};
    CHECK(count() == all);
    options.disabled_optimisations = skip_unchanged;
    scene.set_material(id, diffuse({0.4}));
    CHECK(count() == all);
}
