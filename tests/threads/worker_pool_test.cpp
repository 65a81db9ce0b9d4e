// SPDX-License-Identifier: MIT
#include "worker_pool.hpp"

#include <tbb/parallel_for.h>

#include <atomic>
#include <fstream>

#include "test.hpp"

using namespace nicol;

namespace {

/// Returns the memory of this process, in bytes.
double resident_bytes() {
    std::ifstream file("/proc/self/statm");
    double all = 0, resident = 0;
    file >> all >> resident;
    return 4096 * resident;
}

/// Runs a loop on so many pools of two threads, one after the other.
void run_pools(int count) {
    std::atomic<int> sum = 0;
    for (int i = 0; i < count; ++i)
        WorkerPool({.threads = 2}).run([&] { tbb::parallel_for(0, 100, [&](int) { ++sum; }); });
    CHECK(sum == 100 * count);
}

}  // namespace

TEST_CASE("pools leave no memory behind") {
    run_pools(100);
    const double before = resident_bytes();
    run_pools(1500);
    CHECK(resident_bytes() - before < 1500 * 1000.0);  // an arena of oneTBB has 7 kB
}

TEST_CASE("pools in use at the same time have arenas of their own") {
    WorkerPool outer({.threads = 2}), inner({.threads = 2});
    int calls = 0;
    outer.run([&] { inner.run([&] { ++calls; }); });
    CHECK(calls == 1);
}
