// SPDX-License-Identifier: MIT
// What the tests of the C interface share.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "nicol.h"
#include "nicol_files.h"
#include "nicol_psh.h"
#include "temporary_folder.hpp"

#define OK(call)                               \
    do {                                       \
        const nicol_result result_ = (call);   \
        INFO(std::string(nicol_last_error())); \
        REQUIRE(result_ == NICOL_OK);          \
    } while (false)

// The call must return this code, and the message must contain this text.
#define FAILS(call, code, text)                                                                    \
    do {                                                                                           \
        const nicol_result result_ = (call);                                                       \
        CHECK(result_ == code);                                                                    \
        const std::string message_ = nicol_last_error();                                           \
        CHECK_MESSAGE((result_ == NICOL_OK || message_.find(text) != std::string::npos), message_, \
                      " should name ", text);                                                      \
    } while (false)

// The call must be refused for an argument, with a message that contains this text.
#define REFUSES(call, text) FAILS(call, NICOL_ERROR_INVALID_ARGUMENT, text)

namespace capi_test {

inline nicol_result release(nicol_context handle) {
    return nicol_context_release(handle);
}
inline nicol_result release(nicol_environment handle) {
    return nicol_environment_release(handle);
}
inline nicol_result release(nicol_material handle) {
    return nicol_material_release(handle);
}
inline nicol_result release(nicol_mesh handle) {
    return nicol_mesh_release(handle);
}
inline nicol_result release(nicol_scene handle) {
    return nicol_scene_release(handle);
}
inline nicol_result release(nicol_framebuffer handle) {
    return nicol_framebuffer_release(handle);
}
inline nicol_result release(nicol_job handle) {
    return nicol_job_release(handle);
}
inline nicol_result release(nicol_psh_transform handle) {
    return nicol_psh_transform_release(handle);
}

/// Releases its handle with the object.
template <class Handle>
class Owned {
public:
    Owned() = default;
    explicit Owned(Handle handle) : handle_(handle) {}
    ~Owned() { CHECK(release(handle_) == NICOL_OK); }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;

    operator Handle() const { return handle_; }  // NOLINT: it stands for the handle
    /// Where a function stores a new handle; the one before is released.
    Handle* operator&() {  // NOLINT: as of a handle
        CHECK(release(handle_) == NICOL_OK);
        handle_ = nullptr;
        return &handle_;
    }

private:
    Handle handle_ = nullptr;
};

inline constexpr nicol_backend every_backend[] = {NICOL_BACKEND_EGL, NICOL_BACKEND_OSMESA};

inline nicol_context make_context(nicol_backend backend) {
    nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
    options.backend = backend;
    options.threads = 2;
    nicol_context context = nullptr;
    OK(nicol_context_create(&options, &context));
    return context;
}

/// Calls test(context) once a backend and releases the context.
template <class Test>
void on_every_backend(Test test) {
    for (const nicol_backend backend : every_backend) {
        CAPTURE(backend);
        const nicol_context context = make_context(backend);
        test(context);
        OK(nicol_context_release(context));
    }
}

inline nicol_mesh cube(nicol_context context) {
    nicol_mesh mesh = nullptr;
    OK(nicol_mesh_create_cube(context, &mesh));
    return mesh;
}
inline nicol_mesh sphere(nicol_context context) {
    nicol_mesh mesh = nullptr;
    OK(nicol_mesh_create_sphere(context, &mesh));
    return mesh;
}
inline nicol_mesh rectangle(nicol_context context) {
    nicol_mesh mesh = nullptr;
    OK(nicol_mesh_create_rectangle(context, &mesh));
    return mesh;
}
inline nicol_scene empty_scene(nicol_context context) {
    nicol_scene scene = nullptr;
    OK(nicol_scene_create(context, &scene));
    return scene;
}
inline nicol_framebuffer framebuffer_of(nicol_context context, std::uint32_t width, std::uint32_t height,
                                        std::uint32_t channels) {
    nicol_framebuffer framebuffer = nullptr;
    OK(nicol_framebuffer_create(context, width, height, channels, &framebuffer));
    return framebuffer;
}

inline nicol_spectrum spectrum(const std::vector<float>& values) {
    nicol_spectrum s = NICOL_SPECTRUM_INIT;
    s.count = static_cast<std::uint32_t>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) s.values[i] = values[i];
    return s;
}

/// The same from every direction.
inline nicol_environment constant_light(nicol_context context, const std::vector<float>& radiance) {
    const nicol_spectrum values = spectrum(radiance);
    nicol_environment environment = nullptr;
    OK(nicol_environment_create_constant(context, &values, &environment));
    return environment;
}
inline nicol_material diffuse(nicol_context context, const std::vector<float>& reflectance) {
    const nicol_spectrum values = spectrum(reflectance);
    nicol_material material = nullptr;
    OK(nicol_material_create_diffuse(context, &values, &material));
    return material;
}

/// A camera at (0, 0, distance) that looks at the origin; the world's x is to the image's right.
inline nicol_camera front_camera(double distance = 3) {
    nicol_camera camera = NICOL_CAMERA_INIT;
    const double origin[] = {0, 0, distance}, target[] = {0, 0, 0}, up[] = {0, 1, 0};
    OK(nicol_camera_look_at(&camera, origin, target, up));
    return camera;
}

struct Matrix {
    double rows[16];
};

inline Matrix placed(double x, double y, double z, double scale = 1) {
    return {{scale, 0, 0, x, 0, scale, 0, y, 0, 0, scale, z, 0, 0, 0, 1}};
}

