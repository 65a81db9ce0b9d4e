// SPDX-License-Identifier: MIT
// Tests of the scene memory limit: predictions against the memory that renders then use.
#include "capi.hpp"

using namespace capi_test;

namespace {

nicol_context limited_context(nicol_backend backend, std::uint64_t limit) {
    nicol_context_options options = two_threads(backend);
    options.memory_limit = limit;
    return make(nicol_context_create, &options);
}

std::vector<nicol_render_options> many_options() {
    std::vector<nicol_render_options> all;
    for_all({NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE}, {0U, 1U, 4U, 7U, 10U},
            [&](nicol_method method, std::uint32_t order) {
                if (method == NICOL_METHOD_DENSE && order > 4) return;
                for_all({NICOL_HIGH_ORDERS_SPLIT, NICOL_HIGH_ORDERS_NONE}, {1U, 0U},
                        [&](nicol_high_orders high, std::uint32_t shadows) {
                            nicol_render_options options = plain_options();
                            options.refine_tolerance = 0;  // refinement may use any memory up to the limit
                            options.method = method;
                            options.executor = NICOL_EXECUTOR_CPU;
                            options.order_low = order;
                            options.order_high = 12;
                            options.high_orders = high;
                            options.shadows = shadows;
                            options.bake_directions = 700;
                            // Channels of the sky are multiples of each other, which predictions do not know.
                            options.disabled_optimisations =
                                order == 1 ? NICOL_OPTIMISATION_ALL : NICOL_OPTIMISATION_CHANNELS;
                            all.push_back(options);
                        });
            });
    return all;
}

// Returns a square from -1 to 1 in x and y, with so many cells per side that rounding to vertex blocks hardly
// matters.
nicol_mesh fine_square(nicol_context context) {
    constexpr std::uint32_t cells = 16;
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < (cells + 1) * (cells + 1); ++i) {
        const std::uint32_t row = i / (cells + 1), column = i % (cells + 1);
        const auto place = [](std::uint32_t k) { return 2 * static_cast<float>(k) / cells - 1; };
        positions.insert(positions.end(), {place(column), place(row), 0});
        if (row == cells || column == cells) continue;
        indices.insert(indices.end(), {i, i + 1, i + cells + 2, i, i + cells + 2, i + cells + 1});
    }
    const nicol_mesh_data data = mesh_over(positions, indices);
    return make(nicol_mesh_create, context, &data);
}

// Two squares that shadow each other under light of three different channels, so that nothing can be skipped.
struct Cleft {
    nicol_context context;
    Owned<nicol_environment> light;
    Owned<nicol_material> material;
    Owned<nicol_mesh> mesh{fine_square(context)};
    Owned<nicol_framebuffer> framebuffer;
    bool element = false;  ///< whether the camera looks through a polarization element

    explicit Cleft(nicol_context owner, std::uint32_t side = 8)
        : context(owner), framebuffer(framebuffer_of(owner, side, side, 3)) {
        nicol_sky sky = NICOL_SKY_INIT;
        sky.radiance = spectrum({1, 2, 3});
        OK(nicol_environment_create_sky(context, &sky, &light));
        nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        plastic.diffuse_reflectance = spectrum({0.2F, 0.4F, 0.6F});
        OK(nicol_material_create_pplastic(context, &plastic, &material));
    }
    /// Renders a new scene each time, so that nothing remains from other options.
    [[nodiscard]] nicol_result render(const nicol_render_options& options) const {
        const Owned scene(simple_scene(context, light, mesh, material));
        add(scene, mesh, material, {{1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0.05, 0, 0, 0, 1}});
        const nicol_polarization_element polarizer = NICOL_POLARIZATION_ELEMENT_INIT;
        if (element) OK(nicol_scene_add_polarization_element(scene, &polarizer, nullptr));
        const nicol_camera camera = front_camera(9);
        return nicol_render(scene, &camera, &options, framebuffer);
    }
};

// Returns the number of bytes that the last message says are needed.
std::uint64_t bytes_in_message() {
    const std::string message = nicol_last_error(), before = "need up to ";
    const std::size_t at = message.find(before);
    REQUIRE(at != std::string::npos);
    CHECK(message.find("memory_limit is 1000") != std::string::npos);
    return std::stoull(message.substr(at + before.size()));
}

std::uint64_t bytes_needed(const Stage& stage, const nicol_render_options& options) {
    REQUIRE(stage.try_render(options) == NICOL_ERROR_OUT_OF_MEMORY);
    return bytes_in_message();
}

}  // namespace

