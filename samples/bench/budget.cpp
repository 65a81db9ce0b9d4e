// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "commands.hpp"
#include "median.hpp"
#include "stage.hpp"

namespace {

constexpr int kFrames = 100;
constexpr double kWithin = 1.2;        // of the budget
constexpr double kUnreachable = 1e-3;  // ms: leads to the cheapest picture

struct Series {
    std::vector<double> milliseconds;
    nicol_statistics last = NICOL_STATISTICS_INIT;
};

// Renders frames in which light and camera move. The first picture, which bakes, is not counted.
Series frames(const SceneSource& source, double budget, std::uint32_t size) {
    using Clock = std::chrono::steady_clock;
    Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(size, size);
    nicol_render_options wanted = NICOL_RENDER_OPTIONS_INIT;
    check(nicol_render_options_set_quality(&wanted, NICOL_QUALITY_PREVIEW));
    wanted.time_budget_ms = budget;
    Series series;
    for (int frame = 0; frame <= kFrames; ++frame) {
        stage.orbit(0.37);
        if (stage.has_light()) stage.rotate_light(1.3);
        const auto start = Clock::now();
        series.last = stage.render(wanted, framebuffer.get());
        if (frame > 0)
            series.milliseconds.push_back(
                std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    return series;
}

}  // namespace

Report bench_budget(const Options& given) {
    const std::uint32_t size = given.size == 0 ? 512 : given.size;
    Report report({"scene, time_budget_ms", "frames within 1.2 times, %", "median ms", "95th percentile ms",
                   "cheapest ms", "given up", "pixel samples", "light samples", "at pixels", "order_low",
                   "order_high", "predicted error"});
    for (const char* name : {"snail_hdr", "snail_sun", "snail_textured"}) {
        const auto row_name = [&](double budget) {
            return std::string(name) + ", " + std::to_string(std::lround(budget));
        };
        std::vector<double> budgets{16.0, 33.0, 100.0};
        std::erase_if(budgets,
                      [&](double budget) { return row_name(budget).find(given.only) == std::string::npos; });
        if (budgets.empty()) continue;
        Options options = given;
        options.scene = std::string(NICOL_BENCH_ASSETS "/") + name + ".xml";
        const SceneSource source(options);
        const double cheapest = median(frames(source, kUnreachable, size).milliseconds);
        for (const double budget : budgets) {
            Series series = frames(source, budget, size);
            std::vector<double>& times = series.milliseconds;
            std::ranges::sort(times);
            const auto within = std::ranges::upper_bound(times, kWithin * budget) - times.begin();
            const nicol_statistics& last = series.last;
            report.add(
                row_name(budget),
                {100.0 * static_cast<double>(within) / kFrames, median(times), times[kFrames * 95 / 100 - 1],
                 cheapest, static_cast<double>(last.given_up), static_cast<double>(last.pixel_samples),
                 static_cast<double>(last.light_samples), last.pixels_shaded > 0 ? 1.0 : 0.0,
                 static_cast<double>(last.order_low), static_cast<double>(last.order), last.predicted_error});
        }
    }
    report.note(
        "100 frames after the first picture, in which light and camera move; the wish is "
        "NICOL_QUALITY_PREVIEW. "
        "Cheapest: median of frames that give up all they can.");
    return report;
}
