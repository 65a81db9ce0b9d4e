// SPDX-License-Identifier: MIT
#include "egl_context.hpp"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include "common/failure.hpp"

// EGL's functions, and its display without a surface, which stay until the program ends.
struct EglContext::Egl {
    void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
// NOLINTNEXTLINE(bugprone-macro-parentheses): these are names
#define EGL_FUNCTION(member, name) decltype(&name) member = find<decltype(&name)>(#name)
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
        const auto get =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(proc_address("eglGetPlatformDisplayEXT"));
        if (get != nullptr) display = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display == EGL_NO_DISPLAY || initialize(display, nullptr, nullptr) != EGL_TRUE)
            throw Failure("EGL has no platform without a surface");
    }

    template <class Function>
    Function find(const char* name) const {
        void* const found = library != nullptr ? dlsym(library, name) : nullptr;
        if (found == nullptr) throw Failure(std::string("EGL is not there: no ") + name);
        return reinterpret_cast<Function>(found);
    }

    static const Egl& instance() {
        static const Egl one;
        return one;
    }
};

EglContext::EglContext() : egl_(Egl::instance()) {
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
    egl_.bind_api(EGL_OPENGL_API);
    context_ = egl_.create_context(egl_.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (context_ == EGL_NO_CONTEXT ||
        egl_.make_current(egl_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
        throw Failure("EGL makes no context of OpenGL 4.5");
}

EglContext::~EglContext() {
    egl_.make_current(egl_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(egl_.display, context_);
}

void* EglContext::function(const char* name) const {
    return reinterpret_cast<void*>(egl_.proc_address(name));
}

bool EglContext::is_current() const {
    return egl_.current_context() == context_;
}
