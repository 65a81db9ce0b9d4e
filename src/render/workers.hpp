// SPDX-License-Identifier: MIT
// The threads that a renderer computes with.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#include "render/progress.hpp"

namespace nicol {

class Workers {
public:
    /// 0: one a core, which is also the most.
    explicit Workers(int threads)
        : arena_(threads > 0 ? std::min(threads, tbb::info::default_concurrency())
                             : tbb::task_arena::automatic) {}

    template <class Function>
    void run(Function&& function) {
        arena_.execute(function);
    }

    /// Calls body(begin, end) for pieces that cover first <= i < last, side by side, and reports progress as
    /// fractions of `all` between chunks of them. Throws Error(cancelled).
    template <class Body>
    void for_vertices(std::size_t first, std::size_t last, std::size_t all, const char* verb,
                      Progress& progress, const Body& body) {
        for_chunks(first, last, all, chunk, grain, verb, progress, body);
    }
    /// The same for blocks of sixteen vertices.
    template <class Body>
    void for_blocks(std::size_t count, const char* verb, Progress& progress, const Body& body) {
        for_chunks(0, count, count, chunk / 16, grain / 16, verb, progress, body);
    }

private:
    static constexpr std::size_t chunk = 16384;  // vertices between two looks at the progress callback
    static constexpr std::size_t grain = 256;    // vertices of one task

    template <class Body>
    void for_chunks(std::size_t first, std::size_t last, std::size_t all, std::size_t step,
                    std::size_t smallest, const char* verb, Progress& progress, const Body& body) {
        for (std::size_t begin = first; begin < last; begin += step) {
            progress.report(verb, static_cast<double>(begin) / static_cast<double>(all));
            const tbb::blocked_range<std::size_t> part(begin, std::min(begin + step, last), smallest);
            arena_.execute([&] {
                tbb::parallel_for(part, [&body](const tbb::blocked_range<std::size_t>& range) {
                    body(range.begin(), range.end());
                });
            });
        }
    }

    tbb::task_arena arena_;
};

}  // namespace nicol
