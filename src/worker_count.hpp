// SPDX-License-Identifier: MIT
// How many threads compute.
#pragma once

#include <tbb/info.h>

#include <algorithm>

namespace nicol {

/// How many work where this many are asked for: never more than one a core, and that for 0.
inline int worker_count(int threads) {
    const int cores = tbb::info::default_concurrency();
    return threads > 0 ? std::min(threads, cores) : cores;
}

}  // namespace nicol
