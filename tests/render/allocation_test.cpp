// SPDX-License-Identifier: MIT
// Tests of low-order frames in which only the camera or the light moves: they allocate no memory that grows
// with the scene.
#include <atomic>
#include <new>

#include "devices/cpu/cpu_executor.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

namespace {

std::atomic<bool> counting = false;
std::atomic<std::size_t> allocations = 0;

void* allocate(std::size_t size, std::size_t alignment) {
    if (counting) ++allocations;
    void* memory = alignment <= alignof(std::max_align_t)
                       ? std::malloc(size)
                       : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return allocate(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

using namespace nicol;

namespace {

struct Frames {
    Scene scene;
    Workers workers{{.threads = 1}};
    Pipeline pipeline;
    CpuExecutor executor;
    std::function<bool(const char*, double)> nobody;
    Progress progress{nobody};
    RenderOptions options;

    explicit Frames(int cells) {
        scene.add({.mesh = test::coarse_sphere(cells),
                   .material = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.3})});
        scene.add({.mesh = test::rectangle(2 * cells),
                   .material = diffuse({0.5}),
                   .to_world = test::plate_at(-1.2, 3)});
        scene.set_environment(test::falling_light(9, true, 3), glm::dmat3(1), 1);
        options.high_orders = HighOrders::none;
        options.bake_directions = 256;
        options.disabled_optimisations = skip_rays;  // the first frame bakes all vertices
    }

    std::size_t frame(double camera, double light) {
        scene.set_environment(scene.environment(),
                              glm::dmat3(glm::rotate(glm::dmat4(1), light, glm::dvec3(0, 1, 0))), 1);
        const Projection projection =
            project(test::camera_at({6 * std::sin(camera), 4, 6 * std::cos(camera)}), 64, 48);
        Statistics statistics;
        RenderRun run{.workers = workers, .progress = progress, .statistics = statistics};
        allocations = 0;
        counting = true;
        pipeline.bake(scene, {&projection, 1}, {}, options, run);
        pipeline.run(scene, projection, options, executor, run, {}, false);
        counting = false;
        return allocations;
    }
};

}  // namespace

TEST_CASE("frames allocate little, however many vertices there are") {
    std::size_t camera = 0;
    std::size_t light = 0;
    for (const int cells : {6, 24}) {
        Frames frames(cells);
        frames.frame(0, 0);
        frames.frame(0.3, 0.1);
        frames.frame(0.1, 0.1);
        const std::size_t still = frames.frame(0.1, 0.1);
        const std::size_t moved = frames.frame(0.3, 0.1);
        const std::size_t lit = frames.frame(0.3, 0.4);
        const std::size_t shown = frames.frame(1.3, 0.4);  // vertices that no image has shown
        CHECK(moved <= 64);
        CHECK(lit <= 512);
        CHECK(shown <= 512);
        if (cells == 24) {
            CHECK(still <= camera);
            CHECK(moved <= camera);
            CHECK(lit <= light);
        }
        camera = moved;
        light = lit;
    }
}
