// SPDX-License-Identifier: MIT
// What the tests of the C interface share.
#pragma once

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "nicol.h"
#include "nicol_files.h"
#include "nicol_psh.h"

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

namespace capi_test {

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

inline nicol_spectrum spectrum(const std::vector<float>& values) {
    nicol_spectrum s = NICOL_SPECTRUM_INIT;
    s.count = static_cast<std::uint32_t>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) s.values[i] = values[i];
    return s;
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

/// One mesh as it lies, under one light.
inline nicol_scene simple_scene(nicol_context context, nicol_environment environment, nicol_mesh mesh,
                                nicol_material material) {
    nicol_scene scene = nullptr;
    OK(nicol_scene_create(context, &scene));
    OK(nicol_scene_set_environment(scene, environment, nullptr, 0));
    nicol_instance instance = NICOL_INSTANCE_INIT;
    instance.mesh = mesh;
    instance.material = material;
    OK(nicol_scene_add_instance(scene, &instance, nullptr));
    return scene;
}

/// A cube under a polarizing sky, and a small framebuffer: something of everything.
struct Stage {
    nicol_environment environment = nullptr;
    nicol_material material = nullptr;
    nicol_mesh mesh = nullptr;
    nicol_scene scene = nullptr;
    nicol_framebuffer framebuffer = nullptr;
    nicol_camera camera = front_camera();

    explicit Stage(nicol_context context) {
        nicol_sky sky = NICOL_SKY_INIT;
        sky.sun_direction[0] = 1;
        sky.sun_direction[1] = 1;
        OK(nicol_environment_create_sky(context, &sky, &environment));
        const nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        OK(nicol_material_create_pplastic(context, &plastic, &material));
        OK(nicol_mesh_create_cube(context, &mesh));
        OK(nicol_scene_create(context, &scene));
        OK(nicol_scene_set_environment(scene, environment, nullptr, 0));
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh;
        instance.material = material;
        const Matrix rotated = {{0.4, 0, 0.3, 0, 0.1, 0.5, 0, 0, -0.3, 0, 0.4, 0, 0, 0, 0, 1}};
        std::copy_n(rotated.rows, 16, instance.to_world);
        OK(nicol_scene_add_instance(scene, &instance, nullptr));
        OK(nicol_framebuffer_create(context, 24, 16, 3, &framebuffer));
    }
    ~Stage() {
        for (const nicol_result result :
             {nicol_framebuffer_release(framebuffer), nicol_scene_release(scene), nicol_mesh_release(mesh),
              nicol_material_release(material), nicol_environment_release(environment)}) {
            CHECK(result == NICOL_OK);
        }
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    void render() const { OK(nicol_render(scene, &camera, nullptr, framebuffer)); }
};

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

/// A handle that must not be touched.
template <class Handle>
Handle marker() {
    return reinterpret_cast<Handle>(std::uintptr_t{0x5a5a0});
}

/// A fresh folder, removed with all that is in it.
class Folder {
public:
    Folder() {
        std::random_device random;
        path_ = std::filesystem::temp_directory_path() / ("nicol-capi-" + std::to_string(random()));
        std::filesystem::create_directory(path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name) << text;
        return file(name);
    }
    [[nodiscard]] std::set<std::string> names() const {
        std::set<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(path_))
            found.insert(entry.path().filename().string());
        return found;
    }

private:
    std::filesystem::path path_;
};

}  // namespace capi_test
