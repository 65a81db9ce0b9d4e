// SPDX-License-Identifier: MIT
// Work that a context does on a separate thread.
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

/// The object behind a job's handle. All members are thread-safe.
class Job {
public:
    /// Function run on the queue's thread; its exception is the job's result. The function calls begin() once
    /// nothing delays it any more, then report().
    using Work = std::function<void(Job&)>;

    /// Makes a job. `ended` is called once the job is done.
    Job(Work work, std::function<void()> ended) : work_(std::move(work)), ended_(std::move(ended)) {}

    [[nodiscard]] nicol_job_status status() const;
    /// Returns the result and, for a failure, sets its message for nicol_last_error(). Returns nothing if the
    /// time has passed.
    [[nodiscard]] std::optional<nicol_result> wait(std::optional<std::chrono::milliseconds> at_most) const;
    /// Ends a waiting job now and a running one at its next report(). Does nothing to a finished job.
    void cancel();

    /// Marks the job as running. begin(), report() and check() throw Error(cancelled) after cancel().
    void begin();
    void report(const char* verb, double fraction);
    void check() const;
    void run();
    [[nodiscard]] bool waiting() const;

private:
    // finish() and require_wanted() require the mutex. finish() returns a function to be called without it.
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

/// Runs jobs in the order of their arrival, on a thread that starts with the queue. Jobs keep their queue's
/// owner alive, so it is destroyed when all are done, possibly on its own thread.
class JobQueue {
public:
    JobQueue();
    ~JobQueue();
    JobQueue(const JobQueue&) = delete;
    JobQueue& operator=(const JobQueue&) = delete;

    /// Adds a job. Throws Error(busy) if NICOL_MAX_JOBS jobs wait.
    void add(std::shared_ptr<Job> job);

private:
    struct Shared;
    std::shared_ptr<Shared> shared_;
    std::thread thread_;
};

}  // namespace nicol::capi
