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
/// Uptime after which a worker's start counts as successful.
constexpr Seconds kSettled(10);

std::size_t worker_count(const Options& options) {
    return options.workers > 0 ? options.workers : std::max(1u, std::thread::hardware_concurrency());
}

Clock::duration pause_after(unsigned failures) {
    const Seconds time =
        std::min(kLongestPause, kFirstPause * static_cast<double>(1u << std::min(failures, 10u)));
    return std::chrono::duration_cast<Clock::duration>(time);
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
                                      },
                                  .can =
                                      [this](int worker, const ImageRequest& request) {
                                          return loads_.has(static_cast<std::size_t>(worker),
                                                            request.view.scene);
                                      }}),
      loads_(worker_count(options) + 1),
      places_(options.uploads ? options.upload_places : 0),
      child_ended_(io, SIGCHLD) {
    for (std::size_t i = 0; i <= worker_count(options); ++i) slots_.push_back(std::make_unique<Slot>(io));
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
    std::size_t count = 0;
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (slots_[i]->process && !slots_[i]->stale && loads_.serves(i)) ++count;
    return count;
}

std::vector<WorkerState> Pool::states() const {
    std::vector<WorkerState> states;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        const Slot& slot = *slots_[i];
        if (!slot.process && i == loads_.spare()) continue;
        const pid_t pid = slot.process ? slot.process->pid() : 0;
        const char* state = !slot.process                   ? "waiting"
                            : i == loads_.spare()           ? "spare"
                            : slot.loading || !slot.greeted ? "starting"
                            : slot.busy                     ? "busy"
                                                            : "idle";
        states.push_back({.pid = pid, .state = state, .resident_bytes = pid > 0 ? resident_bytes(pid) : 0});
    }
    return states;
}

void Pool::launch(std::size_t index) {
    Slot& slot = *slots_[index];
    slot.greeted = slot.busy = slot.stale = false;
    slot.loading.reset();
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
    if (head.kind == MessageKind::loaded) return receive_loaded(index, head.job, content);
    if (head.kind == MessageKind::progress) return receive_progress(index, head.job, content);
    if (head.kind == MessageKind::result) return receive_result(index, head, std::move(content));
    // Before any worker has started, the service cannot continue.
    if (loads_.scenes().empty()) return failed_(content);
    say("a worker cannot start: " + content);
}

void Pool::receive_hello(std::size_t index, const std::string& content) {
    Hello hello;
    if (!unpack(content, hello)) return lose(index, false);
    Slot& slot = *slots_[index];
    slot.timer.cancel();
    slot.greeted = true;
    slot.since = Clock::now();
    if (hello_ != hello) {
        const bool first = hello_ == Hello();
        hello_ = std::move(hello);
        begin_scenes();
        if (!first) {
            say("the scenes have changed; all workers are replaced");
            for (std::size_t i = 0; i < slots_.size(); ++i)
                if (i != index && slots_[i]->greeted) slots_[i]->stale = true;
            dispatcher_.begin_generation();
            if (scenes_changed) scenes_changed();
            for (std::size_t i = 0; i < slots_.size(); ++i)
                if (slots_[i]->stale && !slots_[i]->busy) lose(i, false);
        }
    }
    go_on(index);
}

void Pool::receive_progress(std::size_t index, std::uint64_t job, const std::string& content) {
    std::string_view rest = content;
    RenderProgress progress;
    if (!take(rest, progress) || progress.verb >= kVerbs.size()) return lose(index, false);
    dispatcher_.worker_progress(static_cast<int>(index), job, progress);
}

void Pool::receive_loaded(std::size_t index, std::size_t scene, const std::string& content) {
    Slot& slot = *slots_[index];
    Loaded loaded;
    if (slot.loading != scene || !unpack(content, loaded)) return lose(index, false);
    slot.timer.cancel();
    slot.loading.reset();
    const bool changed = loads_.report(index, scene, loaded.info, loaded.reason);
    if (through_ && !loaded.reason.empty()) say("a scene is left out: " + loaded.reason);
    if (changed) {
        say("the scene " + loaded.info.id + " has changed; all workers load it again");
        dispatcher_.begin_generation();
        if (scenes_changed) scenes_changed();
    }
    go_on(index);
    if (changed) go_on_all();
}

/// Continues a free worker: it loads a missing scene or renders. Loading and rendering alternate, so that
/// neither waits for all of the other.
void Pool::go_on(std::size_t index, bool rendered) {
    Slot& slot = *slots_[index];
    if (!slot.process || !slot.greeted || slot.stale || slot.busy || slot.loading) return;
    const std::optional<std::size_t> next = loads_.next(index, Clock::now());
    const auto worker = static_cast<int>(index);
    if (index != loads_.spare() && (!next || !rendered)) dispatcher_.worker_idle(worker);
    if (next && !slot.busy) {
        dispatcher_.worker_away(worker);
        return begin_load(index, *next);
    }
    if (index == loads_.spare()) return promote();
    if (!next) settle();
    tend_spare();
}

void Pool::go_on_all() {
    for (std::size_t i = 0; i < slots_.size(); ++i) go_on(i);
}

/// Starts the other workers after the first one has loaded all scenes that load quickly, if there is anything
/// to serve.
void Pool::settle() {
    if (through_) return;
    const auto& scenes = loads_.scenes();
    const auto count = [&](SceneLoads::Condition wanted) {
        std::size_t found = 0;
        for (std::size_t i = 0; i < scenes.size(); ++i) found += loads_.condition(i) == wanted ? 1 : 0;
        return found;
    };
    const auto failed = std::ranges::find_if(scenes, [](const auto& scene) { return !scene.reason.empty(); });
    if (count(SceneLoads::Condition::broken) + count(SceneLoads::Condition::vacant) == scenes.size() &&
        failed != scenes.end())
        return failed_(failed->reason);
    if (count(SceneLoads::Condition::ready) == 0) return;
    through_ = true;
    for (const auto& scene : scenes)
        if (!scene.reason.empty()) say("a scene is left out: " + scene.reason);
    if (warm) warm();
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (i != loads_.spare() && !slots_[i]->process) launch(i);
}

