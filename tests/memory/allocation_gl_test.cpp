// SPDX-License-Identifier: MIT
// Tests of renders that run out of memory at any allocation: they report it, and the next render works.
#include <thread>

#include "capi/capi.hpp"
#include "memory/sweep.hpp"

using namespace capi_test;
using namespace memory_test;

namespace {

constexpr std::uint32_t size = 8;

struct Variant {
    const char* name;
    nicol_method method;
    nicol_executor executor;
    nicol_shade_at at;
};

constexpr Variant variants[] = {
    {"factored", NICOL_METHOD_FACTORED, NICOL_EXECUTOR_CPU, NICOL_SHADE_AT_VERTICES},
    {"compute, pixels", NICOL_METHOD_FACTORED, NICOL_EXECUTOR_COMPUTE, NICOL_SHADE_AT_PIXELS},
    {"dense", NICOL_METHOD_DENSE, NICOL_EXECUTOR_CPU, NICOL_SHADE_AT_VERTICES},
    {"reference", NICOL_METHOD_REFERENCE, NICOL_EXECUTOR_AUTOMATIC, NICOL_SHADE_AT_AUTOMATIC}};

/// A tent of two triangles that shadow each other under a sky.
struct Tent {
    Owned<nicol_environment> environment;
    Owned<nicol_material> material;
    Owned<nicol_mesh> mesh;

    explicit Tent(nicol_context context)
        : environment(clear_sky(context)), material(diffuse(context, {0.5F})) {
        const float positions[] = {-1, 1, -1, 0, -1, 0, 0, 1, 0, 1, 1, -1, 0, -1, 0.5F, 0, 1, 0.5F};
        const std::uint32_t indices[] = {0, 1, 2, 3, 5, 4};
        nicol_mesh_data data = NICOL_MESH_DATA_INIT;
        data.vertex_count = 6;
        data.triangle_count = 2;
        data.positions = positions;
        data.indices = indices;
        OK(nicol_mesh_create(context, &data, &mesh));
    }
};

nicol_result render(nicol_scene scene, const Variant& variant, nicol_framebuffer framebuffer,
                    double distance = 3) {
    const nicol_camera camera = front_camera(distance);
    nicol_render_options options = plain_options();
    options.method = variant.method;
    options.executor = variant.executor;
    options.shade_at = variant.at;
    options.order_low = 2;
    options.order_high = variant.method == NICOL_METHOD_DENSE ? 2 : 4;
    options.bake_directions = 256;
    options.samples = 4;
    return nicol_render(scene, &camera, &options, framebuffer);
}

/// Renders the tent first without a Shortage, then with one at about thirty of the allocations.
void render_in_shortages(nicol_context context, const Tent& tent, const Variant& variant, Reach reach) {
    std::vector<float> expected;
    std::int64_t allocations = 0, failed = 0;
    std::int64_t step = 1;
    for (std::int64_t position = -1; position < allocations || position < 0; position += step) {
        CAPTURE(position);
        const Owned scene(simple_scene(context, tent.environment, tent.mesh, tent.material));
        const Owned framebuffer(framebuffer_of(context, size, size, 3));
        if (position < 0) {
            {
                const Shortage none(reach);
                OK(render(scene, variant, framebuffer));
                allocations = none.count();
            }
            expected = read_all(framebuffer);
            step = std::max<std::int64_t>(1, allocations / 30) | 1;
            MESSAGE(std::string(variant.name), ": ", allocations, " allocations, every ", step);
        } else {
            // A new thread has yet to make the memory that threads keep.
            nicol_result result = NICOL_OK, repeated = NICOL_OK;
            std::string message;
            std::thread([&] {
                {
                    const Shortage shortage(position, position / step % 2 == 1, reach);
                    result = render(scene, variant, framebuffer);
                }
                if (result == NICOL_OK) return;
                message = nicol_last_error();
                repeated = render(scene, variant, framebuffer);
            }).join();
            // A call may succeed despite the shortage, for example if a container falls back to a smaller
            // buffer.
            if (result != NICOL_OK) {
                ++failed;
                CHECK(result == NICOL_ERROR_OUT_OF_MEMORY);
                CHECK(message.find("memory") != std::string::npos);
                REQUIRE(repeated == NICOL_OK);
            }
            REQUIRE(read_all(framebuffer) == expected);
        }
    }
    CHECK(failed > allocations / step / 2);
}

}  // namespace

TEST_CASE("a render that lacks memory says so and harms nothing") {
    nicol_context_options context_options = NICOL_CONTEXT_OPTIONS_INIT;
    context_options.threads = 1;
    const Owned context(make(nicol_context_create, &context_options));
    const Tent tent(context);
    for (const Variant& variant : variants) {
        for (const Reach reach : {Reach::library, Reach::thread}) {
            CAPTURE(std::string(variant.name));
            CAPTURE(reach == Reach::thread);
            render_in_shortages(context, tent, variant, reach);
        }
    }
}

// A context notes what OpenGL has. Notes outlive a frame, so that one that is wrong shows in others.
TEST_CASE("a frame that lacks memory harms no other frame of its scene") {
    nicol_context_options context_options = NICOL_CONTEXT_OPTIONS_INIT;
    context_options.threads = 1;
    const Owned context(make(nicol_context_create, &context_options));
    const Tent tent(context);
    constexpr double distances[] = {3, 4};
    for (const Variant& variant : variants) {
        CAPTURE(std::string(variant.name));
        const Owned scene(simple_scene(context, tent.environment, tent.mesh, tent.material));
        const Owned framebuffer(framebuffer_of(context, size, size, 3));
        sweep_frames([&](std::size_t k) { return render(scene, variant, framebuffer, distances[k]); },
                     [&] { return read_all(framebuffer); }, [] {});
    }
}
