// SPDX-License-Identifier: MIT
// A queue of jobs that one thread runs in order.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace nicol::gl {

/// Job queue shared between a thread and the givers of its jobs, which keep the queue alive (see State).
class Worker {
public:
    /// Runs jobs; this is the thread's main function. Returns after stop() once every earlier job is done.
    void work();
    /// Calls call(argument) on the thread, waits, and rethrows its exception. On the thread itself it is a
    /// plain call.
    void execute(void (*call)(void*), void* argument);
    /// Queues `job` after earlier ones, without waiting. `job` must not throw.
    void post(std::function<void()> job);
    void stop();
    [[nodiscard]] bool on_thread() const noexcept;

private:
    std::mutex mutex_;
    std::condition_variable given_;
    std::deque<std::function<void()>> jobs_;
    bool stopped_ = false;
    std::atomic<std::thread::id> id_{};
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
