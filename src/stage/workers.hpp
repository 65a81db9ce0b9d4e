// SPDX-License-Identifier: MIT
// The threads that a renderer computes with.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "progress.hpp"
#include "simd/lanes.hpp"
#include "stage/statistics.hpp"
#include "worker_count.hpp"

namespace nicol {

class Workers {
public:
    explicit Workers(int threads) : arena_(worker_count(threads)) {}

    [[nodiscard]] int count() const { return arena_.max_concurrency(); }

    template <class Function>
    void run(Function&& function) {
        arena().execute(function);
    }

    /// Calls body(begin, end) for pieces that cover first <= i < last, side by side, and reports progress as
    /// fractions of `all` between chunks of them. Pieces begin at multiples of sixteen. Throws
    /// Error(cancelled).
    template <class Body>
    void for_vertices(std::size_t first, std::size_t last, std::size_t all, const char* verb,
                      Progress& progress, const Body& body) {
        if (first >= last) return;
        for_chunks(first / kLanes, (last + kLanes - 1) / kLanes, (all + kLanes - 1) / kLanes, verb, progress,
                   [&](std::size_t begin, std::size_t end) {
                       body(std::max(first, begin * kLanes), std::min(last, end * kLanes));
                   });
    }
    /// The same for blocks of sixteen vertices.
    template <class Body>
    void for_blocks(std::size_t count, const char* verb, Progress& progress, const Body& body) {
        for_chunks(0, count, count, verb, progress, body);
    }

private:
    static constexpr std::size_t kChunk = 1024;  // blocks between two reports
    static constexpr std::size_t kGrain = 16;    // blocks of one task

    template <class Body>
    void for_chunks(std::size_t first, std::size_t last, std::size_t all, const char* verb,
                    Progress& progress, const Body& body) {
        for (std::size_t begin = first; begin < last; begin += kChunk) {
            progress.report(verb, static_cast<double>(begin) / static_cast<double>(all));
            const tbb::blocked_range<std::size_t> part(begin, std::min(begin + kChunk, last), kGrain);
            arena().execute([&] {
                tbb::parallel_for(part, [&body](const tbb::blocked_range<std::size_t>& range) {
                    body(range.begin(), range.end());
                });
            });
        }
    }

    /// An arena that is opened by execute() waits for ever in the next one if memory was short in the first.
    tbb::task_arena& arena() {
        if (!arena_.is_active()) arena_.initialize(count());
        return arena_;
    }

    tbb::task_arena arena_;
};

/// What the steps of one render work with, report to and count in.
struct RenderRun {
    Workers& workers;
    Progress& progress;
    Statistics& statistics;
    /// Bytes that a scene may take, where orders are chosen.
    std::uint64_t memory_limit = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace nicol
