// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>
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
    StokesErrors errors{};
    double before_ms = 0;  // project and bake, from nothing
    double megabytes = 0;  // tables of materials, and what vertices keep
    FrameTimes times{};
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
                {f, {.method = family.method, .low = order, .high = family.high, .top = family.top}, {}});
        }
    }
    return list;
}

double s0(const Entry& entry) {
    return entry.errors[0];
}

double linear(const Entry& entry) {
    return std::hypot(entry.errors[1], entry.errors[2]);
}

double together(const Entry& entry) {
    return std::hypot(s0(entry), linear(entry));
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
                (best == nullptr || e.times.light_transfer() < best->times.light_transfer()))
                best = &e;
        }
        if (best == nullptr) continue;
        char text[200];
        std::snprintf(text, sizeof text,
                      "%s errs no more than %s, which takes, in relight + shade as the light rotates, %.3g "
                      "times as long.",
                      best->recipe.name().c_str(), dense.recipe.name().c_str(),
                      dense.times.light_transfer() / best->times.light_transfer());
        report.note(text);
    }
}

using Value = double (*)(const Entry&);
double light_ms(const Entry& entry) {
    return entry.times.light;
}
double camera_ms(const Entry& entry) {
    return entry.times.camera;
}
double before_ms(const Entry& entry) {
    return entry.before_ms;
}
double megabytes(const Entry& entry) {
    return entry.megabytes;
}

constexpr const char* kFrame = "frame, ms (median)";
constexpr const char* kS0 = "relative RMSE of s0";
constexpr const char* kLinear = "relative RMSE of (s1, s2)";

Panel panel(const std::vector<Entry>& list, const char* title, const char* x_axis, const char* y_axis,
            Value x, Value y) {
    Panel out{title, x_axis, y_axis, {}};
    for (std::size_t f = 0; f < std::size(kFamilies); ++f) {
        Series series{kFamilies[f].name, kFamilies[f].colour, kFamilies[f].dashed, {}};
        for (const Entry& e : list)
            if (e.family == f) series.points.push_back({x(e), y(e), std::to_string(e.recipe.low)});
        out.series.push_back(std::move(series));
    }
    return out;
}

// Reads the curve of another program: its name in the first line, then lines of label, milliseconds, errors
// of s0, s1 and s2.
Series read_peer(const std::string& path) {
    std::ifstream in(path);
    Series series{.name = {}, .colour = "#208040", .points = {}};
    std::getline(in, series.name);
    for (std::string line; std::getline(in, line);) {
        std::ranges::replace(line, ',', ' ');
        std::istringstream words(line);
        std::string label;
        double ms = 0, errors[3] = {};
        if (!(words >> label >> ms >> errors[0] >> errors[1] >> errors[2]))
            throw std::runtime_error(path + ": '" + line + "' is not label,ms,s0,s1,s2");
        series.points.push_back({ms, std::hypot(errors[0], errors[1], errors[2]), label});
    }
    if (series.points.empty()) throw std::runtime_error(path + ": has no curve of label,ms,s0,s1,s2");
    return series;
}

void write_plot(const std::string& path, const std::optional<Series>& peer, const std::vector<Entry>& list) {
    std::vector<Panel> panels;
    if (!peer) {
        panels = {panel(list, "the light rotates", kFrame, kS0, light_ms, s0),
                  panel(list, "the camera moves", kFrame, kS0, camera_ms, s0),
                  panel(list, "the light rotates", kFrame, kLinear, light_ms, linear),
                  panel(list, "the camera moves", kFrame, kLinear, camera_ms, linear),
                  panel(list, "before the first picture", "project and bake, ms", kS0, before_ms, s0),
                  panel(list, "memory", "tables and vertices, MB", kS0, megabytes, s0)};
    } else {
        panels = {
            panel(list, "the light rotates", kFrame, "relative RMSE of (s0, s1, s2)", light_ms, together)};
        panels[0].series.push_back(*peer);
    }
    std::ofstream out(path);
    write_svg(out, panels, static_cast<int>(std::min<std::size_t>(panels.size(), 2)));
    out.close();
    if (!out) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace

Report bench_pareto(const Options& options) {
    const std::uint32_t size = options.size == 0 ? 1024 : options.size;
    const std::uint32_t small = std::min(size, kErrorSize);
    const std::optional<Series> peer =
        options.peer.empty() ? std::nullopt : std::optional(read_peer(options.peer));
    const SceneSource source(options);
    std::vector<Entry> list = entries(options, DenseMemory(source));
    const Truth truth = make_truth(source, small, options.samples == 0 ? 256 : options.samples, true);

    std::vector<Contestant> contestants;
    contestants.reserve(list.size());
    Options alone = options;
    alone.cache.clear();
    for (Entry& entry : list) {
        const SceneSource fresh(alone);  // nothing that others have projected or baked helps
        const Stage stage(fresh);
        const Framebuffer wide = stage.framebuffer(kReduction * small, kReduction * small);
        entry.errors = truth.errors(reduced_image(stage, entry.recipe, wide.get()));
        nicol_statistics first = NICOL_STATISTICS_INIT;
        check(nicol_framebuffer_get_statistics(wide.get(), &first));
        entry.before_ms = first.project_ms + first.bake_ms;
        entry.megabytes =
            1e-6 * static_cast<double>(first.response_bytes + first.visibility_bytes + first.transfer_bytes);
        contestants.emplace_back(source, entry.recipe, size);
    }
    const std::vector<FrameTimes> times = time_frames(contestants, options.seconds);
    Report report({"method and orders", "light rotating ms", "camera only ms", "s0", "s1", "s2", "s3",
                   "before the first ms", "MB"});
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i].times = times[i];
        const StokesErrors& e = list[i].errors;
        report.add(list[i].recipe.name(), {times[i].light, times[i].camera, e[0], e[1], e[2], e[3],
                                           list[i].before_ms, list[i].megabytes});
    }
    compare_at_equal_error(report, list);
    report.note(source.machine() + "; frames of " + std::to_string(size) + " x " + std::to_string(size) +
                ", errors relative to the RMS of s0 at " + std::to_string(small) + " x " +
                std::to_string(small) + ", shadows included.");
    if (!options.plot.empty()) write_plot(options.plot, peer, list);
    return report;
}
