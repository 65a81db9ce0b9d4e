// SPDX-License-Identifier: MIT
// Tests of contexts inside an application's context: when they work, when they refuse to, and how they end.
#include <optional>
#include <thread>

#include "host/egl_host.hpp"
#include "host/gl_state.hpp"

using namespace host_test;

namespace {

nicol_result try_render(const Stage& stage) {
    nicol_render_options options = plain_options();
    options.disabled_optimisations = NICOL_OPTIMISATION_UNCHANGED;
    options.progress = [](void* called, const char*, double) {
        *static_cast<bool*>(called) = true;
        return std::int32_t{1};
    };
    bool begun = false;
    options.progress_user = &begun;
    const nicol_result result = stage.try_render(options);
    CHECK(begun == (result == NICOL_OK));
    return result;
}

}  // namespace

HOST_TEST_CASE("a host's context says what it is") {
    const Application application;
    const Owned context(make_host_context());
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    OK(nicol_context_get_info(context, &info));
    CHECK(info.backend == NICOL_BACKEND_HOST);
    CHECK(info.threads == 2);
    CHECK(std::string(info.version) == reinterpret_cast<const char*>(application.gl.GetString(GL_VERSION)));
    CHECK(std::string(info.renderer) == reinterpret_cast<const char*>(application.gl.GetString(GL_RENDERER)));
}

HOST_TEST_CASE("a wrong host is refused by name") {
    nicol_context context = marker<nicol_context>();
    nicol_host access = host();
    FAILS(nicol_context_create_host(&access, nullptr, &context), NICOL_ERROR_NO_BACKEND, "current");
    access.is_current = [](void*) -> std::int32_t { return 0; };
    FAILS(nicol_context_create_host(&access, nullptr, &context), NICOL_ERROR_NOT_CURRENT, "not current");
    const Application application;
    FAILS(nicol_context_create_host(&access, nullptr, &context), NICOL_ERROR_NOT_CURRENT, "not current");
    using H = nicol_host;
    check_wrong(host(), [&](const H& given) { return nicol_context_create_host(&given, nullptr, &context); },
                {{"flags", [](H& h) { h.flags = 4; }},
                 {"get_proc_address", [](H& h) { h.get_proc_address = nullptr; }}});
    access = host();
    access.get_proc_address = [](void*, const char*) -> void* { return nullptr; };
    FAILS(nicol_context_create_host(&access, nullptr, &context), NICOL_ERROR_NO_BACKEND, "functions");
    access = host();
    using O = nicol_context_options;
    const O good = NICOL_CONTEXT_OPTIONS_INIT, of_host = two_threads(NICOL_BACKEND_HOST);
    check_wrong(
        good, [&](const O& given) { return nicol_context_create_host(&access, &given, &context); },
        {{"device", [](O& o) { o.device = 1; }}, {"backend", [](O& o) { o.backend = NICOL_BACKEND_HOST; }}});
    REFUSES(nicol_context_create(&of_host, &context), "nicol_context_create_host");
    CHECK(context == marker<nicol_context>());
}

HOST_TEST_CASE("a context of an older OpenGL is refused") {
    const Application application;
    nicol_host access = host();
    access.get_proc_address = [](void*, const char* name) -> void* {
        using GetString = const GLubyte* (*)(GLenum);
        const GetString older = [](GLenum what) {
            return reinterpret_cast<const GLubyte*>(
                what == GL_VERSION ? "4.4 (Core Profile) of another driver" : "another driver");
        };
        return std::string(name) == "glGetString" ? reinterpret_cast<void*>(older)
                                                  : proc_address(nullptr, name);
    };
    nicol_context context = marker<nicol_context>();
    FAILS(nicol_context_create_host(&access, nullptr, &context), NICOL_ERROR_NO_BACKEND, "4.5");
    CHECK(context == marker<nicol_context>());
}

