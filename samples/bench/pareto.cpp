// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "dense_memory.hpp"
#include "frame_times.hpp"
#include "plot.hpp"
#include "truth.hpp"

namespace {

constexpr std::uint32_t kErrorSize = 256;

// Points of one curve: a method and its treatment of orders above order_low.
struct Family {
    nicol_method method;
    High high;
    int top;
    const char* name;
    const char* colour;
    bool dashed;
};
constexpr Family kFamilies[] = {
    {NICOL_METHOD_FACTORED, High::none, 0, "factored", "#0060c0", false},
    {NICOL_METHOD_FACTORED, High::split, 32, "factored + split to 32", "#0060c0", true},
    {NICOL_METHOD_DENSE, High::none, 0, "dense", "#c04000", false},
    {NICOL_METHOD_DENSE, High::convolution, 9, "dense + convolution to 9", "#c04000", true},
};

struct Entry {
    std::size_t family;
    Recipe recipe;
    StokesErrors errors;
    FrameTimes times;
};

std::vector<Entry> entries(const Options& options, const DenseMemory& memory) {
    const int first = options.first_order < 0 ? 1 : options.first_order;
    const int last = options.last_order < 0 ? 12 : options.last_order;
    double used = 0;
    std::vector<Entry> list;
    // The list begins with low orders of the dense method that fit together.
    for (int order = first; order <= last; ++order) {
        for (std::size_t f = 0; f < std::size(kFamilies); ++f) {
            const Family& family = kFamilies[f];
            if (family.high != High::none && order >= family.top) continue;
            if (family.method == NICOL_METHOD_DENSE) {
                if (used + memory.at(order) > options.memory) continue;
                used += memory.at(order);
            }
            list.push_back(
                {f, {.method = family.method, .low = order, .high = family.high, .top = family.top}, {}, {}});
        }
    }
    return list;
}

double linear(const StokesErrors& errors) {
    return std::hypot(errors[1], errors[2]);
}

double transfer_ms(const FrameTimes& times) {
    return times.light_relight + times.light_shade;
}

bool no_worse(const StokesErrors& a, const StokesErrors& b) {
    return a[0] <= b[0] && a[1] <= b[1] && a[2] <= b[2];
}

// Finds for each order of the dense method the cheapest factored entry with no larger error in any component.
void compare_at_equal_error(Report& report, const std::vector<Entry>& list) {
    for (const Entry& dense : list) {
        if (dense.recipe.method != NICOL_METHOD_DENSE || std::isnan(dense.times.light)) continue;
        const Entry* best = nullptr;
        for (const Entry& e : list) {
            if (e.recipe.method == NICOL_METHOD_FACTORED && no_worse(e.errors, dense.errors) &&
                (best == nullptr || transfer_ms(e.times) < transfer_ms(best->times)))
                best = &e;
        }
        if (best == nullptr) continue;
        char text[200];
        std::snprintf(text, sizeof text,
                      "%s errs no more than %s, which takes, in relight + shade as the light rotates, %.3g "
                      "times as long.",
                      best->recipe.name().c_str(), dense.recipe.name().c_str(),
                      transfer_ms(dense.times) / transfer_ms(best->times));
        report.note(text);
    }
}

template <class X, class Y>
Panel panel(const std::vector<Entry>& list, const char* title, const char* y_axis, X x, Y y) {
    Panel out{title, "frame, ms (median)", y_axis, {}};
    for (std::size_t f = 0; f < std::size(kFamilies); ++f) {
        Series series{kFamilies[f].name, kFamilies[f].colour, kFamilies[f].dashed, {}};
        for (const Entry& e : list) {
            if (e.family == f)
                series.points.push_back({x(e.times), y(e.errors), std::to_string(e.recipe.low)});
        }
        out.series.push_back(std::move(series));
    }
    return out;
}

void write_plot(const std::string& path, const std::vector<Entry>& list) {
    const auto light = [](const FrameTimes& t) { return t.light; };
    const auto camera = [](const FrameTimes& t) { return t.camera; };
    const auto s0 = [](const StokesErrors& e) { return e[0]; };
    constexpr const char* s0_axis = "relative RMSE of s0";
    constexpr const char* linear_axis = "relative RMSE of (s1, s2)";
    std::ofstream out(path);
    write_svg(out,
              {panel(list, "the light rotates", s0_axis, light, s0),
               panel(list, "the camera moves", s0_axis, camera, s0),
               panel(list, "the light rotates", linear_axis, light, linear),
               panel(list, "the camera moves", linear_axis, camera, linear)},
              2);
    out.close();
    if (!out) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace

Report bench_pareto(const Options& options) {
    const std::uint32_t size = options.size == 0 ? 1024 : options.size;
    const std::uint32_t small = std::min(size, kErrorSize);
    const SceneSource source(options);
    std::vector<Entry> list = entries(options, DenseMemory(source));
    const Truth truth = make_truth(source, small, options.samples == 0 ? 256 : options.samples, true);

    std::vector<Contestant> contestants;
    contestants.reserve(list.size());
    for (Entry& entry : list) {
        const Contestant& added = contestants.emplace_back(source, entry.recipe, size);
        const Framebuffer wide = added.stage().framebuffer(kReduction * small, kReduction * small);
        entry.errors = truth.errors(reduced_image(added.stage(), entry.recipe, wide.get()));
    }
    const std::vector<FrameTimes> times = time_frames(contestants, options.seconds);
    Report report({"method and orders", "light rotating ms", "camera only ms", "s0", "s1", "s2", "s3"});
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i].times = times[i];
        const StokesErrors& e = list[i].errors;
        report.add(list[i].recipe.name(), {times[i].light, times[i].camera, e[0], e[1], e[2], e[3]});
    }
    compare_at_equal_error(report, list);
    report.note(source.machine() + "; frames of " + std::to_string(size) + " x " + std::to_string(size) +
                ", errors relative to the RMS of s0 at " + std::to_string(small) + " x " +
                std::to_string(small) + ", shadows included.");
    if (!options.plot.empty()) write_plot(options.plot, list);
    return report;
}
