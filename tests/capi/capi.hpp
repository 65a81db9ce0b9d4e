// SPDX-License-Identifier: MIT
// Shared helpers of the C interface tests.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends.hpp"
#include "nicol.h"
#include "nicol_files.h"
#include "nicol_psh.h"
#include "temporary_folder.hpp"
#include "test.hpp"

#define OK(call)                               \
    do {                                       \
        const nicol_result result_ = (call);   \
        INFO(std::string(nicol_last_error())); \
        REQUIRE(result_ == NICOL_OK);          \
    } while (false)

// Checks that the call returns this code and that the message contains this text.
#define FAILS(call, code, text)                                                                    \
    do {                                                                                           \
        const nicol_result result_ = (call);                                                       \
        CHECK(result_ == code);                                                                    \
        const std::string message_ = nicol_last_error();                                           \
        CHECK_MESSAGE((result_ == NICOL_OK || message_.find(text) != std::string::npos), message_, \
                      " should name ", text);                                                      \
    } while (false)

// Checks that the call is refused for an argument, with a message that contains this text.
#define REFUSES(call, text) FAILS(call, NICOL_ERROR_INVALID_ARGUMENT, text)

namespace capi_test {

#define NICOL_RELEASE_OF(type)                 \
    inline nicol_result release(type handle) { \
        return type##_release(handle);         \
    }
NICOL_RELEASE_OF(nicol_context)
NICOL_RELEASE_OF(nicol_environment)
NICOL_RELEASE_OF(nicol_texture)
NICOL_RELEASE_OF(nicol_material)
NICOL_RELEASE_OF(nicol_mesh)
NICOL_RELEASE_OF(nicol_scene)
NICOL_RELEASE_OF(nicol_framebuffer)
NICOL_RELEASE_OF(nicol_job)
NICOL_RELEASE_OF(nicol_psh_transform)

/// An owned handle, released with the object.
template <class Handle>
class Owned {
public:
    Owned() = default;
    explicit Owned(Handle handle) : handle_(handle) {}
    ~Owned() { CHECK(release(handle_) == NICOL_OK); }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;

    operator Handle() const { return handle_; }  // NOLINT: it stands for the handle
    /// Returns the place for a function to store a new handle. The current handle is released.
    Handle* operator&() {  // NOLINT: as of a handle
        CHECK(release(handle_) == NICOL_OK);
        handle_ = nullptr;
        return &handle_;
    }

private:
    Handle handle_ = nullptr;
};

/// Returns the handle that create(arguments..., &handle) makes.
template <class... Parameters, class... Arguments>
auto make(nicol_result (*create)(Parameters...), const Arguments&... arguments) {
    std::remove_pointer_t<std::tuple_element_t<sizeof...(Arguments), std::tuple<Parameters...>>> handle =
        nullptr;
    OK(create(arguments..., &handle));
    return handle;
}

/// Returns the backends that tests run on: EGL alone if NICOL_TEST_BACKENDS is "egl".
inline std::vector<nicol_backend> every_backend() {
    if (nicol::test::wanted_backends() == "egl") return {NICOL_BACKEND_EGL};
    return {NICOL_BACKEND_EGL, NICOL_BACKEND_OSMESA};
}

inline nicol_context_options two_threads(nicol_backend backend) {
    nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
    options.backend = backend;
    options.threads = 2;
    return options;
}
inline nicol_context make_context(nicol_backend backend) {
    const nicol_context_options options = two_threads(backend);
    return make(nicol_context_create, &options);
}

inline nicol_context retained(nicol_context context) {
    OK(nicol_context_retain(context));
    return context;
}

/// Calls test(context) once per backend and releases the context.
template <class Test>
void on_every_backend(Test test) {
    for (const nicol_backend backend : every_backend()) {
        CAPTURE(backend);
        const nicol_context context = make_context(backend);
        test(context);
        OK(nicol_context_release(context));
    }
}

inline nicol_mesh cube(nicol_context context) {
    return make(nicol_mesh_create_cube, context);
}
inline nicol_mesh sphere(nicol_context context) {
    return make(nicol_mesh_create_sphere, context);
}
inline nicol_mesh rectangle(nicol_context context) {
    return make(nicol_mesh_create_rectangle, context);
}
inline nicol_scene empty_scene(nicol_context context) {
    return make(nicol_scene_create, context);
}
inline nicol_framebuffer framebuffer_of(nicol_context context, std::uint32_t width, std::uint32_t height,
                                        std::uint32_t channels) {
    return make(nicol_framebuffer_create, context, width, height, channels);
}

/// Returns a mesh over arrays of three numbers per vertex and per triangle.
inline nicol_mesh_data mesh_over(std::span<const float> positions, std::span<const std::uint32_t> indices) {
    nicol_mesh_data data = NICOL_MESH_DATA_INIT;
    data.vertex_count = static_cast<std::uint32_t>(positions.size() / 3);
    data.triangle_count = static_cast<std::uint32_t>(indices.size() / 3);
    data.positions = positions.data();
    data.indices = indices.data();
    return data;
}
/// Returns an image over the numbers of `pixels`, rows of texels of `channels` numbers.
template <class Number>
nicol_texture_image image_of_texels(const std::vector<Number>& pixels, std::uint32_t width,
                                    std::uint32_t height, std::uint32_t channels, nicol_texel type) {
    nicol_texture_image image = NICOL_TEXTURE_IMAGE_INIT;
    image.type = type;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.pixels = pixels.data();
    image.byte_size = pixels.size() * sizeof(Number);
    return image;
}

inline nicol_spectrum spectrum(const std::vector<float>& values) {
    nicol_spectrum s = NICOL_SPECTRUM_INIT;
    s.count = static_cast<std::uint32_t>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) s.values[i] = values[i];
    return s;
}

