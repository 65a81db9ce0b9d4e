// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "common/handles.hpp"
#include "median.hpp"
#include "skip_lights.hpp"
#include "skip_rays.hpp"
#include "sphere.hpp"
#include "stage.hpp"

namespace {

using Clock = std::chrono::steady_clock;

enum class Change { light, camera, nothing };

constexpr std::uint32_t kChannels = 3;

// An optimisation and a scene in which it has an effect.
struct Case {
    const char* name;
    std::uint32_t optimisation;
    Change change;
    bool diffuse = false;
    bool grey = false;
    bool tinted = false;  // grey light times a colour
    bool polarized = false;
    bool convex = false;
    std::uint32_t light_order = 16;
    std::optional<std::uint32_t> order_low = std::nullopt;
};

const Case kCases[] = {
    {.name = "nothing changed", .optimisation = NICOL_OPTIMISATION_UNCHANGED, .change = Change::nothing},
    {.name = "light unpolarized",
     .optimisation = NICOL_OPTIMISATION_LIGHT_COMPONENTS,
     .change = Change::light},
    {.name = "light and material grey",
     .optimisation = NICOL_OPTIMISATION_CHANNELS,
     .change = Change::light,
     .grey = true},
    {.name = "light of one colour, material grey",
     .optimisation = NICOL_OPTIMISATION_CHANNELS,
     .change = Change::light,
     .grey = true,
     .tinted = true},
    {.name = "light of low orders",
     .optimisation = NICOL_OPTIMISATION_ORDERS,
     .change = Change::light,
     .light_order = 4},
    {.name = "material depolarizing, order 12",
     .optimisation = NICOL_OPTIMISATION_RESPONSE_ROWS,
     .change = Change::camera,
     .diffuse = true,
     .polarized = true,
     .order_low = 12},
    {.name = "vertices hidden", .optimisation = NICOL_OPTIMISATION_HIDDEN, .change = Change::camera},
    {.name = "convex object, no shadows",
     .optimisation = NICOL_OPTIMISATION_UNOCCLUDED,
     .change = Change::light,
     .convex = true},
    {.name = "all, diffuse under unpolarized grey light",
     .optimisation = NICOL_OPTIMISATION_ALL & ~NICOL_OPTIMISATION_UNCHANGED,
     .change = Change::light,
     .diffuse = true,
     .grey = true,
     .light_order = 4},
};

// Returns light whose power falls with the order like that of natural light. Orders 2 and above may be
// polarized.
Environment make_light(nicol_context context, const Case& use) {
    const std::size_t count = std::size_t{use.light_order + 1} * (use.light_order + 1);
    std::vector<double> coefficients(kChannels * count * 4);
    for (std::uint32_t c = 0; c < kChannels; ++c) {
        std::mt19937 random(use.grey ? 0 : c);
        std::normal_distribution<double> normal;
        for (std::size_t i = 0; i < count; ++i) {
            const double l = std::floor(std::sqrt(static_cast<double>(i)));
            double* stokes = &coefficients[(c * count + i) * 4];
            const double tint = use.tinted ? 0.5 + 0.5 * c : 1;
            stokes[0] = tint * (i == 0 ? 6 : std::pow(l, -1.3) * normal(random));
            for (std::size_t p = 1; use.polarized && l >= 2 && p < 4; ++p)
                stokes[p] = 0.3 * std::pow(l, -1.3) * normal(random);
        }
    }
    nicol_environment handle = nullptr;
    check(nicol_environment_create_psh(context, use.light_order, kChannels, coefficients.data(),
                                       coefficients.size(), &handle));
    return Environment(handle);
}

Material make_material(nicol_context context, const Case& use) {
    nicol_material handle = nullptr;
    if (use.diffuse) {
        nicol_spectrum grey = NICOL_SPECTRUM_INIT;
        grey.count = 1;
        grey.values[0] = 0.5F;
        check(nicol_material_create_diffuse(context, &grey, &handle));
    } else {
        nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        plastic.alpha = 0.3F;
        check(nicol_material_create_pplastic(context, &plastic, &handle));
    }
    return Material(handle);
}

// Renders a case with or without its optimisation.
class Runner {
public:
    Runner(nicol_context context, const Case& use, nicol_mesh mesh, std::uint32_t size, bool enabled)
        : case_(use), light_(make_light(context, use)) {
        nicol_scene scene = nullptr;
        check(nicol_scene_create(context, &scene));
        scene_.reset(scene);
        const Material material = make_material(context, use);
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh;
        instance.material = material.get();
        check(nicol_scene_add_instance(scene, &instance, nullptr));
        nicol_framebuffer framebuffer = nullptr;
        check(nicol_framebuffer_create(context, size, size, kChannels, &framebuffer));
        framebuffer_.reset(framebuffer);
        options_.order_low = use.order_low.value_or(4);
        options_.order_high = 9;
        if (use.order_low) {
            options_.high_orders = NICOL_HIGH_ORDERS_NONE;
        }
        options_.disabled_optimisations = enabled ? 0 : use.optimisation;
    }

