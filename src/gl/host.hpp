// SPDX-License-Identifier: MIT
// A context that belongs to the host: calls run where it is current, and find and leave it as it was.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "gl/object.hpp"
#include "gl/platform.hpp"

namespace nicol::gl {

/// Uses the host's function look-up. Never makes, makes current or destroys its context.
class HostPlatform final : public Platform {
public:
    explicit HostPlatform(HostAccess access) : access_(std::move(access)) {}
    [[nodiscard]] Function function(const char* name) const override { return access_.function(name); }
    [[nodiscard]] const HostAccess& access() const noexcept { return access_; }

private:
    HostAccess access_;
};

/// The counterpart of Worker for a host's context: runs calls, those of a borrowing thread on one that lends,
/// and deletes objects that were dropped elsewhere.
class Host {
public:
    explicit Host(const HostAccess& access) : access_(access) {}

    /// Marks the context by an object that contexts do not share. With the context current.
    void mark(const Context::State& state);
    /// Whether the marked context is current on the calling thread, by the host's is_current() if there is
    /// one.
    [[nodiscard]] bool is_current(const Context::State& state) const noexcept;
    /// Throws Error(not_current) unless it is.
    void require_current(const Context::State& state) const;
    /// Calls call(argument) between saving and restoring the host's state; for a thread that borrows, where
    /// the context is lent. The host's pending errors are pending again afterwards. Throws
    /// Error(not_current); Error(opengl) for a pending error that cannot be made pending again:
    /// GL_STACK_OVERFLOW, GL_STACK_UNDERFLOW or GL_CONTEXT_LOST; and Error(unsupported) for a state of the
    /// host in which nothing can be drawn, or which cannot be restored.
    void execute(Context::State& state, void (*call)(void*), void* argument);
    [[nodiscard]] bool on_thread() const noexcept { return inside_.load() == std::this_thread::get_id(); }

    /// See Context and Borrower.
    void begin_borrowing(std::function<void()> meanwhile);
    void end_borrowing() noexcept;
    void lend(Context::State& state);
    [[nodiscard]] bool lend_until(Context::State& state, const std::function<bool()>& over,
                                  std::optional<std::chrono::steady_clock::time_point> until);
    void wake() noexcept;

    /// Deletes an object now if the context is current, else at the next call while it is.
    void remove(const Context::State& state, ObjectKind kind, unsigned id) noexcept;
    /// Deletes the pending objects. With the context current.
    void remove_waiting(const Context::State& state) noexcept;

private:
    struct Name {
        ObjectKind kind;
        unsigned id;
    };
    // What a borrowing thread waits for.
    struct Call {
        void (*call)(void*);
        void* argument;
        bool taken = false;
        bool done = false;
        std::exception_ptr error;
    };
    void borrow(void (*call)(void*), void* argument);
    void run_asked(Context::State& state, std::unique_lock<std::mutex>& lock);

    const HostAccess& access_;
    std::string mark_;
    std::atomic<std::thread::id> inside_{};
    std::mutex mutex_;
    std::vector<Name> waiting_;
    std::mutex lending_;
    std::condition_variable changed_;  // of the following, and what lend_until() waits for
    std::atomic<std::thread::id> borrower_{};
    std::function<void()> meanwhile_;
    Call* asked_ = nullptr;
};

}  // namespace nicol::gl
