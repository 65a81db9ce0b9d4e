// SPDX-License-Identifier: MIT
#include "skip.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include "bumpy_sphere.hpp"
#include "common/handles.hpp"
#include "median.hpp"
#include "stage.hpp"

namespace {

using Clock = std::chrono::steady_clock;

enum class Change { light, camera, nothing };

constexpr std::uint32_t kChannels = 3;

// A scene that does not need something.
struct Exhibit {
    const char* name;
    std::uint32_t skip;
    Change change;
    bool diffuse = false;
    bool grey = false;
    std::uint32_t light_order = 16;
};

const Exhibit exhibits[] = {
    {.name = "nothing changed", .skip = NICOL_OPTIMISATION_UNCHANGED, .change = Change::nothing},
    {.name = "light unpolarized", .skip = NICOL_OPTIMISATION_LIGHT_COMPONENTS, .change = Change::light},
    {.name = "light and material grey",
     .skip = NICOL_OPTIMISATION_CHANNELS,
     .change = Change::light,
     .grey = true},
    {.name = "light of low orders",
     .skip = NICOL_OPTIMISATION_ORDERS,
     .change = Change::light,
     .light_order = 4},
    {.name = "material depolarizing",
     .skip = NICOL_OPTIMISATION_RESPONSE_ROWS,
     .change = Change::camera,
     .diffuse = true},
    {.name = "vertices hidden", .skip = NICOL_OPTIMISATION_HIDDEN, .change = Change::camera},
    {.name = "vertices unoccluded", .skip = NICOL_OPTIMISATION_UNOCCLUDED, .change = Change::light},
    {.name = "all, diffuse under unpolarized grey light",
     .skip = NICOL_OPTIMISATION_ALL & ~NICOL_OPTIMISATION_UNCHANGED,
     .change = Change::light,
     .diffuse = true,
     .grey = true,
     .light_order = 4},
};

// Its power falls with the order, as that of natural light does.
Environment make_light(nicol_context context, const Exhibit& exhibit) {
    const std::size_t count = std::size_t{exhibit.light_order + 1} * (exhibit.light_order + 1);
    std::vector<double> coefficients(kChannels * count * 4);
    for (std::uint32_t c = 0; c < kChannels; ++c) {
        std::mt19937 random(exhibit.grey ? 0 : c);
        std::normal_distribution<double> normal;
        for (std::size_t i = 0; i < count; ++i) {
            const double l = std::floor(std::sqrt(static_cast<double>(i)));
            coefficients[(c * count + i) * 4] = i == 0 ? 6 : std::pow(l, -1.3) * normal(random);
        }
    }
    nicol_environment handle = nullptr;
    check(nicol_environment_create_psh(context, exhibit.light_order, kChannels, coefficients.data(),
                                       coefficients.size(), &handle));
    return Environment(handle);
}

Material make_material(nicol_context context, const Exhibit& exhibit) {
    nicol_material handle = nullptr;
    if (exhibit.diffuse) {
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

// One of two that take turns: with the skip, and without it.
class Show {
public:
    Show(nicol_context context, const Exhibit& exhibit, nicol_mesh mesh, std::uint32_t size, bool skipping)
        : exhibit_(exhibit), light_(make_light(context, exhibit)) {
        nicol_scene scene = nullptr;
        check(nicol_scene_create(context, &scene));
        scene_.reset(scene);
        const Material material = make_material(context, exhibit);
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh;
        instance.material = material.get();
        check(nicol_scene_add_instance(scene, &instance, nullptr));
        nicol_framebuffer framebuffer = nullptr;
        check(nicol_framebuffer_create(context, size, size, kChannels, &framebuffer));
        framebuffer_.reset(framebuffer);
        options_.disabled_optimisations = skipping ? 0 : exhibit.skip;
    }

    void run_round() {
        if (frames_.empty() || exhibit_.change == Change::light) rotate_light();
        if (frames_.empty() || exhibit_.change == Change::camera) move_camera();
        const auto start = Clock::now();
        check(nicol_render(scene_.get(), &camera_, &options_, framebuffer_.get()));
        frames_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        nicol_statistics statistics = NICOL_STATISTICS_INIT;
        check(nicol_framebuffer_get_statistics(framebuffer_.get(), &statistics));
        transfers_.push_back(statistics.relight_ms + statistics.shade_ms);
    }
    // The first frame makes what later ones find.
    [[nodiscard]] double frame() const { return median({frames_.begin() + 1, frames_.end()}); }
    [[nodiscard]] double transfer() const { return median({transfers_.begin() + 1, transfers_.end()}); }
    [[nodiscard]] std::vector<float> image() const {
        std::uint32_t width = 0, height = 0, channels = 0;
        check(nicol_framebuffer_get_size(framebuffer_.get(), &width, &height, &channels));
        const std::size_t plane = std::size_t{4} * width * height;
        std::vector<float> all(channels * plane);
        for (std::uint32_t c = 0; c < channels; ++c) {
            check(nicol_framebuffer_read(framebuffer_.get(), NICOL_PLANE_STOKES, c, all.data() + c * plane, 0,
                                         plane * sizeof(float)));
        }
        return all;
    }

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

    Exhibit exhibit_;
    Environment light_;
    Scene scene_;
    Framebuffer framebuffer_;
    nicol_camera camera_ = NICOL_CAMERA_INIT;
    nicol_render_options options_ = NICOL_RENDER_OPTIONS_INIT;
    double light_angle_ = 0;
    double camera_angle_ = 0;
    std::vector<double> frames_;     // milliseconds
    std::vector<double> transfers_;  // of which relight and shade
};

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
    float largest = 0, scale = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
        scale = std::max(scale, std::abs(b[i]));
    }
    return static_cast<double>(largest / scale);
}

}  // namespace

Report bench_skip(const Options& options) {
    const std::uint32_t size = options.size == 0 ? 512 : options.size;
    const Context context = make_context(options.backend, options.cache);
    const Mesh mesh = make_bumpy_sphere(context.get(), 20000);
    Report report({"what the scene does not need", "relight + shade, without / with skip", "ms without",
                   "ms with", "frame, without / with", "largest difference"});
    for (const Exhibit& exhibit : exhibits) {
        std::array<Show, 2> shows{Show(context.get(), exhibit, mesh.get(), size, false),
                                  Show(context.get(), exhibit, mesh.get(), size, true)};
        const auto begin = Clock::now();
        for (int round = 0;
             round < 6 || std::chrono::duration<double>(Clock::now() - begin).count() < 2 * options.seconds;
             ++round) {
            for (Show& show : shows) show.run_round();
        }
        const auto& [full, skipping] = shows;
        const bool runs = exhibit.change != Change::nothing;
        const double none = std::nan("");
        report.add(exhibit.name,
                   {runs ? full.transfer() / skipping.transfer() : none, runs ? full.transfer() : none,
                    runs ? skipping.transfer() : none, full.frame() / skipping.frame(),
                    largest_difference(skipping.image(), full.image())});
    }
    report.note("Frames of a bumpy sphere of 20,000 vertices, " + std::to_string(size) + " x " +
                std::to_string(size) +
                ", after a turn of the light, a move of the camera or nothing; differences over the largest "
                "value.");
    return report;
}
