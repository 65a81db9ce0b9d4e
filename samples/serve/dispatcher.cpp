// SPDX-License-Identifier: MIT
#include "dispatcher.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace {

constexpr const char* kOutdated = "The scenes have changed since the request came.";

AnswerPtr unavailable(const char* why) {
    auto answer = std::make_shared<Answer>();
    answer->head.status = 503;
    answer->content = why;
    return answer;
}

}  // namespace

Dispatcher::Dispatcher(std::size_t queue_limit, Workers workers)
    : queue_limit_(queue_limit), workers_(std::move(workers)) {}

std::optional<Dispatcher::Ticket> Dispatcher::submit(const std::string& key, const ImageRequest& request,
                                                     Done done, Progressed progressed) {
    if (const auto known = by_key_.find(key); known != by_key_.end()) {
        const JobPtr& job = known->second;
        job->waiters.emplace(++last_id_, Waiter{std::move(done), std::move(progressed)});
        return Ticket{.job = job->id, .waiter = last_id_, .joined = true};
    }
    // An idle worker takes the job at once; otherwise the job is queued.
    if (queue_.size() >= queue_limit_ && !worker_for(request)) return std::nullopt;
    const auto job = std::make_shared<Job>();
    job->id = ++last_id_;
    job->key = key;
    job->request = request;
    job->generation = generation_;
    job->waiters.emplace(++last_id_, Waiter{std::move(done), std::move(progressed)});
    by_key_.emplace(key, job);
    by_id_.emplace(job->id, job);
    queue_.push_back(job);
    const Ticket ticket{.job = job->id, .waiter = last_id_, .joined = false};
    dispatch();
    return ticket;
}

void Dispatcher::leave(const Ticket& ticket) {
    const auto found = by_id_.find(ticket.job);
    if (found == by_id_.end()) return;
    const JobPtr job = found->second;
    job->waiters.erase(ticket.waiter);
    if (!job->waiters.empty()) return;
    forget(*job);
    if (job->worker < 0)
        std::erase(queue_, job);
    else
        workers_.cancel(job->worker, job->id);
}

void Dispatcher::worker_idle(int worker) {
    idle_.insert(worker);
    dispatch();
}

void Dispatcher::worker_progress(int worker, std::uint64_t id, const RenderProgress& progress) {
    const auto found = running_.find(worker);
    if (found == running_.end() || found->second->id != id) return;
    // A callback may leave, which must not invalidate the list.
    const JobPtr job = found->second;
    std::vector<Progressed> all;
    for (const auto& [waiter, entry] : job->waiters)
        if (entry.progressed) all.push_back(entry.progressed);
    for (const Progressed& progressed : all) progressed(progress);
}

void Dispatcher::worker_done(int worker, std::uint64_t id, const AnswerPtr& answer) {
    const auto found = running_.find(worker);
    if (found == running_.end() || found->second->id != id) return;
    const JobPtr job = found->second;
    running_.erase(found);
    finish(job, answer);
}

void Dispatcher::worker_lost(int worker) {
    idle_.erase(worker);
    last_view_.erase(worker);
    const auto found = running_.find(worker);
    if (found == running_.end()) return;
    const JobPtr job = found->second;
    running_.erase(found);
    job->worker = -1;
    if (job->waiters.empty()) return;
    if (job->generation != generation_ || job->retired) return finish(job, unavailable(kOutdated));
    if (job->attempts >= 2) return finish(job, unavailable("The renderer failed on this request twice."));
    queue_.push_front(job);
    dispatch();
}

void Dispatcher::begin_generation() {
    ++generation_;
    by_key_.clear();
    for (const JobPtr& job : std::exchange(queue_, {})) finish(job, unavailable(kOutdated));
}

void Dispatcher::retire_scene(std::uint32_t scene) {
    for (const auto& [worker, job] : running_)
        if (job->request.view.scene == scene) job->retired = true;
    // Workers no longer hold these views.
    std::erase_if(last_view_, [&](const auto& entry) { return entry.second.scene == scene; });
    refuse_scene(scene);
}

void Dispatcher::refuse_scene(std::uint32_t scene) {
    std::deque<JobPtr> of_scene;
    std::erase_if(queue_, [&](const JobPtr& job) {
        if (job->request.view.scene != scene) return false;
        of_scene.push_back(job);
        return true;
    });
    for (const JobPtr& job : of_scene) finish(job, unavailable("This scene is still being prepared."));
}

/// Returns an idle worker that can render the request, preferably one that rendered its view last and still
/// has it.
std::optional<int> Dispatcher::worker_for(const ImageRequest& request) const {
    std::optional<int> found;
    for (const int worker : idle_) {
        if (workers_.can && !workers_.can(worker, request)) continue;
        const auto last = last_view_.find(worker);
        if (last != last_view_.end() && last->second == request.view) return worker;
        if (!found) found = worker;
    }
    return found;
}

void Dispatcher::dispatch() {
    for (std::size_t at = 0; at < queue_.size() && !idle_.empty();) {
        const JobPtr job = queue_[at];
        const std::optional<int> worker = worker_for(job->request);
        if (!worker) {
            ++at;
            continue;
        }
        queue_.erase(queue_.begin() + static_cast<std::ptrdiff_t>(at));
        idle_.erase(*worker);
        last_view_[*worker] = job->request.view;
        job->worker = *worker;
        ++job->attempts;
        running_[*worker] = job;
        workers_.start(*worker, job->id, job->request);
    }
}

void Dispatcher::forget(const Job& job) {
    if (const auto found = by_key_.find(job.key); found != by_key_.end() && found->second->id == job.id)
        by_key_.erase(found);
    by_id_.erase(job.id);
}

void Dispatcher::finish(const JobPtr& job, const AnswerPtr& answer) {
    forget(*job);
    // A callback may submit again, which must not invalidate the list.
    for (auto& [waiter, entry] : std::exchange(job->waiters, {})) entry.done(answer);
}
