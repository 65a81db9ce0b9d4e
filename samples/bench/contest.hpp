// SPDX-License-Identifier: MIT
// Fair timing: contestants alternate in one process, and medians of many runs are compared.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

#include "median.hpp"

/// Median seconds of each contestant for one call. Every contestant runs once untimed; then all alternate
/// until `seconds` have passed, for at least five rounds. A run repeats the call for about a millisecond,
/// since clocks are coarse.
inline std::vector<double> contest(const std::vector<std::function<void()>>& contestants, double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto elapsed = [](Clock::time_point since) {
        return std::chrono::duration<double>(Clock::now() - since).count();
    };
    std::vector<int> repeats;
    for (const auto& run : contestants) {
        run();
        const auto start = Clock::now();
        run();
        repeats.push_back(static_cast<int>(std::clamp(1e-3 / std::max(elapsed(start), 1e-9), 1.0, 1e5)));
    }
    std::vector<std::vector<double>> times(contestants.size());
    const auto begin = Clock::now();
    while (times.front().size() < 5 || elapsed(begin) < seconds) {
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            const auto start = Clock::now();
            for (int r = 0; r < repeats[i]; ++r) contestants[i]();
            times[i].push_back(elapsed(start) / repeats[i]);
        }
    }
    std::vector<double> medians;
    for (auto& list : times) medians.push_back(median(std::move(list)));
    return medians;
}
