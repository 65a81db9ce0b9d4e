// SPDX-License-Identifier: MIT
// Comparison of an image by compute shaders with the image by threads.
#pragma once

#include <cstdint>
#include <memory>

#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "temporary_folder.hpp"

namespace nicol::test {

/// Renders with both executors and compares the images and the statistics that must agree.
struct BothExecutors {
    BothExecutors(const std::shared_ptr<gl::Context>& context, int channels, int width = 40, int height = 30)
        : threads(context),
          shaders(context),
          by_threads(context, width, height, channels),
          by_shaders(context, width, height, channels),
          slack(gl::tolerance_of(context)) {
        // The backends share results that take long to prepare.
        static const TemporaryFolder shared;
        threads.set_cache(shared.path(), {});
        shaders.set_cache(shared.path(), {});
    }

    /// texels: single pixels may differ, because they may fall on different sides of the edge of a texel or
    /// of a mipmap's level.
    void run(const Scene& scene, RenderOptions options, const Camera& camera = some_camera(),
             bool texels = false) {
        options.bake_directions = 256;
        options.light_samples = 4;
        options.refine_tolerance = 0.1;
        // Threads find what samples show by rays, and refine less than shaders, which draw it.
        options.disabled_optimisations |= skip_rays;
        options.executor = Executor::cpu;
        threads.render(scene, camera, options, by_threads);
        options.executor = Executor::compute;
        shaders.render(scene, camera, options, by_shaders);
        const Statistics& expected = by_threads.statistics();
        const Statistics& actual = by_shaders.statistics();
        CHECK_FALSE(expected.compute);
        CHECK(actual.compute);
        CHECK(actual.pixels_shaded == expected.pixels_shaded);
        CHECK(actual.local_lights == expected.local_lights);
        CHECK((actual.light_ms > 0) == (expected.light_ms > 0));
        check_alike(by_threads.image(), by_shaders.image(), actual.pixels_shaded > 0, texels, slack);
    }
    [[nodiscard]] std::uint64_t rays() { return by_shaders.statistics().light_rays; }

    static void check_alike(const StokesImage& a, const StokesImage& b, bool at_pixels = false,
                            bool texels = false, double slack = 1) {
        CHECK(largest(a) > 0.1);
        if (texels) {
            CHECK(differing_pixels(a, b, slack * 1e-4 * largest(a)) <= a.width * a.height / 500);
            CHECK(largest_difference(a, b) <= 0.05 * largest(a));
            return;
        }
        CHECK(rms_difference(a, b) <= slack * 3e-6 * rms(a));
        // At grazing angles rounding moves the point that a pixel shows.
        CHECK(largest_difference(a, b) <= slack * (at_pixels ? 1e-4 : 1e-5) * largest(a));
    }

    Renderer threads;  // one per executor, because a renderer drops the other executor's results
    Renderer shaders;
    Framebuffer by_threads;
    Framebuffer by_shaders;
    double slack;
};

}  // namespace nicol::test
