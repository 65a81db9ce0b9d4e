// SPDX-License-Identifier: MIT
#include "forked.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <thread>

#include "test.hpp"

using namespace nicol;

TEST_CASE("fork() waits while another thread makes or destroys a context") {
    std::atomic<bool> forking = false, released = false;
    std::unique_lock lock(driver_mutex());
    bool waited = false;
    int status = -1;
    std::thread thread([&] {
        forking = true;
        const pid_t child = ::fork();
        if (child == 0) ::_exit(0);
        waited = released;
        ::waitpid(child, &status, 0);
    });
    while (!forking) std::this_thread::yield();
    // Time in which a fork that does not wait is done.
    for (int i = 0; i < 100000; ++i) std::this_thread::yield();
    released = true;
    lock.unlock();
    thread.join();
    CHECK(waited);
    CHECK(status == 0);
}

TEST_CASE("A callback of a thread that makes a context may fork") {
    const std::lock_guard lock(driver_mutex());
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    int status = -1;
    CHECK(::waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}
