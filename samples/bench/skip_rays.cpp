// SPDX-License-Identifier: MIT
#include "skip_rays.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include "common/handles.hpp"
#include "sphere.hpp"

namespace {

struct Case {
    const char* name;
    std::uint32_t vertices = 20000;
    double waves = 0;
    std::uint32_t balls = 1;  // in a square
    double apart = 3;
    float reflectance = 0.5F;
    double light = 1;
    double target = 0;  // x of the point that the camera looks at
};

const Case kCases[] = {{.name = "rays of a convex object alone"},
                       {.name = "rays of two convex objects, 1,000 apart", .balls = 2, .apart = 1000},
                       {.name = "rays of sixteen convex objects", .vertices = 2000, .balls = 16},
                       {.name = "rays of a black object", .waves = 0.1, .reflectance = 0},
                       {.name = "rays in darkness", .waves = 0.1, .light = 0},
                       {.name = "rays of an object outside of the view", .waves = 0.1, .target = 100},
                       {.name = "rays of the far side of an object", .waves = 0.1}};

struct First {
    double milliseconds;
    nicol_statistics statistics;
    std::vector<float> image;
};

// Renders the first picture of a new scene.
First first_picture(nicol_context context, const Case& use, nicol_mesh mesh, std::uint32_t size,
                    bool enabled) {
    nicol_scene made = nullptr;
    check(nicol_scene_create(context, &made));
    const Scene scene(made);
    nicol_spectrum grey = NICOL_SPECTRUM_INIT;
    grey.count = 1;
    grey.values[0] = use.reflectance;
    nicol_material handle = nullptr;
    check(nicol_material_create_diffuse(context, &grey, &handle));
    const Material material(handle);
    nicol_instance instance = NICOL_INSTANCE_INIT;
    instance.mesh = mesh;
    instance.material = material.get();
    const auto across = static_cast<std::uint32_t>(std::ceil(std::sqrt(use.balls)));
    for (std::uint32_t i = 0; i < use.balls; ++i) {
        instance.to_world[3] = use.apart * (i % across);
        instance.to_world[7] = use.apart * (i / across);
        check(nicol_scene_add_instance(scene.get(), &instance, nullptr));
    }
    nicol_sky sky = NICOL_SKY_INIT;
    nicol_environment light = nullptr;
    check(nicol_environment_create_sky(context, &sky, &light));
    const Environment environment(light);
    check(nicol_scene_set_environment(scene.get(), environment.get(), nullptr, use.light));

    nicol_camera camera = NICOL_CAMERA_INIT;
    const double origin[3] = {0, 0.5, 3.5}, target[3] = {use.target, 0, 0}, up[3] = {0, 1, 0};
    check(nicol_camera_look_at(&camera, origin, target, up));
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.disabled_optimisations = enabled ? 0 : NICOL_OPTIMISATION_RAYS;
    nicol_framebuffer buffer = nullptr;
    check(nicol_framebuffer_create(context, size, size, 3, &buffer));
    const Framebuffer framebuffer(buffer);
    First first{.milliseconds = 0, .statistics = NICOL_STATISTICS_INIT, .image = {}};
    const auto start = std::chrono::steady_clock::now();
    check(nicol_render(scene.get(), &camera, &options, framebuffer.get()));
    first.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    check(nicol_framebuffer_get_statistics(framebuffer.get(), &first.statistics));
    first.image = stokes_of(framebuffer.get());
    return first;
}

}  // namespace

void add_ray_rows(nicol_context context, std::uint32_t size, Report& report) {
    for (const Case& use : kCases) {
        const Mesh mesh = make_sphere(context, use.vertices, use.waves);
        const First without = first_picture(context, use, mesh.get(), size, false);
        const First with = first_picture(context, use, mesh.get(), size, true);
        const double none = std::nan("");
        report.add(use.name, {none, none, none, without.milliseconds / with.milliseconds,
                              largest_difference(with.image, without.image),
                              static_cast<double>(without.statistics.bake_rays),
                              static_cast<double>(with.statistics.bake_rays)});
    }
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
    float largest = 0, scale = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
        scale = std::max(scale, std::abs(b[i]));
    }
    return scale > 0 ? static_cast<double>(largest / scale) : static_cast<double>(largest);
}

std::vector<float> stokes_of(nicol_framebuffer framebuffer) {
    std::uint32_t width = 0, height = 0, channels = 0;
    check(nicol_framebuffer_get_size(framebuffer, &width, &height, &channels));
    const std::size_t plane = std::size_t{4} * width * height;
    std::vector<float> all(channels * plane);
    for (std::uint32_t c = 0; c < channels; ++c)
        check(nicol_framebuffer_read(framebuffer, NICOL_PLANE_STOKES, c, all.data() + c * plane, 0,
                                     plane * sizeof(float)));
    return all;
}
