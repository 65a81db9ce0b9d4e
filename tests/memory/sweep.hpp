// SPDX-License-Identifier: MIT
// Calls of the C interface with a failure at each of their allocations.
#pragma once

#include "capi/capi.hpp"
#include "memory/failing_new.hpp"

namespace memory_test {

/// Calls `call` without a Shortage, then with one at about `positions` of its allocations on this thread,
/// once as a single failure and once as a lasting one. The call must succeed or return
/// NICOL_ERROR_OUT_OF_MEMORY. After each call check(result) runs with enough memory. Returns the number of
/// failed calls.
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
