// SPDX-License-Identifier: MIT
// A progress bar, shown only on a terminal and only if the work takes over a second.
#pragma once

#include <chrono>
#include <cstdint>

class ProgressBar {
public:
    ProgressBar();
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Updates the bar, as a nicol_progress_callback whose user is the ProgressBar. Always returns 1.
    static std::int32_t update(void* user, const char* verb, double fraction);
    /// Erases the bar, so that other lines may follow.
    void clear();

private:
    bool terminal_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point start_;
};