    void run_round() {
        if (frames_.empty() || case_.change == Change::light) rotate_light();
        if (frames_.empty() || case_.change == Change::camera) move_camera();
        const auto start = Clock::now();
        check(nicol_render(scene_.get(), &camera_, &options_, framebuffer_.get()));
        frames_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        nicol_statistics statistics = NICOL_STATISTICS_INIT;
        check(nicol_framebuffer_get_statistics(framebuffer_.get(), &statistics));
        if (frames_.size() == 1) rays_ = static_cast<double>(statistics.bake_rays);
        transfers_.push_back(statistics.relight_ms + statistics.shade_ms);
    }
    // Returns the median of all frames except the first, which also bakes.
    [[nodiscard]] double frame() const { return median({frames_.begin() + 1, frames_.end()}); }
    [[nodiscard]] double transfer() const { return median({transfers_.begin() + 1, transfers_.end()}); }
    [[nodiscard]] std::vector<float> image() const { return stokes_of(framebuffer_.get()); }
    // Returns the rays of the first frame.
    [[nodiscard]] double rays() const { return rays_; }

private:
    void rotate_light() {
        light_angle_ += 0.02;
        const double c = std::cos(light_angle_), s = std::sin(light_angle_);
        const double to_world[16] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
        check(nicol_scene_set_environment(scene_.get(), light_.get(), to_world, 1));
    }
    void move_camera() {
        camera_angle_ += 0.01;
        const double origin[3] = {3.5 * std::sin(camera_angle_), 0.5, 3.5 * std::cos(camera_angle_)};
        const double target[3] = {0, 0, 0}, up[3] = {0, 1, 0};
        check(nicol_camera_look_at(&camera_, origin, target, up));
    }

    Case case_;
    Environment light_;
    Scene scene_;
    Framebuffer framebuffer_;
    nicol_camera camera_ = NICOL_CAMERA_INIT;
    nicol_render_options options_ = NICOL_RENDER_OPTIONS_INIT;
    double light_angle_ = 0;
    double camera_angle_ = 0;
    std::vector<double> frames_;  // milliseconds
    double rays_ = 0;
    std::vector<double> transfers_;  // relight and shade in milliseconds
};

}  // namespace

Report bench_skip(const Options& options) {
    const std::uint32_t size = options.size == 0 ? 512 : options.size;
    const Context context = make_context(options.backend, options.cache);
    const Mesh bumpy = make_sphere(context.get(), 20000, 0.1);
    const Mesh convex = make_sphere(context.get(), 20000, 0);
    Report report({"what the scene does not need", "relight + shade, disabled / enabled", "ms disabled",
                   "ms enabled", "frame, disabled / enabled", "largest difference", "rays disabled",
                   "rays enabled"});
    for (const Case& use : kCases) {
        const nicol_mesh mesh = use.convex ? convex.get() : bumpy.get();
        std::array<Runner, 2> runners{Runner(context.get(), use, mesh, size, false),
                                      Runner(context.get(), use, mesh, size, true)};
        const auto begin = Clock::now();
        for (int round = 0;
             round < 6 || std::chrono::duration<double>(Clock::now() - begin).count() < 2 * options.seconds;
             ++round) {
            for (Runner& runner : runners) runner.run_round();
        }
        const auto& [disabled, enabled] = runners;
        const bool runs = use.change != Change::nothing;
        const double none = std::nan("");
        report.add(use.name,
                   {runs ? disabled.transfer() / enabled.transfer() : none, runs ? disabled.transfer() : none,
                    runs ? enabled.transfer() : none, disabled.frame() / enabled.frame(),
                    largest_difference(enabled.image(), disabled.image()), disabled.rays(), enabled.rays()});
    }
    add_light_rows(context.get(), size, options.seconds, report);
    add_ray_rows(context.get(), size, report);
    report.note("Frames of a sphere of 20,000 vertices, bumpy but for the convex object, " +
                std::to_string(size) + " x " + std::to_string(size) +
                ", after the light rotates, the camera moves or nothing changes; differences over the "
                "largest value. Rows of lights: frames after the camera moved, and their rays to lights. "
                "Rows of rays: "
                "first pictures of new scenes.");
    return report;
}
