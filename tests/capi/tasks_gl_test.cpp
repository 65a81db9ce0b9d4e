// SPDX-License-Identifier: MIT
// Tests of a host's task system, which runs the parallel loops in place of the library's threads.
#include <sys/prctl.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "capi/capi.hpp"

using namespace capi_test;

namespace {

constexpr std::uint32_t width = 32, height = 24;
constexpr const char* thread_name = "tasks-test";

/// Returns the number of the process's threads that have the test's name. New threads inherit the name of the
/// thread that makes them, and OpenGL's name themselves.
int named_threads() {
    int count = 0;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream file(task.path() / "comm");
        std::string name;
        std::getline(file, name);
        count += name == thread_name ? 1 : 0;
    }
    return count;
}

/// Task system that counts.
struct Host {
    bool threads;  ///< whether tasks run on threads of their own, or at once on the caller's
    std::uint32_t wanted;
    std::atomic<int> runs{0};
    std::atomic<bool> other_count{false};

    using Team = std::vector<std::jthread>;

    static void* start(void* user, std::uint32_t count, nicol_task task, void* data) {
        Host& host = *static_cast<Host*>(user);
        ++host.runs;
        if (count != host.wanted - 1) host.other_count = true;
        auto* const team = new Team;
        for (std::uint32_t i = 0; i < count; ++i)
            if (host.threads)
                team->emplace_back([=] { task(data); });
            else
                task(data);
        return team;
    }
    static void finish(void* /*user*/, void* started) { delete static_cast<Team*>(started); }

    /// Returns options of a context that uses the task system.
    nicol_context_options options() {
        nicol_context_options made = two_threads(NICOL_BACKEND_EGL);
        made.threads = wanted;
        made.start_tasks = start;
        made.finish_tasks = finish;
        made.tasks_user = this;
        return made;
    }
};

/// Returns the picture of a scene with everything that has loops: an image as light, a bake, bounces and
/// lamps.
std::vector<float> picture(const nicol_context_options& options) {
    const nicol_context context = make(nicol_context_create, &options);
    const nicol_scene scene = make(nicol_scene_load, context, NICOL_TEST_ASSETS "/snail_hdr.xml",
                                   static_cast<const char* const*>(nullptr), 0U);
    const nicol_framebuffer framebuffer = framebuffer_of(context, width, height, 3);
    nicol_camera camera = NICOL_CAMERA_INIT;
    OK(nicol_scene_get_camera(scene, &camera));
    std::vector<float> out;
    for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_REFERENCE}) {
        nicol_render_options render = NICOL_RENDER_OPTIONS_INIT;
        render.method = method;
        render.bake_directions = 256;
        render.order_low = 2;
        render.order_high = 9;
        render.max_depth = 3;
        render.samples = 4;
        render.pixel_samples = 4;
        render.executor = NICOL_EXECUTOR_CPU;
        OK(nicol_render(scene, &camera, &render, framebuffer));
        std::vector<float> pixels(std::size_t{width} * height * 4);
        OK(nicol_framebuffer_read(framebuffer, NICOL_PLANE_STOKES, 1, pixels.data(), 0,
                                  pixels.size() * sizeof(float)));
        out.insert(out.end(), pixels.begin(), pixels.end());
    }
    OK(nicol_framebuffer_release(framebuffer));
    OK(nicol_scene_release(scene));
    OK(nicol_context_release(context));
    return out;
}

}  // namespace

TEST_CASE("a host's task system makes the same picture, and the library starts no workers") {
    ::prctl(PR_SET_NAME, thread_name);
    Host alone{.threads = true, .wanted = 1};
    std::vector<std::vector<float>> pictures{picture(alone.options())};
    const int before = named_threads();  // OpenGL's that outlive a context are among them
    CHECK(alone.runs == 0);
    for (const bool threads : {true, false}) {
        Host host{.threads = threads, .wanted = std::min(2U, std::thread::hardware_concurrency())};
        pictures.push_back(picture(host.options()));
        CAPTURE(threads);
        CHECK((host.wanted == 1 || host.runs >= 3));
        CHECK(!host.other_count);
        CHECK(named_threads() == before);
    }
    pictures.push_back(picture(two_threads(NICOL_BACKEND_EGL)));
    CHECK(named_threads() > before);  // so this counts the library's workers
    for (const std::vector<float>& other : pictures) CHECK(other == pictures.front());
}

TEST_CASE("a failure reaches the caller through a host's task system") {
    Host host{.threads = true, .wanted = 2};
    nicol_context_options options = host.options();
    nicol_context context = make(nicol_context_create, &options);
    nicol_scene scene = nullptr;
    CHECK(nicol_scene_load(context, "absent.xml", nullptr, 0, &scene) == NICOL_ERROR_FILE_NOT_FOUND);
    CHECK(std::string(nicol_last_error()).find("absent.xml") != std::string::npos);
    CHECK((host.runs == 1 || std::thread::hardware_concurrency() == 1));
    OK(nicol_context_release(context));
    options.finish_tasks = nullptr;
    CHECK(nicol_context_create(&options, &context) == NICOL_ERROR_INVALID_ARGUMENT);
    CHECK(std::string(nicol_last_error()).find("finish_tasks") != std::string::npos);
}
