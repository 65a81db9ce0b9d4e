// SPDX-License-Identifier: MIT
#include "gl/worker.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

using nicol::gl::Worker;

namespace {

void append(Worker& worker, std::string& to, char what) {
    struct Argument {
        std::string& to;
        char what;
    } argument{to, what};
    worker.execute(
        [](void* pointer) {
            const auto& [text, letter] = *static_cast<Argument*>(pointer);
            text += letter;
        },
        &argument);
}

// Returns the order in which the jobs of a thread that gives way (p) and of another thread (c) ran. The first
// one is given some time before the second one.
std::string order_of(Worker::Patience patience) {
    Worker worker(patience);
    std::string order;
    std::thread patient([&] {
        worker.begin_giving_way();
        append(worker, order, 'p');
        worker.end_giving_way();
    });
    for (int i = 0; i < 1000; ++i) std::this_thread::yield();
    worker.post([&] { order += 'c'; });
    std::thread working([&] { worker.work(); });
    patient.join();
    worker.stop();
    working.join();
    return order;
}

}  // namespace

TEST_CASE("a thread that gives way comes after callers, unless it waited for long") {
    using namespace std::chrono_literals;
    CHECK(order_of({.pause = 0ms, .longest = 1h}) == "cp");
    std::string order = order_of({.pause = 1h, .longest = 0ms});
    std::ranges::sort(order);
    CHECK(order == "cp");
}
