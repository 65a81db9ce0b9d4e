// SPDX-License-Identifier: MIT
// A progress bar for people: only on a terminal, and only when the work takes over a second.
#pragma once

#include <chrono>
#include <cstdint>

class ProgressBar {
public:
    ProgressBar();
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// A nicol_progress_callback; user is the ProgressBar. Always answers 1.
    static std::int32_t update(void* user, const char* verb, double fraction);
    /// Wipes the bar, so that other lines may follow.
    void clear();

private:
    bool terminal_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point start_;
};
