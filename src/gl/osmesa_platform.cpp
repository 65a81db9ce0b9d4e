// SPDX-License-Identifier: MIT
// Platform of Mesa's off-screen library: always llvmpipe or softpipe; needs no device and no driver registry.
// It is the last resort because Mesa dropped it in 25.1.
// Newer osmesa.h use APIENTRY, which glad's header, if it comes first, keeps GL/gl.h from defining.
#ifndef APIENTRY
#define APIENTRY GLAPIENTRY
#endif
#include <GL/osmesa.h>

#include <array>
#include <mutex>

#include "error.hpp"
#include "files/shared_library.hpp"
#include "forked.hpp"
#include "gl/platform.hpp"

namespace nicol::gl {
namespace {

struct OsMesa {
    SharedLibrary library{{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}, ErrorCode::no_backend};
    decltype(&OSMesaCreateContextAttribs) create =
        library.function<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    decltype(&OSMesaMakeCurrent) make_current =
        library.function<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    decltype(&OSMesaDestroyContext) destroy =
        library.function<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
    decltype(&OSMesaGetProcAddress) proc_address =
        library.function<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");
};

OsMesa& osmesa() {
    static OsMesa instance;
    return instance;
}

class OsMesaPlatform final : public Platform {
public:
    OsMesaPlatform() {
        const std::lock_guard lock(driver_mutex());
        constexpr int attributes[] = {OSMESA_FORMAT,
                                      OSMESA_RGBA,
                                      OSMESA_PROFILE,
                                      OSMESA_CORE_PROFILE,
                                      OSMESA_CONTEXT_MAJOR_VERSION,
                                      4,
                                      OSMESA_CONTEXT_MINOR_VERSION,
                                      5,
                                      0};
        context_ = osmesa().create(attributes, nullptr);
        if (context_ == nullptr)
            throw Error(ErrorCode::no_backend, "OSMesa cannot make an OpenGL 4.5 core context");
        if (!osmesa().make_current(context_, window_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
            osmesa().destroy(context_);
            throw Error(ErrorCode::no_backend, "OSMesaMakeCurrent failed");
        }
    }

    ~OsMesaPlatform() override {
        const std::lock_guard lock(driver_mutex());
        osmesa().make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        osmesa().destroy(context_);
    }

    OsMesaPlatform(const OsMesaPlatform&) = delete;
    OsMesaPlatform& operator=(const OsMesaPlatform&) = delete;

    Function function(const char* name) const override { return osmesa().proc_address(name); }

private:
    OSMesaContext context_ = nullptr;
    std::array<unsigned char, 4> window_{};  // default framebuffer, required by OSMesa; nothing draws into it
};

}  // namespace

std::unique_ptr<Platform> make_osmesa_platform() {
    return std::make_unique<OsMesaPlatform>();
}

}  // namespace nicol::gl
