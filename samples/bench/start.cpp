// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "image.hpp"
#include "median.hpp"
#include "stage.hpp"
#include "start_scenes.hpp"

namespace {

// Returns "ok" and the numbers, or "no" and the message.
std::string answer(const std::function<std::vector<double>()>& measure) {
    try {
        std::string text = "ok";
        for (const double value : measure()) text += ' ' + std::to_string(value);
        return text;
    } catch (const std::exception& error) {
        return std::string("no") + error.what();
    }
}

std::string read_all(int file) {
    std::string text;
    char block[4096];
    for (ssize_t got = 0; (got = ::read(file, block, sizeof block)) > 0;)
        text.append(block, static_cast<std::size_t>(got));
    return text;
}

void write_all(int file, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t wrote = ::write(file, text.data() + done, text.size() - done);
        if (wrote <= 0) return;
        done += static_cast<std::size_t>(wrote);
    }
}

/// Returns the result of `measure` in a fork of this process, where caches are cold. This process must not
/// have started threads. Throws std::runtime_error with the message of the exception of `measure`.
std::vector<double> in_child(const std::function<std::vector<double>()>& measure) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot start a process");
    if (child == 0) {
        write_all(ends[1], answer(measure));
        ::_exit(0);
    }
    ::close(ends[1]);
    const std::string text = read_all(ends[0]);
    ::close(ends[0]);
    ::waitpid(child, nullptr, 0);
    if (text.size() < 2 || text.substr(0, 2) != "ok")
        throw std::runtime_error(text.size() < 2 ? "a measuring process died" : text.substr(2));
    std::vector<double> numbers;
    const char* at = text.c_str() + 2;
    while (*at == ' ') {
        char* end = nullptr;
        numbers.push_back(std::strtod(at, &end));
        at = end;
    }
    return numbers;
}

// Returns the milliseconds of each step, which form a row of the report.
std::vector<double> first_image(const Options& options, const Recipe& recipe, std::uint32_t size) {
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
    const nicol_statistics statistics = stage.render(recipe.options(), framebuffer.get());
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
    constexpr const char* empty = "empty cache folder";
    constexpr const char* warm = "warm cache folder";
    const std::uint32_t size = options.size == 0 ? 1024 : options.size;
    const Recipe recipe{.high = High::split};
    const auto wanted = [&](const std::string& name) { return name.find(options.only) != std::string::npos; };
    Report report({"first image, ms", "whole", "context", "files", "render", "of it project", "of it bake",
                   "read back"});
    std::vector<std::vector<double>> of_empty, of_warm;
    for (int i = 0; (wanted(empty) || wanted(warm)) && i < repetitions; ++i) {
        const TemporaryFolder folder;
        Options with_cache = options;
        with_cache.cache = folder.path().string();
        const auto measure = [&] { return first_image(with_cache, recipe, size); };
        of_empty.push_back(in_child(measure));
        of_warm.push_back(in_child(measure));
    }
    if (wanted(empty)) report.add(empty, medians(of_empty));
    if (wanted(warm)) report.add(warm, medians(of_warm));
    const TemporaryFolder scenes;
    for (const StartScene& scene : write_start_scenes(scenes.path())) {
        if (!wanted(scene.name)) continue;
        const TemporaryFolder folder;
        Options of_scene = options;
        of_scene.scene = scene.file;
        of_scene.cache = folder.path().string();
        report.add(scene.name, in_child([&] { return first_image(of_scene, scene.recipe, scene.size); }));
    }
    report.note(
        "The first two rows: medians of " + std::to_string(repetitions) + " processes each, alternating; " +
        std::to_string(size) + " x " + std::to_string(size) +
        ". The others: one process each with an empty cache folder, 192 x 192 (the thirty 224 x 224); "
        "materials are projected to order 16 and split to 64. What the OpenGL driver keeps on disk is warm.");
    return report;
}
