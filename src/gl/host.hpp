// SPDX-License-Identifier: MIT
// Use of a context that belongs to the host: runs calls while it is current and restores its state.
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

/// Platform that uses the host's function look-up. Never makes, makes current or destroys its context.
class HostPlatform final : public Platform {
public:
    explicit HostPlatform(HostAccess access) : access_(std::move(access)) {}
    [[nodiscard]] Function function(const char* name) const override { return access_.function(name); }
    [[nodiscard]] const HostAccess& access() const noexcept { return access_; }

private:
    HostAccess access_;
};

/// Counterpart of Worker for a host's context. Runs calls, including those of a borrowing thread on a thread
/// that lends, and deletes objects that were dropped elsewhere.
class Host {
public:
    explicit Host(const HostAccess& access) : access_(access) {}

    /// Marks the context by an object that contexts do not share. The context must be current.
    void mark(const Context::State& state);
    /// Returns whether the marked context is current on the calling thread, by the host's is_current() if
    /// there is one.
    [[nodiscard]] bool is_current(const Context::State& state) const noexcept;
    /// Throws Error(not_current) unless the context is current on the calling thread.
    void require_current(const Context::State& state) const;
    /// Calls call(argument) during a visit: that of the calling thread, or one of its own. For a thread that
    /// borrows, the call runs on a thread that lends the context.
    void execute(Context::State& state, void (*call)(void*), void* argument);
    /// Calls `call` between saving and restoring the host's state, unless the host sets its own. The state is
    /// saved when execute() is first called. The host's pending errors are pending again afterwards.
    /// Throws Error(not_current); Error(opengl) for a pending error that cannot be made pending again:
    /// GL_STACK_OVERFLOW, GL_STACK_UNDERFLOW or GL_CONTEXT_LOST; and Error(unsupported) for a state of the
    /// host in which nothing can be drawn, or which cannot be restored.
    void visit(Context::State& state, const std::function<void()>& call);
    [[nodiscard]] bool on_thread() const noexcept { return inside_.load() == std::this_thread::get_id(); }
    /// Returns whether the calling thread borrows the context.
    [[nodiscard]] bool borrows() const noexcept { return borrower_.load() == std::this_thread::get_id(); }
    [[nodiscard]] const HostAccess& access() const noexcept { return access_; }

    /// Implements Context's and Borrower's functions of these names.
    void begin_borrowing(std::function<void()> meanwhile);
    void end_borrowing() noexcept;
    void lend(Context::State& state);
    [[nodiscard]] bool lend_until(Context::State& state, const std::function<bool()>& over,
                                  std::optional<std::chrono::steady_clock::time_point> until);
    void wake() noexcept;

    /// Deletes an object now if the context is current, or else at the next call while it is current.
    void remove(const Context::State& state, ObjectKind kind, unsigned id) noexcept;
    /// Deletes the pending objects. The context must be current.
    void remove_waiting(const Context::State& state) noexcept;

private:
    struct Name {
        ObjectKind kind;
        unsigned id;
    };
    // A call that a borrowing thread waits for.
    struct Call {
        void (*call)(void*);
        void* argument;
        bool taken = false;
        bool done = false;
        std::exception_ptr error;
    };
    class Visit;
    [[nodiscard]] bool visiting() const noexcept { return visitor_.load() == std::this_thread::get_id(); }
    void borrow(void (*call)(void*), void* argument);
    void run_asked(Context::State& state, std::unique_lock<std::mutex>& lock);

    const HostAccess& access_;
    std::string mark_;
    std::atomic<std::thread::id> inside_{};
    std::atomic<std::thread::id> visitor_{};
    Visit* visit_ = nullptr;  // used by the visitor alone
    std::mutex mutex_;
    std::vector<Name> waiting_;
    std::mutex lending_;
    std::condition_variable changed_;  // signals changes of the members below, and wakes lend_until()
    std::atomic<std::thread::id> borrower_{};
    std::function<void()> meanwhile_;
    Call* asked_ = nullptr;
};

}  // namespace nicol::gl
