// SPDX-License-Identifier: MIT
// Work that a context does on a thread of its own.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "boundary.hpp"

namespace nicol::capi {

struct Session;

/// The object behind a job's handle. All members may be called from any thread.
class Job {
public:
    /// Runs on the queue's thread; what it throws is the job's result. It calls begin() once nothing is in
    /// its way any more, then report().
    using Work = std::function<void(Job&)>;

    /// `ended` is called once the job is done.
    Job(Work work, std::function<void()> ended) : work_(std::move(work)), ended_(std::move(ended)) {}

    [[nodiscard]] nicol_job_status status() const;
    /// The result and, where it is a failure, its message for nicol_last_error(); none where the time is
    /// over.
    [[nodiscard]] std::optional<nicol_result> wait(std::optional<std::chrono::milliseconds> at_most) const;
    /// Ends a waiting job now and a running one at its next report(). Does nothing once it is done.
    void cancel();

    /// All three throw Error(cancelled) after cancel().
    void begin();
    void report(const char* verb, double fraction);
    void check() const;
    void run();
    [[nodiscard]] bool waiting() const;

private:
    // Both with the mutex held. finish() returns what is to be called without it.
    [[nodiscard]] std::function<void()> finish(nicol_result result, const char* message);
    void require_wanted() const;

    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    Work work_;
    std::function<void()> ended_;
    nicol_job_state state_ = NICOL_JOB_WAITING;
    bool cancelled_ = false;
    nicol_result result_ = NICOL_OK;
    std::array<char, 2048> message_{};
    const char* verb_ = "";
    double fraction_ = 0;
};

/// Runs jobs in the order they came, on a thread that begins with the first. Jobs keep their queue's owner
/// alive, so it goes when all are done, possibly on its own thread.
class JobQueue {
public:
    JobQueue();
    ~JobQueue();
    JobQueue(const JobQueue&) = delete;
    JobQueue& operator=(const JobQueue&) = delete;

    /// Throws Error(busy) where NICOL_MAX_JOBS jobs wait.
    void add(std::shared_ptr<Job> job);

private:
    struct Shared;
    std::shared_ptr<Shared> shared_;
    std::thread thread_;
};

}  // namespace nicol::capi
