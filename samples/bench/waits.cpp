// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "commands.hpp"
#include "entry_points.hpp"
#include "guest.hpp"
#include "temporary_folder.hpp"

namespace {

constexpr int kJobs = 3;
constexpr int kRoundsAlone = 3;
// One thread makes a call's own loops run on the calling thread. With more, a call that waits for the last of
// its threads, which the job's threads keep from a processor, looks as if it waited for the job.
constexpr std::uint32_t kThreads = 1;

/// Longest times of a function, in milliseconds.
struct Longest {
    double all = 0;
    /// Time in which the calling thread neither ran nor waited for a processor: it waited for the job or for
    /// OpenGL.
    double blocked = 0;
};
using LongestTimes = std::map<std::string, Longest>;

double milliseconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

/// Returns how long the thread has waited for a processor, 0 where the system does not count it.
double queued_milliseconds() {
    std::ifstream file("/proc/thread-self/schedstat");
    std::uint64_t ran = 0, queued = 0;
    file >> ran >> queued;
    return static_cast<double>(queued) / 1e6;
}

EntryPoints::Watch stopwatch_of(LongestTimes& longest) {
    return [&longest](const char* name, const std::function<void()>& call) {
        const double queued = queued_milliseconds();
        const double ran = milliseconds(CLOCK_THREAD_CPUTIME_ID);
        const double start = milliseconds(CLOCK_MONOTONIC);
        call();
        const double all = milliseconds(CLOCK_MONOTONIC) - start;
        const double busy = milliseconds(CLOCK_THREAD_CPUTIME_ID) - ran + queued_milliseconds() - queued;
        Longest& most = longest[name];
        most.all = std::max(most.all, all);
        most.blocked = std::max(most.blocked, all - busy);
    };
}

/// Submits jobs that bake a scene from nothing, and calls everything until each is done, then what reads its
/// image.
LongestTimes during_jobs(const Guest& guest, EntryPoints& points, const Options& options,
                         LongestTimes& alone) {
    LongestTimes longest;
    const EntryPoints::Watch watch = stopwatch_of(longest);
    for (int i = 0; i < kJobs; ++i) {
        const auto scene = create<Scene>(
            nicol_scene_load, guest.context.get(),
            options.scene.empty() ? NICOL_BENCH_ASSETS "/snail_hdr.xml" : options.scene.c_str(), nullptr, 0U);
        auto camera = nicol::defaults(nicol_camera_init);
        check(nicol_scene_get_camera(scene.get(), &camera));
        const std::uint32_t size = options.size == 0 ? 256 : options.size;
        const auto framebuffer =
            create<Framebuffer>(nicol_framebuffer_create, guest.context.get(), size, size, 3U);
        auto render = nicol::defaults(nicol_render_options_init);
        render.bake_directions = 8192;
        const auto job =
            create<nicol::Job>(nicol_render_async, scene.get(), &camera, &render, framebuffer.get());
        auto status = nicol::defaults(nicol_job_status_init);
        while (status.state != NICOL_JOB_DONE) {
            points.reads(watch, framebuffer.get());
            points.all(watch, guest.texture);
            check(nicol_job_poll(job.get(), &status));
        }
        check(status.result);
        points.reads(stopwatch_of(alone), framebuffer.get());
    }
    return longest;
}

}  // namespace

Report bench_waits(const Options& options) {
    Report report({"longest time of a call", "alone, ms", "blocked", "a job runs, ms", "blocked",
                   "in a host, alone, ms", "blocked", "a job runs, ms", "blocked"});
    std::vector<LongestTimes> columns;
    for (const bool in_host : {false, true}) {
        const Guest guest = in_host ? Guest::in_host(kThreads) : Guest::own(options.backend, kThreads);
        const TemporaryFolder folder;
        EntryPoints points(guest.context.get(), folder.path());
        LongestTimes alone;
        points.all([](const char*, const auto& call) { call(); }, guest.texture);
        for (int round = 0; round < kRoundsAlone; ++round) points.all(stopwatch_of(alone), guest.texture);
        LongestTimes beside = during_jobs(guest, points, options, alone);
        columns.push_back(std::move(alone));
        columns.push_back(std::move(beside));
    }
    for (const auto& [name, time] : columns.back()) {
        std::vector<double> row;
        row.reserve(2 * columns.size());
        for (const LongestTimes& column : columns) {
            const auto found = column.find(name);
            const bool there = found != column.end();
            row.push_back(there ? found->second.all : std::nan(""));
            row.push_back(there ? found->second.blocked : std::nan(""));
        }
        report.add(name, row);
    }
    report.note(
        std::to_string(kJobs) +
        " jobs render the scene for the first time, with 8192 directions. The context has one thread, so "
        "that calls do not wait for their own loops. Blocked: ms in which the calling thread neither ran nor "
        "waited for a processor. A call that is blocked alone waits for its own work in OpenGL.");
    return report;
}
