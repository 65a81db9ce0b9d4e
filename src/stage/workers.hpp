// SPDX-License-Identifier: MIT
// Worker threads of a renderer.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "progress.hpp"
#include "shading/local_lighting.hpp"
#include "simd/lanes.hpp"
#include "stage/statistics.hpp"
#include "worker_pool.hpp"

namespace nicol {

class Workers : public WorkerPool {
public:
    using WorkerPool::WorkerPool;

    /// Calls body(begin, end) in parallel for pieces that cover first <= i < last, and reports progress
    /// between chunks of pieces as fractions of `all`. Pieces begin at multiples of sixteen. Throws
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
    /// Calls body(begin, end) in parallel for pieces that cover `count` blocks of sixteen vertices, and
    /// reports progress. Throws Error(cancelled).
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
            run([&] {
                tbb::parallel_for(part, [&body](const tbb::blocked_range<std::size_t>& range) {
                    body(range.begin(), range.end());
                });
            });
        }
    }
};

/// Brightness of an image's surfaces, as threads that shade pixels find it.
struct SurfaceTally {
    double covered = 0;       ///< number of pixels, as far as surfaces cover them, times channels
    std::uint64_t whole = 0;  ///< number of pixels that show surfaces without own light alone, times channels
    double power = 0;         ///< sum over these of s0^2

    SurfaceTally& operator+=(const SurfaceTally& other) {
        covered += other.covered;
        whole += other.whole;
        power += other.power;
        return *this;
    }
};

/// Threads, progress and statistics for the steps of one render.
struct RenderRun {
    Workers& workers;
    Progress& progress;
    Statistics& statistics;
    /// Largest number of bytes that a scene may take, if orders are chosen.
    std::uint64_t memory_limit = std::numeric_limits<std::uint64_t>::max();
    /// Whether memory is limited or watched, so that no more may be kept than the estimate says.
    bool saves_memory = false;
    LightingTally lighting{};  ///< tally of local lights and sampled terms
    LightingTally followed{};  ///< tally of the light that rays find for lobes
    SurfaceTally surfaces{};   ///< tally of the image; 0 where threads shade no pixels

    void add(const LightingTally& tally) {
        lighting += tally;
        statistics.light_rays += tally.rays;
        statistics.light_rays_skipped += tally.rays_spared;
    }
};

}  // namespace nicol
