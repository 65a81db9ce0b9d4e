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
    // An odd step reaches both of allocations that come in pairs.
    const std::int64_t step = std::max<std::int64_t>(1, allocations / positions) | 1;
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

/// Renders frames 0 and 1 by turns, each time with a failure at the next of a frame's allocations in the
/// library. frame(k): renders a frame and returns its result. image(): returns the image of the last frame.
/// lacked(): called after each frame that lacked memory. Checks that both frames have the images that they
/// have with enough memory, after each of them.
template <class Frame, class GetImage, class Lacked>
void sweep_frames(const Frame& frame, const GetImage& image, const Lacked& lacked) {
    std::vector<float> expected[2];
    std::int64_t allocations = 0, failed = 0;
    for (int round = 0; round < 2; ++round) {  // the second round has what frames share
        for (const std::size_t k : {0U, 1U}) {
            const Shortage none;
            OK(frame(k));
            allocations = none.count();
            expected[k] = image();
        }
    }
    REQUIRE(expected[0] != expected[1]);
    for (std::int64_t position = 0; position < allocations; ++position) {
        CAPTURE(position);
        const std::size_t k = position % 2 == 0 ? 0 : 1;
        {
            const Shortage shortage(position, false);
            if (frame(k) != NICOL_OK) ++failed;
        }
        lacked();
        for (const std::size_t other : {1 - k, k}) {
            OK(frame(other));
            REQUIRE(image() == expected[other]);
        }
    }
    CHECK(failed > allocations / 2);
}

}  // namespace memory_test