/// Returns an environment of equal radiance in every direction.
inline nicol_environment constant_light(nicol_context context, const std::vector<float>& radiance) {
    const nicol_spectrum values = spectrum(radiance);
    return make(nicol_environment_create_constant, context, &values);
}
/// Returns an image over `pixels`, laid out [row][column][channel][component].
inline nicol_image image_of(const std::vector<float>& pixels, std::uint32_t width, std::uint32_t height,
                            std::uint32_t channels, std::uint32_t components = 4) {
    nicol_image image = NICOL_IMAGE_INIT;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.components = components;
    image.pixels = pixels.data();
    image.byte_size = pixels.size() * sizeof(float);
    return image;
}

/// Returns a clear sky of three channels with the sun in direction `sun`.
inline nicol_environment clear_sky(nicol_context context, const std::array<float, 3>& sun = {0, 1, 0}) {
    nicol_sky sky = NICOL_SKY_INIT;
    std::ranges::copy(sun, sky.sun_direction);
    return make(nicol_environment_create_sky, context, &sky);
}
inline nicol_material diffuse(nicol_context context, const std::vector<float>& reflectance) {
    const nicol_spectrum values = spectrum(reflectance);
    return make(nicol_material_create_diffuse, context, &values);
}
inline nicol_material plastic_of(nicol_context context,
                                 const nicol_pplastic& parameters = NICOL_PPLASTIC_INIT) {
    return make(nicol_material_create_pplastic, context, &parameters);
}
/// Returns a grey callback material without `user` and `release`.
inline nicol_callback_material grey_function() {
    nicol_callback_material parameters = NICOL_CALLBACK_MATERIAL_INIT;
    parameters.mueller = [](void*, std::uint32_t, const double*, const double*, double* mueller) {
        std::fill_n(mueller, 16, 0.0);
        mueller[0] = 0.1;
        return std::int32_t{1};
    };
    return parameters;
}

inline nicol_camera camera_at(const glm::dvec3& origin) {
    nicol_camera camera = NICOL_CAMERA_INIT;
    const double target[] = {0, 0, 0}, up[] = {0, 1, 0};
    OK(nicol_camera_look_at(&camera, &origin.x, target, up));
    return camera;
}
/// Returns a camera at (0, 0, distance) that looks at the origin. The world's x axis points to the image's
/// right.
inline nicol_camera front_camera(double distance = 3) {
    return camera_at({0, 0, distance});
}

struct Matrix {
    double rows[16] = NICOL_IDENTITY_4X4;
};

inline Matrix placed(double x, double y, double z, double scale = 1) {
    return {{scale, 0, 0, x, 0, scale, 0, y, 0, 0, scale, z, 0, 0, 0, 1}};
}

/// Adds an instance and returns its id.
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

/// Returns a scene of one mesh at the identity transform under one light.
inline nicol_scene simple_scene(nicol_context context, nicol_environment environment, nicol_mesh mesh,
                                nicol_material material) {
    const nicol_scene scene = empty_scene(context);
    OK(nicol_scene_set_environment(scene, environment, nullptr, 1));
    add(scene, mesh, material);
    return scene;
}

inline nicol_statistics statistics_of(nicol_framebuffer framebuffer) {
    nicol_statistics statistics = NICOL_STATISTICS_INIT;
    OK(nicol_framebuffer_get_statistics(framebuffer, &statistics));
    return statistics;
}

/// Reads one plane of one channel, tightly packed.
inline std::vector<float> read_plane(nicol_framebuffer framebuffer, nicol_plane plane,
                                     std::uint32_t channel = 0) {
    std::uint32_t width = 0, height = 0, channels = 0;
    OK(nicol_framebuffer_get_size(framebuffer, &width, &height, &channels));
    std::vector<float> pixels(
        std::size_t{width} * height * (plane == NICOL_PLANE_STOKES || plane == NICOL_PLANE_VARIANCE ? 4 : 1),
        -99.0F);
    OK(nicol_framebuffer_read(framebuffer, plane, channel, pixels.data(), 0, pixels.size() * sizeof(float)));
    return pixels;
}

/// Reads the Stokes planes of all channels: [channel][pixel][component].
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

/// Norms of the difference between two images and of the truth, per Stokes component, over the pixels that
/// count.
struct Distance {
    std::array<double, 4> error{}, size{};

