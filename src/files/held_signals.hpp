// SPDX-License-Identifier: MIT
// Signals that a failed write sends to the thread that wrote.
#pragma once

#include <csignal>

namespace nicol {

/// While an object lives, SIGXFSZ and SIGPIPE do not reach the thread that made it, so that a file beyond the
/// process's limit and a pipe without a reader are errors of write() instead of the process's end. The
/// thread's mask and the signals that were pending before stay. Made and destroyed by one thread.
class HeldSignals {
public:
    HeldSignals() noexcept;
    ~HeldSignals();
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

private:
    sigset_t mask_{};   ///< of the thread before
    sigset_t added_{};  ///< signals that are held here and were not pending before
};

}  // namespace nicol
