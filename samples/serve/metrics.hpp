// SPDX-License-Identifier: MIT
// Metrics of the service, in the text format of Prometheus.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "message.hpp"

/// Cumulative counts of seconds.
class Histogram {
public:
    void add(double seconds);
    /// Returns the lines of the metric with this name; labels such as `verb="draw"`, or none.
    [[nodiscard]] std::string text(const std::string& name, const std::string& labels) const;
    [[nodiscard]] double mean() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }

private:
    static constexpr std::array<double, 13> kBounds = {0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05,
                                                       0.1,    0.25,  0.5,    1,     2.5,  10};
    std::array<std::uint64_t, kBounds.size()> counts_{};
    std::uint64_t count_ = 0;
    double sum_ = 0;
};

struct WorkerState {
    int pid = 0;
    const char* state = "";  ///< starting, idle, busy or waiting
    std::uint64_t resident_bytes = 0;
};

/// Present values, in contrast to counts.
struct Gauges {
    std::size_t queued = 0, running = 0, connections = 0, cached_bytes = 0, answer_bytes = 0;
    bool ready = false;
    std::vector<WorkerState> workers;
};

struct Metrics {
    std::map<int, std::uint64_t> requests;  ///< by status
    std::uint64_t renders = 0;              ///< images rendered by workers
    std::uint64_t hits_tag = 0;             ///< answers with status 304
    std::uint64_t hits_result = 0;          ///< answers from the result cache
    std::uint64_t hits_flight = 0;          ///< requests that joined an equal one under way
    std::uint64_t hits_view = 0;            ///< renders of a view that the worker had rendered before
    std::uint64_t refused_queue = 0;
    std::uint64_t displaced = 0;          ///< idle connections closed to make room
    std::uint64_t clients_gone = 0;       ///< clients that left before their answer
    std::uint64_t cancelled = 0;          ///< renders stopped because their clients left
    std::uint64_t crashed = 0, hung = 0;  ///< numbers of workers
    Histogram waited;                     ///< seconds from request to answer, for images
    std::array<Histogram, kVerbs.size()> by_verb;

    Histogram render_seconds;  ///< sum of all verbs

    void rendered(const ResultHead& head);
    [[nodiscard]] std::string text(const Gauges& now) const;
};
