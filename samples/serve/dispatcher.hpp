// SPDX-License-Identifier: MIT
// Assignment of requests to workers: a bounded queue, one job for equal requests, retries. The dispatcher has
// no sockets and no clocks: it receives events and sends commands to workers.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "image_request.hpp"
#include "message.hpp"

/// The answer that all requests of a job share.
struct Answer {
    ResultHead head;
    std::string content;  ///< image, or description of the failure
};
using AnswerPtr = std::shared_ptr<const Answer>;

class Dispatcher {
public:
    struct Workers {
        std::function<void(int worker, std::uint64_t job, const ImageRequest&)> start;
        std::function<void(int worker, std::uint64_t job)> cancel;
        /// Returns whether the worker can render this request. Unset: every worker can.
        std::function<bool(int worker, const ImageRequest&)> can = {};
    };
    using Done = std::function<void(const AnswerPtr&)>;
    using Progressed = std::function<void(const RenderProgress&)>;
    struct Ticket {
        std::uint64_t job = 0, waiter = 0;
        bool joined = false;  ///< an equal request was under way
    };

    Dispatcher(std::size_t queue_limit, Workers workers);

    /// Adds a request. `key` is equal for equal requests. Returns nothing if the queue is full. `done` is
    /// called once, later, unless leave() is called first; `progressed`, which may be empty, any number of
    /// times before.
    std::optional<Ticket> submit(const std::string& key, const ImageRequest& request, Done done,
                                 Progressed progressed = {});
    /// Removes a client that left. Without other clients the job leaves the queue or is cancelled.
    void leave(const Ticket& ticket);

    /// Marks the worker as idle: it takes a job now or later.
    void worker_idle(int worker);
    /// Marks the worker as busy with other work until worker_idle().
    void worker_away(int worker) { idle_.erase(worker); }
    /// Tells all waiting requests of a job how far it is.
    void worker_progress(int worker, std::uint64_t job, const RenderProgress& progress);
    /// Answers all waiting requests. The worker gets no other job before worker_idle().
    void worker_done(int worker, std::uint64_t job, const AnswerPtr& answer);
    /// Handles a worker that crashed or was killed: its job is retried once by another worker, and then
    /// answered 503.
    void worker_lost(int worker);
    /// Answers all queued requests for the scene 503, because no worker has it any more.
    void refuse_scene(std::uint32_t scene);
    /// Marks earlier requests for the scene as outdated, as begin_generation() does for all.
    void retire_scene(std::uint32_t scene);
    /// Marks earlier requests as outdated: queued ones are answered 503, running ones are not retried.
    void begin_generation();

    [[nodiscard]] std::size_t queued() const { return queue_.size(); }
    [[nodiscard]] std::size_t running() const { return running_.size(); }

private:
    struct Waiter {
        Done done;
        Progressed progressed;
    };
    struct Job {
        std::uint64_t id = 0;
        std::string key;
        ImageRequest request;
        std::uint64_t generation = 0;
        int attempts = 0;
        int worker = -1;       ///< -1: in the queue
        bool retired = false;  ///< not tried again
        std::map<std::uint64_t, Waiter> waiters;
    };
    using JobPtr = std::shared_ptr<Job>;

    void dispatch();
    [[nodiscard]] std::optional<int> worker_for(const ImageRequest& request) const;
    void forget(const Job& job);
    void finish(const JobPtr& job, const AnswerPtr& answer);

    std::size_t queue_limit_;
    Workers workers_;
    std::uint64_t last_id_ = 0, generation_ = 0;
    std::deque<JobPtr> queue_;
    std::map<int, JobPtr> running_;          ///< by worker
    std::map<std::string, JobPtr> by_key_;   ///< jobs that equal requests can join
    std::map<std::uint64_t, JobPtr> by_id_;  ///< jobs with waiting clients
    std::set<int> idle_;
    std::map<int, View> last_view_;  ///< by worker
};
