// SPDX-License-Identifier: MIT
// Tests of the error callback: failures of calls, of jobs and on several threads.
#include <mutex>
#include <thread>

#include "capi.hpp"

using namespace capi_test;

namespace {

struct Failure {
    nicol_result code;
    std::string message;
    std::string function;
    std::thread::id thread;
};

class Failures {
public:
    static void callback(void* user, nicol_result code, const char* message, const char* function) {
        auto& failures = *static_cast<Failures*>(user);
        const std::lock_guard lock(failures.mutex_);
        failures.list_.push_back({code, message, function, std::this_thread::get_id()});
    }
    /// Removes and returns the failures since the last call.
    std::vector<Failure> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(list_, {});
    }

private:
    std::mutex mutex_;
    std::vector<Failure> list_;
};

nicol_context reporting_context(Failures& failures) {
    nicol_context_options options = two_threads(NICOL_BACKEND_OSMESA);
    options.error = Failures::callback;
    options.error_user = &failures;
    return make(nicol_context_create, &options);
}

}  // namespace

TEST_CASE("each failure reaches the callback of its context, with its own message") {
    Failures failures, others;
    const Owned context(reporting_context(failures)), other(reporting_context(others));
    const Owned scene(empty_scene(context)), foreign(empty_scene(other));
    const Owned framebuffer(framebuffer_of(context, 4, 4, 1));
    const nicol_camera camera = front_camera();
    nicol_mesh mesh = nullptr;
    CHECK(nicol_mesh_load(context, "none.obj", &mesh) == NICOL_ERROR_FILE_NOT_FOUND);
    CHECK(nicol_render(foreign, &camera, nullptr, framebuffer) == NICOL_ERROR_INVALID_HANDLE);
    CHECK(nicol_scene_remove_instance(scene, 7) == NICOL_ERROR_INVALID_ARGUMENT);
    CHECK(nicol_context_retain(nullptr) == NICOL_ERROR_INVALID_HANDLE);  // concerns no context
    OK(nicol_render(scene, &camera, nullptr, framebuffer));
    const std::vector<Failure> found = failures.take(), of_other = others.take();
    REQUIRE(found.size() == 2);
    CHECK(found[0].code == NICOL_ERROR_FILE_NOT_FOUND);
    CHECK(found[0].message.find("none.obj") != std::string::npos);
    CHECK(found[0].function == "nicol_mesh_load");
    CHECK(found[0].thread == std::this_thread::get_id());
    CHECK(found[1].function == "nicol_scene_remove_instance");
    REQUIRE(of_other.size() == 1);
    CHECK(of_other[0].function == "nicol_render");

    // Functions that share code have names of their own.
    nicol_spectrum many = NICOL_SPECTRUM_INIT;
    many.count = 99;
    nicol_material material = nullptr;
    CHECK(nicol_material_create_diffuse(context, &many, &material) != NICOL_OK);
    const Owned grey(make(nicol_material_create_diffuse, context, nullptr));
    CHECK(nicol_material_create_scaled(context, grey, nullptr, &material) != NICOL_OK);
    const std::vector<Failure> shared = failures.take();
    REQUIRE(shared.size() == 2);
    CHECK(shared[0].function == "nicol_material_create_diffuse");
    CHECK(shared[1].function == "nicol_material_create_scaled");

    // Threads fail at once: every message belongs to its own call.
    const auto fail_often = [&](const std::string& name) {
        for (int i = 0; i < 100; ++i) {
            nicol_mesh none = nullptr;
            CHECK(nicol_mesh_load(context, (name + std::to_string(i) + ".obj").c_str(), &none) != NICOL_OK);
        }
    };
    std::thread first(fail_often, "a"), second(fail_often, "b");
    first.join();
    second.join();
    std::set<std::string> messages;
    for (const Failure& failure : failures.take()) messages.insert(failure.message);
    CHECK(messages.size() == 200);
}

TEST_CASE("a job's failure reaches the callback from the job's thread, once") {
    Failures failures;
    const Owned context(reporting_context(failures));
    const Stage stage(context);
    nicol_render_options options = plain_options();
    options.progress = [](void*, const char*, double) { return std::int32_t{0}; };
    const Owned job(make(nicol_render_async, stage.scene, &stage.camera, &options, stage.framebuffer));
    CHECK(nicol_job_wait(job, NICOL_WAIT_FOREVER) == NICOL_ERROR_CANCELLED);
    const std::vector<Failure> found = failures.take();
    REQUIRE(found.size() == 1);
    CHECK(found[0].code == NICOL_ERROR_CANCELLED);
    CHECK(found[0].function == "nicol_render_async");
    CHECK(found[0].thread != std::this_thread::get_id());
}

TEST_CASE("an error callback that calls back gets an error, and is not called for that") {
    struct Caller {
        nicol_scene scene = nullptr;
        int calls = 0;
        nicol_result result = NICOL_OK;
    } caller;
    nicol_context_options options = two_threads(NICOL_BACKEND_OSMESA);
    options.error_user = &caller;
    options.error = [](void* user, nicol_result, const char*, const char*) {
        auto& called = *static_cast<Caller*>(user);
        ++called.calls;
        called.result = nicol_scene_hide_emitters(called.scene, 1);
    };
    const Owned context(make(nicol_context_create, &options));
    const Owned scene(empty_scene(context));
    caller.scene = scene;
    CHECK(nicol_scene_remove_instance(scene, 7) == NICOL_ERROR_INVALID_ARGUMENT);
    CHECK(caller.calls == 1);
    CHECK(caller.result == NICOL_ERROR_INVALID_ARGUMENT);
}