TEST_CASE("predictions are never too low, and not far too high") {
    for (const nicol_backend backend : every_backend()) {
        const Owned small(limited_context(backend, 1000)), free(limited_context(backend, NICOL_NO_LIMIT));
        {
            const Cleft refused(small), rendered(free);
            for (const nicol_render_options& options : many_options()) {
                CAPTURES(options.method, options.order_low, options.high_orders, options.shadows);
                REQUIRE(refused.render(options) == NICOL_ERROR_OUT_OF_MEMORY);
                const std::uint64_t needed = bytes_in_message();
                OK(rendered.render(options));
                const nicol_statistics statistics = statistics_of(rendered.framebuffer);
                const std::uint64_t taken =
                    statistics.visibility_bytes + statistics.transfer_bytes + statistics.buffer_bytes;
                CHECK(needed >= taken);
                CHECK(static_cast<double>(needed) < 1.9 * static_cast<double>(taken));
            }
        }
    }
}

TEST_CASE("what samples, AOVs, elements and shading at pixels take of an image is in the prediction") {
    constexpr std::uint32_t side = 256;
    constexpr std::uint64_t own = std::uint64_t{side} * side * (3 * 16 + 4);
    for (const nicol_backend backend : every_backend()) {
        const Owned small(limited_context(backend, 1000)), free(limited_context(backend, NICOL_NO_LIMIT));
        Cleft refused(small, side), rendered(free, side);
        nicol_render_options options = plain_options();
        options.refine_tolerance = 0;
        options.executor = NICOL_EXECUTOR_CPU;
        options.order_low = options.order_high = 1;
        options.shadows = 0;
        options.shade_at = NICOL_SHADE_AT_VERTICES;
        OK(rendered.render(options));
        // Memory of the background light's image, which is drawn only for shading at vertices. Pictures are
        // drawn into a spare as large as the framebuffer.
        const std::uint64_t light = statistics_of(rendered.framebuffer).texture_bytes - 2 * own;
        for_all({false, true}, {NICOL_SHADE_AT_PIXELS, NICOL_SHADE_AT_VERTICES}, {8U, 1U, 4U},
                [&](bool element, nicol_shade_at where, std::uint32_t samples) {
                    refused.element = rendered.element = element;
                    for (const std::uint32_t aovs : {0U, NICOL_AOV_INSTANCE, NICOL_AOV_ALL}) {
                        CAPTURES(backend, element, where, samples, aovs);
                        options.shade_at = where;
                        options.pixel_samples = samples;
                        options.aovs = aovs;
                        REQUIRE(refused.render(options) == NICOL_ERROR_OUT_OF_MEMORY);
                        const std::uint64_t needed = bytes_in_message();
                        OK(rendered.render(options));
                        const nicol_statistics statistics = statistics_of(rendered.framebuffer);
                        const std::uint64_t taken = statistics.visibility_bytes + statistics.transfer_bytes +
                                                    statistics.buffer_bytes + statistics.texture_bytes - own -
                                                    (where == NICOL_SHADE_AT_VERTICES ? light : 0);
                        CHECK(needed >= taken);
                        CHECK(static_cast<double>(needed) < 1.3 * static_cast<double>(taken));
                    }
                });
    }
}

TEST_CASE("a limit refuses what exceeds it and nothing else") {
    for (const nicol_backend backend : every_backend()) {
        std::uint64_t needed = 0;
        nicol_render_options options = plain_options();
        {
            const Owned context(limited_context(backend, 1000));
            {
                const Stage stage(context);
                needed = bytes_needed(stage, options);
                REQUIRE(needed > 1000);
                // The refusal leaves the framebuffer untouched and happens again.
                CHECK(bytes_needed(stage, options) == needed);
                CHECK(largest(read_all(stage.framebuffer)) == 0);
                options.method = NICOL_METHOD_REFERENCE;
                options.samples = 1;
                CHECK(bytes_needed(stage, options) > 1000);
                // A job fails with the same result.
                const Owned job(
                    make(nicol_render_async, stage.scene, &stage.camera, &options, stage.framebuffer));
                FAILS(nicol_job_wait(job, NICOL_WAIT_FOREVER), NICOL_ERROR_OUT_OF_MEMORY, "memory_limit");
            }
        }
        options = plain_options();
        for (const bool enough : {true, false}) {
            const Owned context(limited_context(backend, enough ? needed : needed - 1));
            {
                const Stage stage(context);
                const nicol_result result = stage.try_render(options);
                CHECK(result == (enough ? NICOL_OK : NICOL_ERROR_OUT_OF_MEMORY));
                if (enough) {
                    // A second cube needs additional memory.
                    add(stage.scene, stage.mesh, stage.material);
                    FAILS(stage.try_render(options), NICOL_ERROR_OUT_OF_MEMORY, std::to_string(needed));
                }
            }
        }
    }
}