/// Ends the spare worker after it has loaded all that it can, or puts it into the place of a worker that
/// lacks a scene.
void Pool::promote() {
    const std::size_t spare = loads_.spare();
    const std::optional<std::size_t> place = loads_.replaceable();
    if (place && slots_[*place]->busy) return;  // after its result
    if (!place) {
        end(spare);
        settle();
    } else {
        end(*place);
        loads_.exchange(*place);
        go_on(spare);
    }
    tend_spare();
}

/// Starts the spare worker if there is something to load that the other workers leave to it.
void Pool::tend_spare() {
    const std::size_t spare = loads_.spare();
    Slot& slot = *slots_[spare];
    const std::optional<Clock::time_point> due = loads_.spare_due();
    if (stopped_ || slot.process || !due) return;
    if (*due <= Clock::now()) return launch(spare);
    slot.timer.expires_at(*due);
    slot.timer.async_wait([this, spare](const boost::system::error_code& error) {
        if (!error && spare == loads_.spare()) tend_spare();
    });
}

/// Handles a worker that took too long.
void Pool::overdue(std::size_t index) {
    Slot& slot = *slots_[index];
    const std::size_t spare = loads_.spare();
    if (!slot.loading || index == spare || Clock::now() - slot.load_since >= options_.start_limit)
        return lose(index, true);
    // While the spare worker is busy with another scene, a worker that has nothing to serve continues its
    // load.
    if (slots_[spare]->process && !loads_.serves(index)) return limit(index, options_.start_limit);
    loads_.set_aside(*slot.loading);
    say("the scene " + loads_.scenes()[*slot.loading].info.id + " takes long to load; the others are served");
    if (slots_[spare]->process) {
        end(index);
        return launch(index);
    }
    // The worker continues as the spare worker.
    loads_.exchange(index);
    slots_[spare]->timer.cancel();
    limit(index, options_.start_limit);
    launch(spare);
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
    go_on(loads_.spare());  // the spare worker may wait for this place
    go_on(index, true);
}

void Pool::lose(std::size_t index, bool hung) {
    Slot& slot = *slots_[index];
    if (stopped_ || !slot.process) return;
    const bool early = !slot.greeted || slot.loading || Clock::now() - slot.since < kSettled;
    slot.failures = early && !slot.stale ? slot.failures + 1 : 0;
    if (!slot.stale) {
        ++(hung ? metrics_.hung : metrics_.crashed);
        say(std::string("a worker ") + (hung ? "hung" : "crashed") + " and is replaced");
    }
    if (slot.loading && !slot.stale) {
        const auto& scene = loads_.scenes()[*slot.loading];
        say("it was loading the scene " + scene.info.id);
        loads_.blame(*slot.loading, Clock::now() + pause_after(scene.failures + 1));
        if (is_upload(*slot.loading) && scene.failures > 1)
            loads_.give_up(*slot.loading, "Its load ended the processes that tried it.");
    }
    end(index);
    if (index == loads_.spare()) return tend_spare();
    if (slot.failures <= 1)
        launch(index);
    else
        pause(index);
}

/// Ends the worker's process. Another worker takes over its job.
void Pool::end(std::size_t index) {
    Slot& slot = *slots_[index];
    slot.timer.cancel();
    if (slot.process) ended_.push_back(slot.process->kill());
    slot.process.reset();
    slot.greeted = slot.busy = false;
    slot.loading.reset();
    loads_.forget(index);
    reap();
    dispatcher_.worker_lost(static_cast<int>(index));
    for (std::size_t i = 0; i < loads_.scenes().size(); ++i)
        if (loads_.condition(i) != SceneLoads::Condition::ready)
            dispatcher_.refuse_scene(static_cast<std::uint32_t>(i));
}

void Pool::pause(std::size_t index) {
    Slot& slot = *slots_[index];
    slot.process.reset();
    slot.timer.expires_after(pause_after(slot.failures));
    slot.timer.async_wait([this, index](const boost::system::error_code& error) {
        if (!error && !stopped_ && !slots_[index]->process) launch(index);
    });
}

void Pool::limit(std::size_t index, Seconds time) {
    Slot& slot = *slots_[index];
    slot.timer.expires_after(std::chrono::duration_cast<Clock::duration>(time));
    const std::weak_ptr<WorkerProcess> process = slot.process;
    slot.timer.async_wait([this, index, process](const boost::system::error_code& error) {
        // A timer that expired before its cancellation still calls this.
        const Slot& now = *slots_[index];
        const bool same = now.process && now.process == process.lock();
        if (!error && same && now.timer.expiry() <= Clock::now() && (now.busy || now.loading || !now.greeted))
            overdue(index);
    });
}

void Pool::begin_load(std::size_t index, std::size_t scene) {
    Slot& slot = *slots_[index];
    slot.loading = scene;
    slot.load_since = Clock::now();
    // A single scene delays no other scene.
    const bool alone = hello_.scenes.size() + places_.size() == 1 || index == loads_.spare();
    limit(index, alone ? options_.start_limit : options_.slow_scene);
    const std::string_view content = is_upload(scene)
                                         ? std::string_view(places_[scene - hello_.scenes.size()].content)
                                         : std::string_view();
    slot.process->send(
        {.kind = MessageKind::load, .length = static_cast<std::uint32_t>(content.size()), .job = scene},
        content);
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
