// SPDX-License-Identifier: MIT
// EGL platform without a surface: on a device of EGL's list, or on Mesa's surfaceless platform.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <mutex>
#include <sstream>
#include <string_view>

#include "error.hpp"
#include "files/shared_library.hpp"
#include "forked.hpp"
#include "gl/egl_extensions.hpp"
#include "gl/platform.hpp"

namespace nicol::gl {
namespace {

struct Egl {
    SharedLibrary library{{"libEGL.so.1", "libEGL.so"}, ErrorCode::no_backend};
// NOLINTNEXTLINE(bugprone-macro-parentheses): these are names
#define NICOL_EGL(member, name) decltype(&name) member = library.function<decltype(&name)>(#name)
    NICOL_EGL(proc_address, eglGetProcAddress);
    NICOL_EGL(query_string, eglQueryString);
    NICOL_EGL(initialize, eglInitialize);
    NICOL_EGL(bind_api, eglBindAPI);
    NICOL_EGL(create_context, eglCreateContext);
    NICOL_EGL(destroy_context, eglDestroyContext);
    NICOL_EGL(make_current, eglMakeCurrent);
    NICOL_EGL(release_thread, eglReleaseThread);
    NICOL_EGL(get_error, eglGetError);
#undef NICOL_EGL

    template <class Function>
    Function extension(const char* name) const {
        return reinterpret_cast<Function>(proc_address(name));
    }
};

Egl& egl() {
    static Egl instance;
    return instance;
}

/// Releases EGL's per-thread memory, also if an attempt fails.
struct ThreadGuard {
    Egl& loaded = egl();
    ~ThreadGuard() { loaded.release_thread(); }
};

std::string error_text(const char* call) {
    std::ostringstream text;
    text << call << " failed with EGL error 0x" << std::hex << egl().get_error();
    return text.str();
}

/// Returns the folders in which libglvnd searches for drivers, for error messages.
std::string vendor_hint() {
    std::string text = "EGL knows no driver: its vendor list is empty or names libraries that do not load. ";
    const char* files = std::getenv("__EGL_VENDOR_LIBRARY_FILENAMES");
    const char* folders = std::getenv("__EGL_VENDOR_LIBRARY_DIRS");
    if (files != nullptr)
        text += std::string("The list is the environment variable __EGL_VENDOR_LIBRARY_FILENAMES=") + files;
    else if (folders != nullptr)
        text += std::string("The list is the environment variable __EGL_VENDOR_LIBRARY_DIRS=") + folders;
    else
        text += "The list is /etc/glvnd/egl_vendor.d and /usr/share/glvnd/egl_vendor.d";
    return text +
           "; it should hold 50_mesa.json (Mesa) or 10_nvidia.json (NVIDIA; containers often lack this file "
           "although the driver is there)";
}

std::vector<EGLDeviceEXT> query_devices() {
    const char* client = egl().query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has_extension(client, "EGL_EXT_device_enumeration") && !has_extension(client, "EGL_EXT_device_base"))
        return {};
    const auto query = egl().extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (query == nullptr || !query(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (!query(count, devices.data(), &count) || count < 0) return {};
    devices.resize(std::min(devices.size(), static_cast<std::size_t>(count)));
    return devices;
}

EGLDisplay get_display(const EglChoice& choice) {
    const auto get = egl().extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    const char* client = egl().query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has_extension(client, "EGL_EXT_platform_base") || get == nullptr)
        throw Error(ErrorCode::no_backend, "EGL lacks EGL_EXT_platform_base");
    EGLDisplay display = EGL_NO_DISPLAY;
    if (choice.device) {
        const std::vector<EGLDeviceEXT> devices = query_devices();
        const auto index = static_cast<std::size_t>(*choice.device);
        if (index >= devices.size())
            throw Error(ErrorCode::no_backend, "EGL's device list has shrunk to " +
                                                   std::to_string(devices.size()) + " since it was read");
        display = get(EGL_PLATFORM_DEVICE_EXT, devices[index], nullptr);
    } else {
        display = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    }
    if (display == EGL_NO_DISPLAY) throw Error(ErrorCode::no_backend, error_text("eglGetPlatformDisplayEXT"));
    return display;
}

class EglPlatform final : public Platform {
public:
    explicit EglPlatform(const EglChoice& choice) {
        const std::lock_guard lock(driver_mutex());
        display_ = get_display(choice);
        // The display may also be the host's. Initialising it again does no harm; it is never terminated.
        EGLint major = 0, minor = 0;
        if (!egl().initialize(display_, &major, &minor))
            throw Error(ErrorCode::no_backend, error_text("eglInitialize"));
        const char* extensions = egl().query_string(display_, EGL_EXTENSIONS);
        if (major == 1 && minor < 5 && !has_extension(extensions, "EGL_KHR_create_context"))
            throw Error(ErrorCode::no_backend, "the display lacks EGL 1.5 and EGL_KHR_create_context");
        for (const char* needed : {"EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"})
            if (!has_extension(extensions, needed))
                throw Error(ErrorCode::no_backend, std::string("the display lacks ") + needed);
        if (!egl().bind_api(EGL_OPENGL_API))
            throw Error(ErrorCode::no_backend, error_text("eglBindAPI(EGL_OPENGL_API)"));
        constexpr EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                         4,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         5,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_NONE};
        context_ = egl().create_context(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context_ == EGL_NO_CONTEXT)
            throw Error(ErrorCode::no_backend, error_text("eglCreateContext for OpenGL 4.5 core"));
        if (!egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            const std::string reason = error_text("eglMakeCurrent");
            egl().destroy_context(display_, context_);
            throw Error(ErrorCode::no_backend, reason);
        }
    }

    ~EglPlatform() override {
        const std::lock_guard lock(driver_mutex());
        egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl().destroy_context(display_, context_);
    }

    EglPlatform(const EglPlatform&) = delete;
    EglPlatform& operator=(const EglPlatform&) = delete;

    Function function(const char* name) const override { return egl().proc_address(name); }

private:
    ThreadGuard thread_;  // first member, so that it is destroyed last
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

EglChoices find_egl_choices() {
    const ThreadGuard thread;
    const std::lock_guard lock(driver_mutex());
    EglChoices found;
    std::vector<EglChoice> software;
    const std::vector<EGLDeviceEXT> devices = query_devices();
    found.devices = static_cast<int>(devices.size());
    if (devices.empty()) found.no_device = "EGL lists no device. " + vendor_hint();
    const auto query = egl().extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    for (int i = 0; i < found.devices; ++i) {
        EglChoice choice{i, "EGL device " + std::to_string(i)};
        EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
        const char* extensions = query != nullptr ? query(device, EGL_EXTENSIONS) : nullptr;
        if (has_extension(extensions, "EGL_MESA_device_software")) {
            choice.name += " (software)";
            software.push_back(std::move(choice));
            continue;
        }
        if (has_extension(extensions, "EGL_EXT_device_drm"))
            if (const char* file = query(device, EGL_DRM_DEVICE_FILE_EXT))
                choice.name += std::string(" (") + file + ")";
        found.choices.push_back(std::move(choice));
    }
    found.choices.insert(found.choices.end(), software.begin(), software.end());
    found.choices.push_back({std::nullopt, "EGL surfaceless"});
    return found;
}

std::unique_ptr<Platform> make_egl_platform(const EglChoice& choice) {
    return std::make_unique<EglPlatform>(choice);
}

}  // namespace nicol::gl
