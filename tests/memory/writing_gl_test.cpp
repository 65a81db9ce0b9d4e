// SPDX-License-Identifier: MIT
// Tests of writing files without enough memory: a file is complete or absent.
#include "memory/sweep.hpp"

using namespace capi_test;
using namespace memory_test;

TEST_CASE("a writer that lacks memory says so and leaves no part of a file") {
    const Owned context(make_context(NICOL_BACKEND_AUTOMATIC));
    const Owned scene(empty_scene(context));
    const Owned light(clear_sky(context));
    OK(nicol_scene_set_environment(scene, light, nullptr, 1));
    const Owned framebuffer(framebuffer_of(context, 8, 8, 3));
    const nicol_camera camera = front_camera();
    const nicol_render_options options = plain_options();
    OK(nicol_render(scene, &camera, &options, framebuffer));
    for (const bool png : {false, true}) {
        const TemporaryFolder folder;
        CAPTURE(png);
        const std::string path = folder.file(png ? "a.png" : "a.exr");
        const auto write = [&] {
            std::remove(path.c_str());
            const nicol_observation observation = NICOL_OBSERVATION_INIT;
            return png ? nicol_framebuffer_write_png(framebuffer, &observation, path.c_str())
                       : nicol_framebuffer_write_exr(framebuffer, path.c_str());
        };
        OK(write());
        const std::string whole = file_bytes(path);
        const std::int64_t failed = sweep(300, write, [&](nicol_result result) {
            CHECK(std::filesystem::exists(path) == (result == NICOL_OK));
            if (result == NICOL_OK) CHECK(file_bytes(path) == whole);
            CHECK(folder.names().size() == (result == NICOL_OK ? 1 : 0));
        });
        CHECK(failed > 0);
    }
}
