// SPDX-License-Identifier: MIT
// Number of worker threads.
#pragma once

#include <tbb/info.h>

#include <algorithm>

namespace nicol {

/// Returns the number of worker threads for a request of `threads`: at most one per core. 0 requests one per
/// core.
inline int worker_count(int threads) {
    const int cores = tbb::info::default_concurrency();
    return threads > 0 ? std::min(threads, cores) : cores;
}

}  // namespace nicol
