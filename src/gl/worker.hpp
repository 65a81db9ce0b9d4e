// SPDX-License-Identifier: MIT
// Queues of jobs that one thread runs.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace nicol::gl {

/// Job queue shared between a thread and the givers of its jobs, which keep the queue alive (see State).
class Worker {
public:
    /// How the jobs of a thread that gives way wait.
    struct Patience {
        /// Between two steps of a call in OpenGL, the calling thread prepares the second one for this long.
        std::chrono::milliseconds pause{2};
        /// Such a job waits no longer, so that a host that calls all the time does not stop it.
        std::chrono::milliseconds longest{8};
    };

    Worker() = default;
    explicit Worker(Patience patience) : patience_(patience) {}

    /// Runs jobs; this is the thread's main function. Returns after stop() once every earlier job is done.
    void work();
    /// Calls call(argument) on the thread, waits, and rethrows its exception. On the thread itself it is a
    /// plain call.
    void execute(void (*call)(void*), void* argument);
    /// Queues `job` after earlier ones, without waiting. `job` must not throw.
    void post(std::function<void()> job);
    /// Lets the execute() of other threads go before the calling thread's until end_giving_way(): a call that
    /// gives several jobs in a row then waits for one of this thread's at most. At most one thread gives way.
    void begin_giving_way() noexcept { giving_way_ = std::this_thread::get_id(); }
    void end_giving_way() noexcept { giving_way_ = std::thread::id(); }
    void stop();
    [[nodiscard]] bool on_thread() const noexcept;

private:
    using Clock = std::chrono::steady_clock;
    using Jobs = std::deque<std::function<void()>>;

    void give(Jobs& jobs, std::function<void()> job);
    // Returns the queue of the next job, null once stopped and empty. Waits for a job. `lock` locks mutex_.
    [[nodiscard]] Jobs* next(std::unique_lock<std::mutex>& lock);

    Patience patience_{};
    std::mutex mutex_;
    std::condition_variable given_;
    Jobs jobs_;
    Jobs patient_;              // of the thread that gives way; at most one, since execute() waits
    Clock::time_point quiet_;   // when a caller that came before has most likely no further job
    Clock::time_point latest_;  // when the patient job has waited long enough
    bool stopped_ = false;
    std::atomic<std::thread::id> id_{};
    std::atomic<std::thread::id> giving_way_{};
};

/// Starts a thread that blocks the host's signals and has the default FloatingEnvironment. Throws
/// Error(out_of_memory) if the system cannot create a thread.
[[nodiscard]] std::thread start_quiet_thread(std::function<void()> body);

/// Joins `thread` after stop(). If the caller is a context's thread itself, a later call from another thread
/// or the end of the process joins `thread`.
void join_or_leave(std::thread thread);

/// Joins the threads that join_or_leave() did not join.
void join_left_threads();

}  // namespace nicol::gl
