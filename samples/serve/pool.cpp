// SPDX-License-Identifier: MIT
#include "pool.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <thread>
#include <utility>

#include "common/failure.hpp"

namespace {

using Clock = std::chrono::steady_clock;

constexpr Seconds kFirstPause(0.25), kLongestPause(30);
/// A worker that ran this long has started successfully.
constexpr Seconds kSettled(10);

std::size_t worker_count(const Options& options) {
    return options.workers > 0 ? options.workers : std::max(1u, std::thread::hardware_concurrency());
}

void say(const std::string& text) {
    std::fprintf(stderr, "nicol-serve: %s\n", text.c_str());
}

}  // namespace

Pool::Pool(boost::asio::io_context& io, const Options& options, std::vector<std::string> arguments,
           Metrics& metrics)
    : io_(io),
      options_(options),
      arguments_(std::move(arguments)),
      metrics_(metrics),
      dispatcher_(options.queue, {.start =
                                      [this](int worker, std::uint64_t job, const ImageRequest& request) {
                                          begin_job(static_cast<std::size_t>(worker), job, request);
                                      },
                                  .cancel =
                                      [this](int worker, std::uint64_t job) {
                                          ++metrics_.cancelled;
                                          slots_[static_cast<std::size_t>(worker)]->process->send(
                                              {.kind = MessageKind::cancel, .length = 0, .job = job}, {});
                                      }}),
      child_ended_(io, SIGCHLD) {
    for (std::size_t i = 0; i < worker_count(options); ++i) slots_.push_back(std::make_unique<Slot>(io));
    wait_for_children();
}

Pool::~Pool() {
    for (const pid_t pid : ended_) ::waitpid(pid, nullptr, 0);
}

void Pool::start(std::function<void(const std::string&)> failed) {
    failed_ = std::move(failed);
    launch(0);
}

void Pool::stop() {
    stopped_ = true;
    for (const auto& slot : slots_) {
        slot->timer.cancel();
        if (slot->process) ended_.push_back(slot->process->kill());
    }
    std::erase(ended_, -1);
    child_ended_.cancel();
}

std::size_t Pool::warm_workers() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(slots_, [](const auto& slot) { return slot->warm && !slot->stale; }));
}

std::vector<WorkerState> Pool::states() const {
    std::vector<WorkerState> states;
    for (const auto& slot : slots_) {
        const pid_t pid = slot->process ? slot->process->pid() : 0;
        const char* state = !slot->process ? "waiting"
                            : !slot->warm  ? "starting"
                            : slot->busy   ? "busy"
                                           : "idle";
        states.push_back({.pid = pid, .state = state, .resident_bytes = pid > 0 ? resident_bytes(pid) : 0});
    }
    return states;
}

void Pool::launch(std::size_t index) {
    Slot& slot = *slots_[index];
    slot.warm = slot.busy = slot.stale = false;
    try {
        slot.process = WorkerProcess::start(
            io_, arguments_,
            {.message = [this, index](const Head& head,
                                      std::string content) { receive(index, head, std::move(content)); },
             .lost = [this, index] { lose(index, false); }});
        limit(index, options_.start_limit);
    } catch (const Failure& failure) {
        say(failure.what());
        ++slot.failures;
        pause(index);
    }
}

void Pool::receive(std::size_t index, const Head& head, std::string content) {
    if (head.kind == MessageKind::hello) return receive_hello(index, content);
    if (head.kind == MessageKind::result) return receive_result(index, head, std::move(content));
    // Without any worker ever having been warm there is nothing to go on with.
    if (!hello_ && failed_) return failed_(content);
    say("a worker cannot start: " + content);
}

