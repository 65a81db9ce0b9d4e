// SPDX-License-Identifier: MIT
// A call of the C interface in which each of its allocations fails once.
#pragma once

#include "capi/capi.hpp"
#include "memory/failing_new.hpp"

namespace memory_test {

/// Calls `call` without and then with a Shortage of the thread at about `positions` of its allocations, once
/// as one failure and once as a lasting one. It has to succeed or to return NICOL_ERROR_OUT_OF_MEMORY;
/// check() looks, with memory, at what it left. Returns how often it failed.
template <class Call, class Check>
std::int64_t sweep(std::int64_t positions, const Call& call, const Check& check) {
    std::int64_t allocations = 0, failed = 0;
    {
        const Shortage none(Reach::thread);
        REQUIRE(call() == NICOL_OK);
        allocations = none.count();
    }
    const std::int64_t step = std::max<std::int64_t>(1, allocations / positions);
    for (std::int64_t position = 0; position < allocations; position += step) {
        for (const bool lasting : {false, true}) {
            CAPTURE(position);
            CAPTURE(lasting);
            nicol_result result = NICOL_OK;
            {
                const Shortage shortage(position, lasting, Reach::thread);
                result = call();
            }
            if (result != NICOL_OK) {
                ++failed;
                INFO(std::string(nicol_last_error()));
                CHECK(result == NICOL_ERROR_OUT_OF_MEMORY);
            }
            check(result);
        }
    }
    return failed;
}

}  // namespace memory_test