    template <class Number>
    Distance(const std::vector<Number>& found, const std::vector<Number>& truth,
             const std::vector<bool>& counts = {true}) {
        REQUIRE(found.size() == truth.size());
        for (std::size_t i = 0; i < truth.size(); ++i) {
            if (!counts[i / 4 % counts.size()]) continue;
            error[i % 4] = std::hypot(error[i % 4], double(found[i]) - double(truth[i]));
            size[i % 4] = std::hypot(size[i % 4], double(truth[i]));
        }
    }
};

/// Checks that one channel is the luminance of three, to a relative tolerance.
inline void check_luminance(const std::vector<float>& y, const std::vector<float>& rgb, double tolerance) {
    REQUIRE(rgb.size() == 3 * y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double wanted = 0.2126 * rgb[i] + 0.7152 * rgb[y.size() + i] + 0.0722 * rgb[2 * y.size() + i];
        CHECK(y[i] == doctest::Approx(wanted).epsilon(tolerance));
    }
}

/// Returns options for tests of other features: fixed orders, shading at vertices, values as computed.
inline nicol_render_options plain_options() {
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.order_low = 4;
    options.order_high = 9;
    options.shade_at = NICOL_SHADE_AT_VERTICES;
    options.executor = NICOL_EXECUTOR_CPU;  // also where a graphics processor would be chosen
    options.physical = 0;
    return options;
}

/// A loaded scene file, its camera and film size, and a framebuffer of that size.
struct LoadedScene {
    Owned<nicol_scene> scene;
    Owned<nicol_framebuffer> framebuffer;
    nicol_camera camera = NICOL_CAMERA_INIT;
    std::uint32_t width = 0, height = 0, channels = 0;

    LoadedScene(nicol_context context, const std::string& path, std::vector<const char*> definitions = {})
        : scene(make(nicol_scene_load, context, path.c_str(), definitions.data(),
                     static_cast<std::uint32_t>(definitions.size()))) {
        OK(nicol_scene_get_camera(scene, &camera));
        OK(nicol_scene_get_film_size(scene, &width, &height));
        OK(nicol_scene_get_channels(scene, &channels));
        OK(nicol_framebuffer_create(context, width, height, channels, &framebuffer));
    }
    [[nodiscard]] std::vector<float> image(const nicol_render_options& options = plain_options()) const {
        OK(nicol_render(scene, &camera, &options, framebuffer));
        return read_all(framebuffer);
    }
};

/// A cube under a polarizing sky, and a small framebuffer.
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
          environment(clear_sky(context, {1, 1, 0})),
          material(plastic_of(context)),
          mesh(cube(context)),
          scene(empty_scene(context)),
          framebuffer(framebuffer_of(context, 24, 16, 3)) {
        OK(nicol_scene_set_environment(scene, environment, nullptr, 1));
        add(scene, mesh, material, {{0.4, 0, 0.3, 0, 0.1, 0.5, 0, 0, -0.3, 0, 0.4, 0, 0, 0, 0, 1}});
    }

    [[nodiscard]] nicol_result try_render(const nicol_render_options& options) const {
        return nicol_render(scene, &camera, &options, framebuffer);
    }
    void render() const { OK(try_render(plain_options())); }
    /// Renders the scene and returns the image.
    [[nodiscard]] std::vector<float> image(const nicol_render_options& options = plain_options()) const {
        OK(try_render(options));
        return read_all(framebuffer);
    }
};

/// Calls test(stage) once per backend.
template <class Test>
void on_every_stage(Test test) {
    on_every_backend([&](nicol_context context) { test(Stage(context)); });
}

/// A call that must fail with this code and a message that contains this text.
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

/// A change that makes good arguments wrong, and text that the refusal's message must contain.
template <class T>
struct Wrong {
    const char* text;
    std::function<void(T&)> change;
};
/// Checks that call(arguments) refuses the good arguments after each single change.
template <class T, class Call>
void check_wrong(const T& good, Call call, const std::vector<Wrong<T>>& cases) {
    for (const Wrong<T>& wrong : cases) {
        CAPTURE(wrong.text);
        T changed = good;
        wrong.change(changed);
        REFUSES(call(changed), wrong.text);
    }
}

/// Returns a handle value that a failing function must leave untouched.
template <class Handle>
Handle marker() {
    return reinterpret_cast<Handle>(std::uintptr_t{0x5a5a0});
}

}  // namespace capi_test

/// A test case that runs once per backend, each time with a fresh `context` or `stage`.
#define CONTEXT_TEST_CASE(title) CAPI_TEST_CASE(title, backend, nicol_context context)
#define STAGE_TEST_CASE(title) CAPI_TEST_CASE(title, stage, const capi_test::Stage& stage)
#define CAPI_TEST_CASE(title, what, ...) \
    CAPI_TEST_CASE_NAMED(title, what, DOCTEST_ANONYMOUS(run_on_), __VA_ARGS__)
#define CAPI_TEST_CASE_NAMED(title, what, run, ...) \
    static void run(__VA_ARGS__);                   \
    TEST_CASE(title) {                              \
        capi_test::on_every_##what(run);            \
    }                                               \
    static void run(__VA_ARGS__)
