// SPDX-License-Identifier: MIT
// Reader of EGL's device list.
#define EGL_NO_X11
#include "gl/device_list.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <optional>
#include <string_view>

#include "error.hpp"
#include "files/shared_library.hpp"
#include "gl/egl_extensions.hpp"

// Names of EGL_EXT_device_persistent_id and EGL_EXT_device_query_name, which older headers lack.
#ifndef EGL_RENDERER_EXT
#define EGL_RENDERER_EXT 0x335F
#endif
#ifndef EGL_DRM_RENDER_NODE_FILE_EXT
#define EGL_DRM_RENDER_NODE_FILE_EXT 0x3377
#endif

namespace nicol::gl {
namespace {

class DeviceQuery {
public:
    /// Loads EGL. Throws Error(no_backend) if there is no EGL.
    DeviceQuery() {
        const auto query_string = library_.function<decltype(&eglQueryString)>("eglQueryString");
        const auto proc_address = library_.function<decltype(&eglGetProcAddress)>("eglGetProcAddress");
        const char* client = query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
        if (!has_extension(client, "EGL_EXT_device_enumeration") &&
            !has_extension(client, "EGL_EXT_device_base"))
            return;
        devices_ = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(proc_address("eglQueryDevicesEXT"));
        string_ = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(proc_address("eglQueryDeviceStringEXT"));
    }

    [[nodiscard]] std::vector<EGLDeviceEXT> devices() const {
        EGLint count = 0;
        if (devices_ == nullptr || !devices_(0, nullptr, &count) || count <= 0) return {};
        std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
        if (!devices_(count, found.data(), &count) || count < 0) return {};
        if (static_cast<std::size_t>(count) < found.size()) found.resize(static_cast<std::size_t>(count));
        return found;
    }

    [[nodiscard]] Device describe(EGLDeviceEXT device, std::size_t index) const {
        const char* extensions = string_ != nullptr ? string_(device, EGL_EXTENSIONS) : nullptr;
        const auto text = [&](const char* extension, EGLint name) -> std::string {
            const char* value = has_extension(extensions, extension) ? string_(device, name) : nullptr;
            return value != nullptr ? value : "";
        };
        Device out;
        out.software = has_extension(extensions, "EGL_MESA_device_software");
        out.file = text("EGL_EXT_device_drm_render_node", EGL_DRM_RENDER_NODE_FILE_EXT);
        if (out.file.empty()) out.file = text("EGL_EXT_device_drm", EGL_DRM_DEVICE_FILE_EXT);
        out.vendor = text("EGL_EXT_device_query_name", EGL_VENDOR);
        out.name = text("EGL_EXT_device_query_name", EGL_RENDERER_EXT);
        if (out.name.empty()) out.name = out.file;
        if (out.name.empty() && out.software) out.name = "software";
        if (out.name.empty()) out.name = "EGL device " + std::to_string(index);
        return out;
    }

private:
    SharedLibrary library_{{"libEGL.so.1", "libEGL.so"}, ErrorCode::no_backend};
    PFNEGLQUERYDEVICESEXTPROC devices_ = nullptr;
    PFNEGLQUERYDEVICESTRINGEXTPROC string_ = nullptr;
};

}  // namespace

std::vector<Device> list_devices() {
    std::optional<DeviceQuery> query;
    try {
        query.emplace();
    } catch (const Error&) {  // without EGL there are no devices to choose from
        return {};
    }
    std::vector<Device> found;
    for (EGLDeviceEXT device : query->devices()) found.push_back(query->describe(device, found.size()));
    return found;
}

}  // namespace nicol::gl
