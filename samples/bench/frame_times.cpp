// SPDX-License-Identifier: MIT
#include "frame_times.hpp"

#include <chrono>
#include <cmath>

#include "median.hpp"

namespace {

using Clock = std::chrono::steady_clock;

// A full circle takes many frames, and no two frames of a run are equal.
constexpr double kCameraStep = 0.37;
constexpr double kLightStep = 1.3;

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
    for (Contestant& contestant : contestants) contestant.run_round();
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