void Pool::receive_hello(std::size_t index, const std::string& content) {
    Hello hello;
    if (!unpack(content, hello)) return lose(index, false);
    Slot& slot = *slots_[index];
    slot.timer.cancel();
    slot.warm = true;
    slot.warm_since = Clock::now();
    const bool first = !hello_;
    if (hello_ && *hello_ != hello) {
        say("the scenes have changed; all workers are replaced");
        for (std::size_t i = 0; i < slots_.size(); ++i)
            if (i != index && slots_[i]->warm) slots_[i]->stale = true;
        hello_ = std::move(hello);
        dispatcher_.begin_generation();
        if (scenes_changed) scenes_changed();
        for (std::size_t i = 0; i < slots_.size(); ++i)
            if (slots_[i]->stale && !slots_[i]->busy) lose(i, false);
    } else {
        hello_ = std::move(hello);
    }
    dispatcher_.worker_idle(static_cast<int>(index));
    if (!first) return;
    if (warm) warm();
    for (std::size_t i = 1; i < slots_.size(); ++i) launch(i);
}

void Pool::receive_result(std::size_t index, const Head& head, std::string content) {
    Slot& slot = *slots_[index];
    std::string_view rest = content;
    const auto answer = std::make_shared<Answer>();
    if (!slot.busy || !take(rest, answer->head)) return lose(index, false);
    content.erase(0, sizeof answer->head);
    answer->content = std::move(content);
    slot.timer.cancel();
    slot.busy = false;
    if (answer->head.status == 200) metrics_.rendered(answer->head);
    dispatcher_.worker_done(static_cast<int>(index), head.job, answer);
    if (slot.stale) return lose(index, false);
    dispatcher_.worker_idle(static_cast<int>(index));
}

void Pool::lose(std::size_t index, bool hung) {
    Slot& slot = *slots_[index];
    if (stopped_ || !slot.process) return;
    const bool early = !slot.warm || Clock::now() - slot.warm_since < kSettled;
    if (!slot.stale) {
        ++(hung ? metrics_.hung : metrics_.crashed);
        say(std::string("a worker ") + (hung ? "hung" : "crashed") + " and is replaced");
    }
    slot.failures = early && !slot.stale ? slot.failures + 1 : 0;
    slot.timer.cancel();
    ended_.push_back(slot.process->kill());
    slot.process.reset();
    reap();
    const bool was_warm = std::exchange(slot.warm, false);
    slot.busy = false;
    if (was_warm) dispatcher_.worker_lost(static_cast<int>(index));
    if (slot.failures <= 1)
        launch(index);
    else
        pause(index);
}

void Pool::pause(std::size_t index) {
    Slot& slot = *slots_[index];
    slot.process.reset();
    const Seconds time =
        std::min(kLongestPause, kFirstPause * static_cast<double>(1u << std::min(slot.failures, 10u)));
    slot.timer.expires_after(std::chrono::duration_cast<Clock::duration>(time));
    slot.timer.async_wait([this, index](const boost::system::error_code& error) {
        if (!error && !stopped_) launch(index);
    });
}

void Pool::limit(std::size_t index, Seconds time) {
    Slot& slot = *slots_[index];
    slot.timer.expires_after(std::chrono::duration_cast<Clock::duration>(time));
    const std::weak_ptr<WorkerProcess> process = slot.process;
    slot.timer.async_wait([this, index, process](const boost::system::error_code& error) {
        // A timer that had expired when it was cancelled still comes here.
        const Slot& now = *slots_[index];
        const bool same = now.process && now.process == process.lock();
        if (!error && same && now.timer.expiry() <= Clock::now() && (now.busy || !now.warm))
            lose(index, true);
    });
}

void Pool::begin_job(std::size_t index, std::uint64_t job, const ImageRequest& request) {
    Slot& slot = *slots_[index];
    slot.busy = true;
    limit(index, options_.render_limit);
    const std::string_view content = bytes_of(request);
    slot.process->send(
        {.kind = MessageKind::job, .length = static_cast<std::uint32_t>(content.size()), .job = job},
        content);
}

void Pool::wait_for_children() {
    child_ended_.async_wait([this](const boost::system::error_code& error, int) {
        if (error) return;
        reap();
        wait_for_children();
    });
}

void Pool::reap() {
    std::erase_if(ended_, [](pid_t pid) { return ::waitpid(pid, nullptr, WNOHANG) != 0; });
}
