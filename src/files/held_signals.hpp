// SPDX-License-Identifier: MIT
// Suppression of the signals that a failed write sends to the writing thread.
#pragma once

#include <csignal>

namespace nicol {

/// Guard that keeps SIGXFSZ and SIGPIPE from the thread that constructs it, so that a file beyond the
/// process's limit and a pipe without a reader are errors of write() instead of the process's end. The
/// destructor restores the thread's mask, and signals that were pending before remain pending. One thread
/// constructs and destroys the object.
class HeldSignals {
public:
    HeldSignals() noexcept;
    ~HeldSignals();
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

private:
    sigset_t mask_{};   ///< the thread's previous mask
    sigset_t added_{};  ///< signals that are held by this object and were not pending before
};

}  // namespace nicol
