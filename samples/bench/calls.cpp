// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "common/handles.hpp"
#include "egl_context.hpp"
#include "gl_counter.hpp"

namespace {

struct Case {
    const char* name;
    nicol_shade_at shade_at = NICOL_SHADE_AT_VERTICES;
    nicol_executor executor = NICOL_EXECUTOR_CPU;
    bool empty = false;  // no scene but its light
};

// The first frames of a moving camera bake and refine what former views did not show.
constexpr int kFrames = 6;

constexpr Case kCases[] = {
    {.name = "light alone", .empty = true},
    {.name = "vertices, threads"},
    {.name = "pixels, threads", .shade_at = NICOL_SHADE_AT_PIXELS},
    {.name = "vertices, compute", .executor = NICOL_EXECUTOR_COMPUTE},
    {.name = "pixels, compute", .shade_at = NICOL_SHADE_AT_PIXELS, .executor = NICOL_EXECUTOR_COMPUTE},
};

Context make_host_context(EglContext& egl, std::uint32_t flags, const Options& options) {
    auto host = nicol::defaults(nicol_host_init);
    host.flags = flags;
    host.user = &egl;
    host.get_proc_address = [](void* user, const char* name) {
        return counted_gl(name, static_cast<EglContext*>(user)->function(name));
    };
    host.is_current = [](void* user) { return std::int32_t{static_cast<EglContext*>(user)->is_current()}; };
    auto wanted = nicol::defaults(nicol_context_options_init);
    wanted.cache_folder = options.cache.c_str();
    return create<Context>(nicol_context_create_host, &host, &wanted);
}

// Returns the calls of a render after the camera moved, once everything else is there.
GlCalls calls_of_frame(nicol_context context, const Case& use, const Options& options) {
    const Scene scene = use.empty ? create<Scene>(nicol_scene_create, context)
                                  : create<Scene>(nicol_scene_load, context,
                                                  options.scene.empty() ? NICOL_BENCH_ASSETS "/snail_hdr.xml"
                                                                        : options.scene.c_str(),
                                                  nullptr, 0U);
    auto camera = nicol::defaults(nicol_camera_init);
    if (use.empty) {
        const auto light = create<Environment>(nicol_environment_create_constant, context, nullptr);
        check(nicol_scene_set_environment(scene.get(), light.get(), nullptr, 1));
    } else {
        check(nicol_scene_get_camera(scene.get(), &camera));
    }
    std::uint32_t channels = 0;
    check(nicol_scene_get_channels(scene.get(), &channels));
    const std::uint32_t size = options.size == 0 ? 128 : options.size;
    const auto framebuffer = create<Framebuffer>(nicol_framebuffer_create, context, size, size, channels);
    auto render = nicol::defaults(nicol_render_options_init);
    render.shade_at = use.shade_at;
    render.executor = use.executor;
    for (int frame = 0; frame < kFrames; ++frame) {
        camera.shift[0] += 0.01;
        reset_gl_calls();
        check(nicol_render(scene.get(), &camera, &render, framebuffer.get()));
    }
    return gl_calls();
}

}  // namespace

Report bench_calls(const Options& options) {
    Report report({"one frame after the camera moved", "calls", "queries", "glGetError",
                   "calls, host sets its state", "queries", "glGetError"});
    for (const Case& use : kCases) {
        std::vector<double> numbers;
        for (const std::uint32_t flags : {0U, NICOL_HOST_SETS_STATE}) {
            EglContext egl;
            const Context context = make_host_context(egl, flags, options);
            const GlCalls calls = calls_of_frame(context.get(), use, options);
            for (const std::uint64_t number : {calls.all, calls.queries, calls.errors})
                numbers.push_back(static_cast<double>(number));
        }
        report.add(use.name, numbers);
    }
    report.note(
        "OpenGL calls of nicol_render inside a host's context, counted in the functions that the host gives. "
        "Queries are glGet... and glIs...");
    return report;
}
