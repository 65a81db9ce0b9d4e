// SPDX-License-Identifier: MIT
#include "frame_times.hpp"

#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "median.hpp"

namespace {

using Clock = std::chrono::steady_clock;

// With these steps a full circle takes many frames, and no two frames of a run are equal.
constexpr double kCameraStep = 0.37;
constexpr double kLightStep = 1.3;

nicol_spectrum colours(std::uint32_t channels, float first, float step) {
    nicol_spectrum spectrum = NICOL_SPECTRUM_INIT;
    spectrum.count = channels;
    for (std::uint32_t c = 0; c < channels; ++c)
        spectrum.values[c] = first + step * static_cast<float>(c % 4);
    return spectrum;
}

Environment sky(nicol_context context, std::uint32_t channels, bool polarized) {
    nicol_sky wanted = NICOL_SKY_INIT;
    if (!polarized) wanted.dop_max = 0;
    wanted.sun_direction[0] = 0.7F;
    wanted.sun_direction[1] = 0.35F;
    wanted.sun_direction[2] = -0.6F;
    wanted.radiance = colours(channels, 0.95F, -0.2F);
    nicol_environment handle = nullptr;
    check(nicol_environment_create_sky(context, &wanted, &handle));
    return Environment(handle);
}

Material surface(nicol_context context, std::uint32_t channels, bool polarizing) {
    const nicol_spectrum colour = colours(channels, 0.6F, -0.15F);
    nicol_material handle = nullptr;
    if (polarizing) {
        nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        plastic.diffuse_reflectance = colour;
        plastic.alpha = 0.3F;
        check(nicol_material_create_pplastic(context, &plastic, &handle));
    } else {
        check(nicol_material_create_diffuse(context, &colour, &handle));
    }
    return Material(handle);
}

void apply_variant(Stage& stage, SceneVariant variant) {
    if (variant == SceneVariant::original) return;
    std::uint32_t channels = 0;
    check(nicol_scene_get_channels(stage.scene(), &channels));
    stage.set_light(sky(stage.context(), channels, variant == SceneVariant::polarized));
    stage.set_material(surface(stage.context(), channels, variant != SceneVariant::unpolarized).get());
}

}  // namespace

Contestant::Contestant(const SceneSource& source, const Recipe& recipe, std::uint32_t size,
                       SceneVariant variant)
    : stage_(source), recipe_(recipe), framebuffer_(stage_.framebuffer(size, size)) {
    apply_variant(stage_, variant);
}

Contestant::Frame Contestant::frame() {
    const auto start = Clock::now();
    const nicol_statistics statistics = stage_.render(recipe_.options(), framebuffer_.get());
    return {std::chrono::duration<double, std::milli>(Clock::now() - start).count(), statistics};
}

void Contestant::show_all() {
    constexpr int most = 64;
    for (int i = 0; i < most; ++i) {
        stage_.orbit(kCameraStep);
        if (frame().statistics.vertices_unbaked == 0) return;
    }
}

void Contestant::run_round() {
    stage_.orbit(kCameraStep);
    camera_.push_back(frame());
    if (stage_.has_light()) {
        stage_.rotate_light(kLightStep);
        light_.push_back(frame());
    }
    still_.push_back(frame());
}

FrameTimes Contestant::medians() const {
    const auto median_of = [](const std::vector<Frame>& frames, auto value) {
        std::vector<double> values;
        for (std::size_t i = 1; i < frames.size(); ++i) values.push_back(value(frames[i]));
        return median(std::move(values));
    };
    const auto whole = [](const Frame& f) { return f.milliseconds; };
    const auto relight = [](const Frame& f) { return f.statistics.relight_ms; };
    const auto shade = [](const Frame& f) { return f.statistics.shade_ms; };
    const auto draw = [](const Frame& f) { return f.statistics.draw_ms; };
    const nicol_statistics& last = still_.back().statistics;
    return {.camera = median_of(camera_, whole),
            .light = median_of(light_, whole),
            .still = median_of(still_, whole),
            .camera_shade = median_of(camera_, shade),
            .camera_draw = median_of(camera_, draw),
            .light_relight = median_of(light_, relight),
            .light_shade = median_of(light_, shade),
            .light_draw = median_of(light_, draw),
            .transfer_mb = 1e-6 * static_cast<double>(last.transfer_bytes + last.visibility_bytes)};
}

std::vector<FrameTimes> time_frames(std::vector<Contestant>& contestants, double seconds) {
    for (Contestant& contestant : contestants) {
        contestant.show_all();
        contestant.run_round();
    }
    const auto begin = Clock::now();
    const double total = seconds * static_cast<double>(contestants.size());
    for (int round = 0; round < 5 || std::chrono::duration<double>(Clock::now() - begin).count() < total;
         ++round) {
        for (Contestant& contestant : contestants) contestant.run_round();
    }
    std::vector<FrameTimes> times;
    for (const Contestant& contestant : contestants) times.push_back(contestant.medians());
    return times;
}

Recipe floor_recipe() {
    return {.low = 0, .shadows = false};
}
