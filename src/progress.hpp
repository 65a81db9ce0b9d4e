// SPDX-License-Identifier: MIT
// Elapsed time, progress and cancellation of long computations.
#pragma once

#include <chrono>
#include <functional>

#include "error.hpp"

namespace nicol {

/// Timer that measures the time since its construction.
class Stopwatch {
public:
    [[nodiscard]] double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Progress reports to a callback, at most ten per second.
class Progress {
public:
    using Callback = std::function<bool(const char* verb, double fraction)>;

    explicit Progress(const Callback& callback) : callback_(callback) {}

    /// Calls the callback. Throws Error(cancelled) if the callback returns false.
    void report(const char* verb, double fraction) {
        if (!callback_ || (asked_ && since_.milliseconds() < 100)) return;
        asked_ = true;
        since_ = Stopwatch();
        if (!callback_(verb, fraction))
            throw Error(ErrorCode::cancelled, "the progress callback asked to stop");
    }

private:
    const Callback& callback_;
    Stopwatch since_;
    bool asked_ = false;
};

}  // namespace nicol