/// The id of the new instance.
inline std::uint32_t add(nicol_scene scene, nicol_mesh mesh, nicol_material material,
                         const Matrix& to_world = {}) {
    nicol_instance instance = NICOL_INSTANCE_INIT;
    instance.mesh = mesh;
    instance.material = material;
    std::copy_n(to_world.rows, 16, instance.to_world);
    std::uint32_t id = NICOL_NO_INSTANCE;
    OK(nicol_scene_add_instance(scene, &instance, &id));
    return id;
}

/// One mesh as it lies, under one light.
inline nicol_scene simple_scene(nicol_context context, nicol_environment environment, nicol_mesh mesh,
                                nicol_material material) {
    const nicol_scene scene = empty_scene(context);
    OK(nicol_scene_set_environment(scene, environment, nullptr, 0));
    add(scene, mesh, material);
    return scene;
}

inline nicol_statistics statistics_of(nicol_framebuffer framebuffer) {
    nicol_statistics statistics = NICOL_STATISTICS_INIT;
    OK(nicol_framebuffer_get_statistics(framebuffer, &statistics));
    return statistics;
}

/// One plane of one channel, tightly packed.
inline std::vector<float> read_plane(nicol_framebuffer framebuffer, nicol_plane plane,
                                     std::uint32_t channel = 0) {
    std::uint32_t width = 0, height = 0, channels = 0;
    OK(nicol_framebuffer_get_size(framebuffer, &width, &height, &channels));
    std::vector<float> pixels(std::size_t{width} * height * (plane == NICOL_PLANE_STOKES ? 4 : 1), -99.0F);
    OK(nicol_framebuffer_read(framebuffer, plane, channel, pixels.data(), 0, pixels.size() * sizeof(float)));
    return pixels;
}

/// Everything in it: [channel][pixel][component].
inline std::vector<float> read_all(nicol_framebuffer framebuffer) {
    std::uint32_t width = 0, height = 0, channels = 0;
    OK(nicol_framebuffer_get_size(framebuffer, &width, &height, &channels));
    std::vector<float> all;
    for (std::uint32_t c = 0; c < channels; ++c) {
        const std::vector<float> plane = read_plane(framebuffer, NICOL_PLANE_STOKES, c);
        all.insert(all.end(), plane.begin(), plane.end());
    }
    return all;
}

inline float largest_of(const std::vector<float>& image) {
    float largest = 0;
    for (const float value : image) largest = std::max(largest, std::abs(value));
    return largest;
}
inline float largest_difference(const std::vector<float>& a, std::vector<float> b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) b[i] -= a[i];
    return largest_of(b);
}

/// A cube under a polarizing sky, and a small framebuffer: something of everything.
struct Stage {
    nicol_context context;  ///< not owned
    Owned<nicol_environment> environment;
    Owned<nicol_material> material;
    Owned<nicol_mesh> mesh;
    Owned<nicol_scene> scene;
    Owned<nicol_framebuffer> framebuffer;
    nicol_camera camera = front_camera();

    explicit Stage(nicol_context owner)
        : context(owner),
          mesh(cube(context)),
          scene(empty_scene(context)),
          framebuffer(framebuffer_of(context, 24, 16, 3)) {
        nicol_sky sky = NICOL_SKY_INIT;
        sky.sun_direction[0] = 1;
        sky.sun_direction[1] = 1;
        OK(nicol_environment_create_sky(context, &sky, &environment));
        const nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        OK(nicol_material_create_pplastic(context, &plastic, &material));
        OK(nicol_scene_set_environment(scene, environment, nullptr, 0));
        add(scene, mesh, material, {{0.4, 0, 0.3, 0, 0.1, 0.5, 0, 0, -0.3, 0, 0.4, 0, 0, 0, 0, 1}});
    }

    [[nodiscard]] nicol_result try_render(const nicol_render_options& options) const {
        return nicol_render(scene, &camera, &options, framebuffer);
    }
    void render() const { OK(nicol_render(scene, &camera, nullptr, framebuffer)); }
    /// Rendered and read.
    [[nodiscard]] std::vector<float> image(
        const nicol_render_options& options = NICOL_RENDER_OPTIONS_INIT) const {
        OK(try_render(options));
        return read_all(framebuffer);
    }
};

/// Calls test(stage) once a backend.
template <class Test>
void on_every_stage(Test test) {
    on_every_backend([&](nicol_context context) { test(Stage(context)); });
}

/// A call that must fail, with this code and a message that contains this text.
struct Refused {
    const char* text;
    std::function<nicol_result()> call;
    nicol_result code = NICOL_ERROR_INVALID_ARGUMENT;
};
inline void check_refused(const std::vector<Refused>& cases) {
    for (const Refused& refused : cases) {
        CAPTURE(refused.text);
        FAILS(refused.call(), refused.code, refused.text);
    }
}

/// A change that makes good arguments wrong, and a text of the message that they are refused with.
template <class T>
struct Wrong {
    const char* text;
    std::function<void(T&)> change;
};
/// call(arguments) must refuse each change to the good ones alone.
template <class T, class Call>
void check_wrong(const T& good, Call call, const std::vector<Wrong<T>>& cases) {
    for (const Wrong<T>& wrong : cases) {
        CAPTURE(wrong.text);
        T changed = good;
        wrong.change(changed);
        REFUSES(call(changed), wrong.text);
    }
}

/// A handle that must not be touched.
template <class Handle>
Handle marker() {
    return reinterpret_cast<Handle>(std::uintptr_t{0x5a5a0});
}

}  // namespace capi_test
