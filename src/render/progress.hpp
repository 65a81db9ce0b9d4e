// SPDX-License-Identifier: MIT
// Progress and cancellation of long work.
#pragma once

#include <functional>

#include "error.hpp"
#include "render/stopwatch.hpp"

namespace nicol {

/// Passes progress on at most ten times a second.
class Progress {
public:
    using Callback = std::function<bool(const char* verb, double fraction)>;

    explicit Progress(const Callback& callback) : callback_(callback) {}

    /// Throws Error(cancelled) where the callback answers false.
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
