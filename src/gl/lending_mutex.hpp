// SPDX-License-Identifier: MIT
// Mutex of an object of a context.
#pragma once

#include <memory>
#include <mutex>

#include "gl/context.hpp"

namespace nicol::gl {

/// Mutex that is locked before run() of its context, never inside. A thread that waits for it lends a host's
/// context meanwhile, because the owner may be a Borrower.
class LendingMutex {
public:
    explicit LendingMutex(std::shared_ptr<Context> context) : context_(std::move(context)) {}

    /// Locks the mutex. Throws Error(not_current) if the owner waits for a host's context that is not current
    /// on the calling thread.
    void lock();
    [[nodiscard]] bool try_lock() { return mutex_.try_lock(); }
    void unlock();

private:
    std::shared_ptr<Context> context_;
    std::mutex mutex_;
};

}  // namespace nicol::gl
