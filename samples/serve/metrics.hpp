// SPDX-License-Identifier: MIT
// What the service counts, in the text format of Prometheus.
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
    /// Lines of the metric with this name; labels such as `verb="draw"`, or none.
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
    const char* state = "";  ///< starting, idle, busy, waiting
    std::uint64_t resident_bytes = 0;
};

/// What is the case now, rather than counted.
struct Gauges {
    std::size_t queued = 0, running = 0, connections = 0, cached_bytes = 0, answer_bytes = 0;
    bool ready = false;
    std::vector<WorkerState> workers;
};

struct Metrics {
    std::map<int, std::uint64_t> requests;  ///< by status of the answer
    std::uint64_t renders = 0;              ///< images that workers made
    std::uint64_t hits_tag = 0;             ///< 304
    std::uint64_t hits_result = 0;          ///< answers that were kept
    std::uint64_t hits_flight = 0;          ///< joined an equal request under way
    std::uint64_t hits_view = 0;            ///< the worker had rendered this view
    std::uint64_t refused_queue = 0;
    std::uint64_t displaced = 0;          ///< idle connections that made room
    std::uint64_t clients_gone = 0;       ///< left before their answer
    std::uint64_t cancelled = 0;          ///< renders that were stopped for it
    std::uint64_t crashed = 0, hung = 0;  ///< workers
    Histogram waited;                     ///< from request to answer, of images
    std::array<Histogram, kVerbs.size()> by_verb;

    Histogram render_seconds;  ///< all verbs together

    void rendered(const ResultHead& head);
    [[nodiscard]] std::string text(const Gauges& now) const;
};
