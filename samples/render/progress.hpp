// SPDX-License-Identifier: MIT
// A progress bar with the verb that runs and the time that is left for it. It is shown only on a terminal and
// only if the work takes over a second.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

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
    std::string verb_;  // verb that runs, and where it began
    std::chrono::steady_clock::time_point verb_start_;
    double verb_from_ = 0;
};
