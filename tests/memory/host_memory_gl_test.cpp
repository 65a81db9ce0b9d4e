// SPDX-License-Identifier: MIT
// Tests of renders in an application's context that run out of memory: its state comes back all the same.
#include "host/egl_host.hpp"
#include "host/gl_state.hpp"
#include "host/unusual_state.hpp"
#include "memory/failing_new.hpp"

using namespace host_test;
using namespace memory_test;

HOST_TEST_CASE("a frame that lacks memory gives the application its state back and harms no other frame") {
    const Application application;
    const GladGLContext& gl = application.gl;
    const Owned context(make_host_context());
    Stage stage(context);
    constexpr double shifts[] = {0, 0.1};
    nicol_render_options options = plain_options();
    options.shade_at = NICOL_SHADE_AT_PIXELS;
    for (const UnusualState& state : unusual_bindings()) state.set(gl, true);
    const GlState before = gl_state(gl);
    for (const nicol_executor executor : {NICOL_EXECUTOR_CPU, NICOL_EXECUTOR_COMPUTE}) {
        CAPTURE(static_cast<int>(executor));
        options.executor = executor;
        const auto image = [&](std::size_t k) {
            stage.camera.shift[0] = shifts[k];
            return stage.image(options);
        };
        std::vector<float> expected[2];
        std::int64_t allocations = 0, failed = 0;
        for (int round = 0; round < 2; ++round) {  // the second round has what frames share
            for (const std::size_t k : {0U, 1U}) {
                const Shortage none;
                expected[k] = image(k);
                allocations = none.count();
            }
        }
        REQUIRE(expected[0] != expected[1]);
        for (std::int64_t position = 0; position < allocations; ++position) {
            CAPTURE(position);
            const std::size_t k = position % 2 == 0 ? 0 : 1;
            stage.camera.shift[0] = shifts[k];
            {
                const Shortage shortage(position, false);
                if (stage.try_render(options) != NICOL_OK) ++failed;
            }
            REQUIRE(difference(before, gl_state(gl)) == "");
            for (const std::size_t other : {1 - k, k}) REQUIRE(image(other) == expected[other]);
        }
        CHECK(failed > allocations / 2);
    }
}
