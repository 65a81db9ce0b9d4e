// SPDX-License-Identifier: MIT
// The threads that a renderer computes with.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <functional>

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

    /// Calls body(begin, end) for pieces that cover first <= v < last, side by side, and reports progress as
    /// fractions of `all` between chunks of them. Throws Error(cancelled).
    template <class Body>
    void for_vertices(std::size_t first, std::size_t last, std::size_t all, const char* verb,
                      Progress& progress, const Body& body) {
        for (std::size_t begin = first; begin < last; begin += chunk) {
            progress.report(verb, static_cast<double>(begin) / static_cast<double>(all));
            const tbb::blocked_range<std::size_t> part(begin, std::min(begin + chunk, last), grain);
            arena_.execute([&] {
                tbb::parallel_for(part, [&body](const tbb::blocked_range<std::size_t>& range) {
                    body(range.begin(), range.end());
                });
            });
        }
    }

private:
    static constexpr std::size_t chunk = 16384;  // vertices between two looks at the progress callback
    static constexpr std::size_t grain = 256;    // vertices of one task

    tbb::task_arena arena_;
};

}  // namespace nicol
