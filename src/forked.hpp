// SPDX-License-Identifier: MIT
// Children of fork(): they have the memory of their parent's threads, and not the threads.
#pragma once

#include <pthread.h>

#include <atomic>

namespace nicol {

/// Whether this process is a child that fork() made after this function's first call.
[[nodiscard]] inline bool forked() noexcept {
    static std::atomic<bool> child = false;
    static const int watched = pthread_atfork(nullptr, nullptr, [] { child = true; });
    static_cast<void>(watched);
    return child;
}

/// A static object that calls a function at the end of the process that made it. A child that ends by exit()
/// skips the call: locks may be held and containers half changed by threads that the child does not have.
class AtProcessEnd {
public:
    explicit AtProcessEnd(void (*call)()) noexcept : call_(call) { static_cast<void>(forked()); }
    ~AtProcessEnd() {
        if (!forked()) call_();
    }
    AtProcessEnd(const AtProcessEnd&) = delete;
    AtProcessEnd& operator=(const AtProcessEnd&) = delete;

private:
    void (*call_)();
};

}  // namespace nicol
