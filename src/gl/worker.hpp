// SPDX-License-Identifier: MIT
// One thread that runs jobs in the order they were given.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace nicol::gl {

/// Shared between a thread and the givers of its jobs, who keep it alive (see State).
class Worker {
public:
    /// The thread's main function; returns once stop() was called and every earlier job is done.
    void work();
    /// Calls call(argument) on the thread, waits, and rethrows what it threw. On the thread itself a plain
    /// call.
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
/// Error(out_of_memory) where the system has no room for a thread.
[[nodiscard]] std::thread start_quiet_thread(std::function<void()> body);

/// Joins `thread` after stop(). If the caller is such a worker thread itself (perhaps this one), it is joined
/// by a later call from another thread, or at the process's end.
void join_or_leave(std::thread thread);

/// Joins those that were left.
void join_left_threads();

}  // namespace nicol::gl
