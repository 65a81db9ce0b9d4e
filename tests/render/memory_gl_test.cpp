// SPDX-License-Identifier: MIT
// Tests that device memory is limited to what the present scene and image need.
#include "gl/contexts.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::falling_light;

namespace {

struct Use {
    std::uint64_t buffers, textures;
    bool operator==(const Use&) const = default;
};

Use use_of(const Statistics& statistics) {
    return {statistics.buffer_bytes, statistics.texture_bytes};
}

/// Both executors, at vertices and at pixels.
constexpr std::array<std::pair<Executor, ShadeAt>, 4> ways{
    std::pair{Executor::cpu, ShadeAt::vertices}, std::pair{Executor::cpu, ShadeAt::pixels},
    std::pair{Executor::compute, ShadeAt::vertices}, std::pair{Executor::compute, ShadeAt::pixels}};

RenderOptions by(const std::pair<Executor, ShadeAt>& way) {
    return {.executor = way.first,
            .bake_directions = 256,
            .order_low = 2,
            .order_high = 4,
            .shade_at = way.second};
}

}  // namespace

GL_TEST_CASE("changes of scene, light, camera and options give back what they no longer need") {
    const MaterialPtr bright = diffuse({0.9});
    const MaterialPtr grey = diffuse({0.5});
    const EnvironmentPtr polarized = falling_light(4, true, 3);
    const EnvironmentPtr plain = falling_light(4, false, 3);
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(4), .material = bright});
    scene.add({.mesh = test::coarse_sphere(3), .material = grey, .to_world = test::at(1, 1.4, 0.3)});
    Renderer renderer(context);
    Framebuffer target(context, 24, 16, 3);
    // After one round over all ways the memory use equals that of the last way, however often the ways
    // change.
    std::array<Use, ways.size()> first{};
    std::array<Use, ways.size()> last{};
    for (int round = 0; round < 3; ++round) {
        for (std::size_t w = 0; w < ways.size(); ++w) {
            CAPTURES(round, w);
            RenderOptions options = by(ways[w]);
            scene.set_environment(plain, glm::dmat3(1), 1 + round);
            renderer.render(scene, test::some_camera(), options, target);
            options.order_low = 1;
            options.shadows = false;
            renderer.render(scene, test::some_camera(), options, target);
            options.order_low = 2;
            options.shadows = true;
            scene.set_transform(1, test::at(1, 1.4, 0.1));
            scene.set_environment(polarized, glm::dmat3(1), 1 + round);
            renderer.render(scene, test::some_camera(), options, target);
            const Use use = use_of(target.statistics());
            CHECK(use.buffers > 0);
            if (round == 0) first[w] = use;
            if (round > 1) CHECK(use == last[w]);
            last[w] = use;
            // Small buffers of normals and fractions may remain from earlier ways, but no large ones.
            CHECK(use.buffers < 2 * first[w].buffers);
        }
    }
}

GL_TEST_CASE("an image of another size costs its own size alone") {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(4), .material = diffuse({0.5})});
    scene.set_environment(falling_light(4, true, 3), glm::dmat3(1), 1);
    Renderer renderer(context);
    for (const auto& way : ways) {
        std::unique_ptr<Framebuffer> target;
        const auto use_at = [&](int width, int height) {
            target.reset();
            target = std::make_unique<Framebuffer>(context, width, height, 3);
            renderer.render(scene, test::some_camera(), by(way), *target);
            return use_of(target->statistics());
        };
        const Use small = use_at(20, 10);
        const Use large = use_at(200, 100);
        // A target and the spare have three images of four floats and a depth each. Shading at pixels adds
        // hits with depth, as interpolation on threads in the place of a software driver does, and the device
        // another three images and coverage twice.
        constexpr std::uint64_t target_bytes = 2 * (3 * 16 + 4);
        const bool pixels = way.second == ShadeAt::pixels;
        const bool on_device = way.first == Executor::compute;
        const bool hits = pixels || (!on_device && context->info().software);
        const std::uint64_t pixel_bytes = (hits ? 4 + 4 : 0) + (pixels && on_device ? 4 + 3 * 16 + 4 : 0);
        if (!pixels) CHECK(large.buffers == small.buffers);
        CHECK(large.textures - small.textures == (200 * 100 - 20 * 10) * (target_bytes + pixel_bytes));
        for (int i = 0; i < 5; ++i) {
            CHECK(use_at(200, 100) == large);
            CHECK(use_at(20, 10) == small);
        }
    }
}

GL_TEST_CASE("nothing is left of a renderer") {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(3), .material = diffuse({0.5})});
    scene.set_environment(falling_light(4, true, 3), glm::dmat3(1), 1);
    const std::size_t before = gl::total_bytes(context->memory());
    {
        Renderer renderer(context);
        Framebuffer target(context, 24, 16, 3);
        for (const auto& way : ways) renderer.render(scene, test::some_camera(), by(way), target);
        CHECK(gl::total_bytes(context->memory()) > before);
    }
    CHECK(gl::total_bytes(context->memory()) == before);
}
