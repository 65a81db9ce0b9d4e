// SPDX-License-Identifier: MIT
// An application with its own OpenGL contexts, by EGL without a surface. The library cannot tell the
// difference.
#pragma once

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <glad/gl.h>

#include "capi/capi.hpp"

namespace host_test {

using namespace capi_test;

struct Egl {
    void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
#define EGL_FUNCTION(member, name) \
    decltype(&name) member = reinterpret_cast<decltype(&name)>(dlsym(library, #name))
    EGL_FUNCTION(proc_address, eglGetProcAddress);
    EGL_FUNCTION(initialize, eglInitialize);
    EGL_FUNCTION(bind_api, eglBindAPI);
    EGL_FUNCTION(create_context, eglCreateContext);
    EGL_FUNCTION(destroy_context, eglDestroyContext);
    EGL_FUNCTION(make_current, eglMakeCurrent);
    EGL_FUNCTION(current_context, eglGetCurrentContext);
#undef EGL_FUNCTION
    EGLDisplay display = EGL_NO_DISPLAY;

    Egl() {
        REQUIRE(library != nullptr);
        const auto get =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(proc_address("eglGetPlatformDisplayEXT"));
        display = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        REQUIRE(initialize(display, nullptr, nullptr) == EGL_TRUE);
    }
};

inline Egl& egl() {
    static Egl instance;
    return instance;
}

enum class Profile { core, compatibility };
/// Profile of the contexts that the running test case makes.
inline Profile profile_under_test = Profile::core;

/// Calls test() once per profile.
inline void on_every_profile(void (*test)()) {
    for (const Profile profile : {Profile::core, Profile::compatibility}) {
        CAPTURE(static_cast<int>(profile));
        profile_under_test = profile;
        test();
    }
}

/// A test case that runs once per profile of the application.
#define HOST_TEST_CASE(title) HOST_TEST_CASE_NAMED(title, DOCTEST_ANONYMOUS(run_in_))
#define HOST_TEST_CASE_NAMED(title, run)  \
    static void run();                    \
    TEST_CASE(title) {                    \
        host_test::on_every_profile(run); \
    }                                     \
    static void run()

/// A context of the application, current on this thread from the start.
class Application {
public:
    explicit Application(EGLContext shared = EGL_NO_CONTEXT) {
        REQUIRE(egl().bind_api(EGL_OPENGL_API) == EGL_TRUE);
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     4,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     5,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     profile_under_test == Profile::core
                                         ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                         : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                     EGL_NONE};
        context_ = egl().create_context(egl().display, EGL_NO_CONFIG_KHR, shared, attributes);
        REQUIRE(context_ != EGL_NO_CONTEXT);
        enter();
        REQUIRE(gladLoadGLContextUserPtr(
                    &gl,
                    [](void*, const char* name) {
                        return reinterpret_cast<GLADapiproc>(egl().proc_address(name));
                    },
                    nullptr) != 0);
    }
    ~Application() {
        if (egl().current_context() == context_) leave();
        egl().destroy_context(egl().display, context_);
    }
    Application(const Application&) = delete;
    Application& operator=(const Application&) = delete;

    void enter() const {
        egl().bind_api(EGL_OPENGL_API);
        REQUIRE(egl().make_current(egl().display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE);
    }
    static void leave() {
        REQUIRE(egl().make_current(egl().display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT) ==
                EGL_TRUE);
    }
    [[nodiscard]] EGLContext handle() const { return context_; }

    GladGLContext gl{};

private:
    EGLContext context_ = EGL_NO_CONTEXT;
};

inline void* proc_address(void*, const char* name) {
    return reinterpret_cast<void*>(egl().proc_address(name));
}

inline nicol_host host() {
    nicol_host access = NICOL_HOST_INIT;
    access.get_proc_address = proc_address;
    return access;
}

/// Returns a context of the library inside the current one.
inline nicol_context make_host_context() {
    const nicol_host access = host();
    const nicol_context_options options = two_threads(NICOL_BACKEND_AUTOMATIC);
    return make(nicol_context_create_host, &access, &options);
}

}  // namespace host_test
