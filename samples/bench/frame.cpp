// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <cmath>
#include <cstdio>

#include "dense_memory.hpp"
#include "frame_times.hpp"
#include "silhouette.hpp"
#include "textured_frame.hpp"

namespace {

void add_rows(Report& report, const std::string& name, const FrameTimes& t, double floor) {
    const double none = std::nan("");
    report.add(name + ": camera",
               {t.camera / floor, t.camera, none, t.camera_shade, t.camera_draw, t.transfer_mb});
    if (!std::isnan(t.light)) {
        report.add(name + ": light",
                   {t.light / floor, t.light, t.light_relight, t.light_shade, t.light_draw, t.transfer_mb});
    }
    report.add(name + ": nothing", {t.still / floor, t.still, none, none, none, t.transfer_mb});
}

std::string times(const std::string& what, double ratio) {
    char text[200];
    std::snprintf(text, sizeof text, "%s: %.3g times.", what.c_str(), ratio);
    return text;
}

void compare(Report& report, const FrameTimes& dense, const FrameTimes& factored, const std::string& what) {
    report.note(times("dense / factored, " + what + ", shade, camera only",
                      dense.camera_shade / factored.camera_shade));
    if (!std::isnan(dense.light)) {
        report.note(times("dense / factored, " + what + ", relight + shade, light rotating",
                          dense.light_transfer() / factored.light_transfer()));
    }
    report.note(
        times("dense / factored, " + what + ", bytes of vertices", dense.transfer_mb / factored.transfer_mb));
}

// Compares recipes of several samples with their equals of one sample.
void compare_samples(Report& report, const std::vector<Recipe>& list,
                     const std::vector<FrameTimes>& medians) {
    for (std::size_t i = 1; i < list.size(); ++i) {
        if (list[i].samples == 1) continue;
        Recipe one = list[i];
        one.samples = 1;
        for (std::size_t k = 0; k < list.size(); ++k)
            if (list[k].name() == one.name())
                report.note(times(list[i].name() + " / 1, frame, camera only",
                                  medians[i + 1].camera / medians[k + 1].camera));
    }
}

void compare_silhouettes(Report& report, const SceneSource& source, int low) {
    constexpr std::uint32_t size = 512;
    for (const nicol_shade_at where : {NICOL_SHADE_AT_VERTICES, NICOL_SHADE_AT_PIXELS}) {
        const Recipe one{.low = low, .shade_at = where};
        Recipe four = one;
        four.samples = 4;
        Recipe eight = one;
        eight.samples = 8;
        const std::vector<double> errors = silhouette_errors(source, std::vector{one, four, eight}, size);
        report.note(times("error at outlines, " + four.name() + " / 1", errors[1] / errors[0]));
        report.note(times("error at outlines, " + eight.name() + " / 1", errors[2] / errors[0]));
    }
}

bool at_pixels(const Recipe& recipe) {
    return recipe.shade_at == NICOL_SHADE_AT_PIXELS;
}

// Compares recipes at pixels with their equals at vertices.
void compare_pixels(Report& report, const std::vector<Recipe>& list, const std::vector<FrameTimes>& medians) {
    for (std::size_t p = 0; p < list.size(); ++p) {
        if (!at_pixels(list[p])) continue;
        for (std::size_t v = 0; v < list.size(); ++v) {
            if (at_pixels(list[v]) || list[v].samples != list[p].samples ||
                list[v].method != list[p].method || list[v].high != list[p].high ||
                list[v].low != list[p].low)
                continue;
            report.note(times(list[p].name() + " / at vertices, frame, camera only",
                              medians[p + 1].camera / medians[v + 1].camera));
        }
    }
}

void compare_textures(Report& report, const Options& options, int low, std::uint32_t size) {
    const Recipe recipe{.low = low, .shade_at = NICOL_SHADE_AT_PIXELS};
    const TextureCost cost = texture_cost(options, recipe, size);
    const std::string what =
        "images of albedo, roughness and normals / none, " + recipe.name() + ", frame, camera only";
    report.note(times(what, cost.bilinear));
    report.note(times(what + ", of mipmaps", cost.mipmap));
}

std::vector<Recipe> recipes(const Options& options, const DenseMemory& memory) {
    const int low = options.first_order < 0 ? 4 : options.first_order;
    const int top = options.last_order < 0 ? std::max(9, low) : options.last_order;
    std::vector<Recipe> list;
    for (const High high : {High::none, High::convolution, High::split}) {
        list.push_back({.low = low, .high = high, .top = top});
        // The low and the high orders have separate matrices.
        if (memory.at(low) * (static_cast<double>(high) + 1) <= options.memory)
            list.push_back({.method = NICOL_METHOD_DENSE, .low = low, .high = high, .top = top});
    }
    list.push_back({.low = top});
    for (const High high : {High::none, High::convolution, High::split})
        list.push_back({.low = low, .high = high, .top = top, .shade_at = NICOL_SHADE_AT_PIXELS});
    for (const nicol_shade_at where : {NICOL_SHADE_AT_VERTICES, NICOL_SHADE_AT_PIXELS})
        list.push_back({.low = low, .shade_at = where, .samples = 4});
    return list;
}

}  // namespace

Report bench_frame(const Options& options) {
    const std::uint32_t size = options.size == 0 ? 1024 : options.size;
    const SceneSource source(options);
    const DenseMemory memory(source);
    const std::vector<Recipe> list = recipes(options, memory);
    std::vector<Contestant> contestants;
    contestants.reserve(list.size() + 3);
    contestants.emplace_back(source, floor_recipe(), size);
    for (const Recipe& recipe : list) contestants.emplace_back(source, recipe, size);
    const Recipe low = list.front();
    contestants.emplace_back(source, low, size, SceneVariant::polarized);
    contestants.emplace_back(source, low, size, SceneVariant::unpolarized);
    const std::vector<FrameTimes> medians = time_frames(contestants, options.seconds);

    const double floor = medians[0].camera_draw;
    Report report(
        {"frame after a change of", "ratio to floor", "ms", "relight ms", "shade ms", "draw ms", "kept MB"});
    report.add("floor: one colour", {1, floor, std::nan(""), std::nan(""), floor, std::nan("")});
    for (std::size_t i = 0; i < list.size(); ++i) {
        add_rows(report, list[i].name(), medians[i + 1], floor);
        if (i > 0 && list[i].method == NICOL_METHOD_DENSE)
            compare(report, medians[i + 1], medians[i], list[i - 1].name().substr(9));
    }
    compare_pixels(report, list, medians);
    compare_samples(report, list, medians);
    compare_silhouettes(report, source, low.low);
    compare_textures(report, options, low.low, size);
    const FrameTimes& full = medians[list.size() + 1];
    const FrameTimes& plain = medians[list.size() + 2];
    add_rows(report, low.name() + ", polarized sky on plastic", full, floor);
    add_rows(report, low.name() + ", unpolarized sky on diffuse surfaces", plain, floor);
    report.note(
        times("unpolarized light on diffuse material against full Stokes, relight + shade, light rotating",
              full.light_transfer() / plain.light_transfer()));
    report.note(source.machine() + "; " + std::to_string(size) + " x " + std::to_string(size) + ".");
    return report;
}
