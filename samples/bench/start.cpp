// SPDX-License-Identifier: MIT
#include "start.hpp"

#include <chrono>

#include "child.hpp"
#include "image.hpp"
#include "median.hpp"
#include "stage.hpp"

namespace {

// Milliseconds of each step; the numbers of a row of the report.
std::vector<double> first_image(const Options& options, std::uint32_t size) {
    using Clock = std::chrono::steady_clock;
    auto step = [last = Clock::now()]() mutable {
        const auto now = Clock::now();
        const double milliseconds = std::chrono::duration<double, std::milli>(now - last).count();
        last = now;
        return milliseconds;
    };
    const SceneSource source(options);
    const double opened = step();
    const Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(size, size);
    const double loaded = step();
    const nicol_statistics statistics =
        stage.render(Recipe{.high = High::split}.options(), framebuffer.get());
    const double rendered = step();
    static_cast<void>(read_image(framebuffer.get()));
    const double read = step();
    return {opened + loaded + rendered + read,
            opened,
            loaded,
            rendered,
            statistics.project_ms,
            statistics.bake_ms,
            read};
}

std::vector<double> medians(const std::vector<std::vector<double>>& rows) {
    std::vector<double> out;
    for (std::size_t i = 0; i < rows.front().size(); ++i) {
        std::vector<double> column;
        for (const std::vector<double>& row : rows) column.push_back(row[i]);
        out.push_back(median(std::move(column)));
    }
    return out;
}

}  // namespace

Report bench_start(const Options& options) {
    constexpr int repetitions = 5;
    const std::uint32_t size = options.size == 0 ? 1024 : options.size;
    std::vector<std::vector<double>> cold, warm;
    for (int i = 0; i < repetitions; ++i) {
        const TemporaryFolder folder;
        Options with_cache = options;
        with_cache.cache = folder.path().string();
        const auto measure = [&] { return first_image(with_cache, size); };
        cold.push_back(in_child(measure));
        warm.push_back(in_child(measure));
    }
    Report report({"first image, ms", "whole", "context", "files", "render", "of it project", "of it bake",
                   "read back"});
    report.add("empty cache folder", medians(cold));
    report.add("warm cache folder", medians(warm));
    report.note("Medians of " + std::to_string(repetitions) + " processes each, alternating; " +
                std::to_string(size) + " x " + std::to_string(size) +
                ". What the OpenGL driver keeps on disk is warm in both.");
    return report;
}