HOST_TEST_CASE("calls refuse to work where the host's context is not current") {
    const Application application;
    const Owned context(make_host_context());
    const Stage stage(context);
    const std::vector<float> image = stage.image();
    nicol_framebuffer framebuffer = marker<nicol_framebuffer>();
    const auto refused = [&] {
        FAILS(try_render(stage), NICOL_ERROR_NOT_CURRENT, "not current");
        FAILS(nicol_framebuffer_create(context, 4, 4, 1, &framebuffer), NICOL_ERROR_NOT_CURRENT,
              "not current");
    };
    std::thread(refused).join();
    Application::leave();
    refused();
    {
        // Another context of the same driver, which has objects of the same names.
        const Application other;
        GLuint arrays[8] = {};
        other.gl.CreateVertexArrays(8, arrays);
        const GlState before = gl_state(other.gl);
        refused();
        CHECK(difference(before, gl_state(other.gl)) == "");
    }
    {
        const Application sharing(application.handle());
        refused();
    }
    CHECK(framebuffer == marker<nicol_framebuffer>());
    application.enter();
    OK(try_render(stage));
    CHECK(read_all(stage.framebuffer) == image);
}

HOST_TEST_CASE("the host's word that its context is not current counts") {
    const Application application;
    bool current = true;
    nicol_host access = host();
    access.is_current = [](void* user) -> std::int32_t { return *static_cast<bool*>(user) ? 1 : 0; };
    access.user = &current;
    const Owned context(make(nicol_context_create_host, &access, nullptr));
    nicol_framebuffer framebuffer = marker<nicol_framebuffer>();
    current = false;
    FAILS(nicol_framebuffer_create(context, 4, 4, 1, &framebuffer), NICOL_ERROR_NOT_CURRENT, "not current");
    current = true;
    OK(nicol_framebuffer_release(framebuffer_of(context, 4, 4, 1)));
}

HOST_TEST_CASE("the host's context may move to another thread, and Nicol with it") {
    const Application application;
    const Owned context(make_host_context());
    const Stage stage(context);
    const std::vector<float> image = stage.image();
    Application::leave();
    std::thread([&] {
        application.enter();
        CHECK(try_render(stage) == NICOL_OK);
        CHECK(read_all(stage.framebuffer) == image);
        Application::leave();
    }).join();
    application.enter();
}

HOST_TEST_CASE("objects dropped elsewhere go at the next call that finds the context") {
    const Application application;
    const GlState nothing = gl_names(application.gl);
    const nicol_context context = make_host_context();
    const GlState empty = gl_names(application.gl);
    const auto make_one = [&] { return framebuffer_of(context, 4, 4, 3); };
    const auto release_elsewhere = [](nicol_framebuffer framebuffer) {
        std::thread([=] { CHECK(nicol_framebuffer_release(framebuffer) == NICOL_OK); }).join();
    };
    const nicol_framebuffer first = make_one(), second = make_one();
    CHECK(difference(empty, gl_names(application.gl)) != "");
    release_elsewhere(first);
    CHECK(difference(empty, gl_names(application.gl)) != "");
    OK(nicol_framebuffer_release(second));
    OK(nicol_framebuffer_release(make_one()));
    CHECK(difference(empty, gl_names(application.gl)) == "");
    release_elsewhere(make_one());
    OK(nicol_context_release(context));
    CHECK(difference(nothing, gl_names(application.gl)) == "");
}

HOST_TEST_CASE("everything may be released after the host's context is gone") {
    nicol_context context = nullptr;
    std::optional<Stage> stage;
    {
        const Application application;
        context = make_host_context();
        stage.emplace(context);
        stage->render();
    }
    FAILS(try_render(*stage), NICOL_ERROR_NOT_CURRENT, "not current");
    const Application other;
    const GlState names = gl_names(other.gl);
    stage.reset();
    OK(nicol_context_release(context));
    CHECK(difference(names, gl_names(other.gl)) == "");
    CHECK(other.gl.GetError() == GL_NO_ERROR);
}

HOST_TEST_CASE("a host's context and one of our own render side by side") {
    const Owned own(make_context(NICOL_BACKEND_EGL));
    const Application application;
    const Owned context(make_host_context());
    const Stage ours(own), theirs(context);
    for (int round = 0; round < 3; ++round) {
        OK(try_render(ours));
        OK(try_render(theirs));
    }
    CHECK(read_all(ours.framebuffer) == read_all(theirs.framebuffer));
    FAILS(nicol_render(ours.scene, &ours.camera, nullptr, theirs.framebuffer), NICOL_ERROR_INVALID_HANDLE,
          "different contexts");
}
