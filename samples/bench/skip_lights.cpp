// SPDX-License-Identifier: MIT
#include "skip_lights.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include "common/handles.hpp"
#include "median.hpp"
#include "skip_rays.hpp"
#include "sphere.hpp"

namespace {

struct Case {
    const char* name;
    double dim;  // intensity of most lights, relative to that of the others
};

// The last row has nothing to skip: it shows what the search for dim lights costs.
const Case kCases[] = {{.name = "32 dim lights beside 2", .dim = 1e-6},
                       {.name = "34 lights, none of them dim", .dim = 1}};

constexpr int kLights = 34;
constexpr int kBright = 2;
constexpr std::uint32_t kChannels = 3;

// Renders a bumpy sphere under point lights around it, with or without the search for dim lights.
class Runner {
public:
    Runner(nicol_context context, const Case& use, nicol_mesh mesh, std::uint32_t size, bool enabled) {
        nicol_scene scene = nullptr;
        check(nicol_scene_create(context, &scene));
        scene_.reset(scene);
        nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        plastic.alpha = 0.3F;
        nicol_material handle = nullptr;
        check(nicol_material_create_pplastic(context, &plastic, &handle));
        const Material material(handle);
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh;
        instance.material = material.get();
        check(nicol_scene_add_instance(scene, &instance, nullptr));
        for (int i = 0; i < kLights; ++i) {
            const double angle = 3.1 * i;  // one light after the other on opposite sides
            nicol_light light = NICOL_LIGHT_INIT;
            light.value.count = kChannels;
            for (std::uint32_t c = 0; c < kChannels; ++c)
                light.value.values[c] = static_cast<float>(i < kBright ? 1 : use.dim);
            light.to_world[3] = 2 * std::cos(angle);
            light.to_world[7] = 1.5;
            light.to_world[11] = 3 * std::sin(angle);
            check(nicol_scene_add_light(scene, &light, nullptr));
        }
        nicol_framebuffer framebuffer = nullptr;
        check(nicol_framebuffer_create(context, size, size, kChannels, &framebuffer));
        framebuffer_.reset(framebuffer);
        options_.disabled_optimisations = enabled ? 0 : NICOL_OPTIMISATION_DIM_LIGHTS;
    }

    void run_round() {
        const double angle = 0.01 * static_cast<double>(frames_.size());
        const double origin[3] = {3.5 * std::sin(angle), 0.5, 3.5 * std::cos(angle)};
        const double target[3] = {0, 0, 0}, up[3] = {0, 1, 0};
        check(nicol_camera_look_at(&camera_, origin, target, up));
        const auto start = std::chrono::steady_clock::now();
        check(nicol_render(scene_.get(), &camera_, &options_, framebuffer_.get()));
        frames_.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        nicol_statistics statistics = NICOL_STATISTICS_INIT;
        check(nicol_framebuffer_get_statistics(framebuffer_.get(), &statistics));
        rays_ = static_cast<double>(statistics.light_rays);
        transfers_.push_back(statistics.relight_ms + statistics.shade_ms);
    }
    // Returns the medians of all frames except the first, which also bakes.
    [[nodiscard]] double frame() const { return median({frames_.begin() + 1, frames_.end()}); }
    [[nodiscard]] double transfer() const { return median({transfers_.begin() + 1, transfers_.end()}); }
    // Returns the rays of the last frame.
    [[nodiscard]] double rays() const { return rays_; }
    [[nodiscard]] std::vector<float> image() const { return stokes_of(framebuffer_.get()); }

private:
    Scene scene_;
    Framebuffer framebuffer_;
    nicol_camera camera_ = NICOL_CAMERA_INIT;
    nicol_render_options options_ = NICOL_RENDER_OPTIONS_INIT;
    std::vector<double> frames_, transfers_;  // milliseconds
    double rays_ = 0;
};

}  // namespace

void add_light_rows(nicol_context context, std::uint32_t size, double seconds, Report& report) {
    const Mesh mesh = make_sphere(context, 20000, 0.1);
    for (const Case& use : kCases) {
        std::array<Runner, 2> runners{Runner(context, use, mesh.get(), size, false),
                                      Runner(context, use, mesh.get(), size, true)};
        const auto begin = std::chrono::steady_clock::now();
        const auto elapsed = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        };
        for (int round = 0; round < 6 || elapsed() < 2 * seconds; ++round)
            for (Runner& runner : runners) runner.run_round();
        const auto& [disabled, enabled] = runners;
        report.add(use.name,
                   {disabled.transfer() / enabled.transfer(), disabled.transfer(), enabled.transfer(),
                    disabled.frame() / enabled.frame(), largest_difference(enabled.image(), disabled.image()),
                    disabled.rays(), enabled.rays()});
    }
}
