// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <cmath>
#include <cstdio>

#include "median.hpp"
#include "sphere.hpp"
#include "stage.hpp"

namespace {

struct Cost {
    double size;  // x value of the plot
    double bake, relight, shade, draw, bytes;
};

Environment polarized_sky(nicol_context context) {
    nicol_sky sky = NICOL_SKY_INIT;
    sky.sun_direction[0] = 0.7F;
    sky.sun_direction[1] = 0.35F;
    sky.sun_direction[2] = -0.6F;
    sky.radiance.count = 3;
    sky.radiance.values[0] = 0.5F;
    sky.radiance.values[1] = 0.65F;
    sky.radiance.values[2] = 0.95F;
    nicol_environment handle = nullptr;
    check(nicol_environment_create_sky(context, &sky, &handle));
    return Environment(handle);
}

// A bumpy sphere of pplastic under a polarized sky, for which no optimisation applies.
class Ball {
public:
    Ball(nicol_context context, std::uint32_t vertices) : sky_(polarized_sky(context)) {
        nicol_scene scene = nullptr;
        check(nicol_scene_create(context, &scene));
        scene_.reset(scene);
        nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        plastic.distribution = NICOL_DISTRIBUTION_GGX;
        plastic.alpha = 0.3F;
        nicol_material handle = nullptr;
        check(nicol_material_create_pplastic(context, &plastic, &handle));
        const Material material(handle);
        const Mesh mesh = make_sphere(context, vertices, 0.1);
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh.get();
        instance.material = material.get();
        check(nicol_scene_add_instance(scene, &instance, nullptr));
        const double origin[3] = {0, 0.5, 3.5}, target[3] = {0, 0, 0}, up[3] = {0, 1, 0};
        check(nicol_camera_look_at(&camera_, origin, target, up));
    }

    // Returns medians of frames after rotations of the light.
    Cost measure(const Recipe& recipe, nicol_framebuffer framebuffer, int frames) {
        Cost cost{};
        std::vector<double> relight, shade, draw;
        for (int i = 0; i <= frames; ++i) {
            const nicol_statistics s = rotated_frame(recipe, framebuffer);
            if (i == 0) cost.bake = s.bake_ms;
            if (i == 0) continue;
            relight.push_back(s.relight_ms);
            shade.push_back(s.shade_ms);
            draw.push_back(s.draw_ms);
            cost.bytes = static_cast<double>(s.transfer_bytes + s.visibility_bytes + s.buffer_bytes) /
                         static_cast<double>(s.vertices);
            cost.size = static_cast<double>(s.vertices);
        }
        cost.relight = median(relight);
        cost.shade = median(shade);
        cost.draw = median(draw);
        return cost;
    }

private:
    nicol_statistics rotated_frame(const Recipe& recipe, nicol_framebuffer framebuffer) {
        angle_ += 0.02;
        const double c = std::cos(angle_), s = std::sin(angle_);
        const double to_world[16] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
        check(nicol_scene_set_environment(scene_.get(), sky_.get(), to_world, 1));
        const nicol_render_options options = recipe.options();
        check(nicol_render(scene_.get(), &camera_, &options, framebuffer));
        nicol_statistics statistics = NICOL_STATISTICS_INIT;
        check(nicol_framebuffer_get_statistics(framebuffer, &statistics));
        return statistics;
    }

    Environment sky_;
    Scene scene_;
    nicol_camera camera_ = NICOL_CAMERA_INIT;
    double angle_ = 0;
};

// Fits log y over log x by least squares and returns the slope.
double slope(const std::vector<Cost>& costs, double Cost::*y) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const Cost& cost : costs) {
        const double lx = std::log(cost.size), ly = std::log(cost.*y);
        n += 1, sx += lx, sy += ly, sxx += lx * lx, sxy += lx * ly;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void add(Report& report, const std::string& what, const Cost& cost) {
    report.add(what, {cost.bake, cost.relight, cost.shade, cost.draw, cost.bytes});
}

void add_slopes(Report& report, const std::vector<Cost>& costs, const char* what) {
    if (costs.size() < 2) return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "Time grows as %s to the power: relight %.2f, shade %.2f, draw %.2f; bytes a vertex %.2f.",
                  what, slope(costs, &Cost::relight), slope(costs, &Cost::shade), slope(costs, &Cost::draw),
                  slope(costs, &Cost::bytes));
    report.note(text);
}

}  // namespace

Report bench_scale(const Options& options) {
    const int frames = std::max(3, static_cast<int>(10 * options.seconds));
    const std::uint32_t size = options.size == 0 ? 512 : options.size;
    const Context context = make_context(options.backend, options.cache);
    nicol_framebuffer handle = nullptr;
    check(nicol_framebuffer_create(context.get(), size, size, 3, &handle));
    const Framebuffer framebuffer(handle);
    Report report({"what", "bake ms", "relight ms", "shade ms", "draw ms", "bytes a vertex"});

    std::vector<std::uint32_t> counts{2000, 20000, 200000};
    if (options.large) counts.push_back(2000000);
    std::vector<Cost> costs;
    for (const std::uint32_t count : counts) {
        // The bake is not compared here, so 256 directions are enough.
        const Recipe recipe{.directions = 256};
        costs.push_back(Ball(context.get(), count).measure(recipe, framebuffer.get(), frames));
        add(report, std::to_string(static_cast<long>(costs.back().size)) + " vertices, order 4",
            costs.back());
    }
    add_slopes(report, costs, "the number of vertices");

    const int first = options.first_order < 0 ? 2 : options.first_order;
    const int last = options.last_order < 0 ? 32 : options.last_order;
    costs.clear();
    Ball ball(context.get(), counts.front());
    for (int order = std::max(first, 1); order <= last; order *= 2) {
        const Recipe recipe{.low = order, .directions = 256};
        costs.push_back(ball.measure(recipe, framebuffer.get(), frames));
        add(report, "order " + std::to_string(order) + ", 2000 vertices", costs.back());
        costs.back().size = order + 1;
    }
    add_slopes(report, costs, "order + 1");
    report.note("A bumpy sphere of pplastic under a polarized sky, the light rotating, shadows on; " +
                std::to_string(size) + " x " + std::to_string(size) + ".");
    return report;
}
