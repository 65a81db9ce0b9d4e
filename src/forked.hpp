// SPDX-License-Identifier: MIT
// Handling of processes made by fork(), which have the memory of their parent's threads but not the threads.
#pragma once

#include <pthread.h>

#include <atomic>
#include <mutex>

namespace nicol {

/// Returns whether fork() made this process after the first call of this function.
[[nodiscard]] inline bool forked() noexcept {
    static std::atomic<bool> child = false;
    static const int watched = pthread_atfork(nullptr, nullptr, [] { child = true; });
    static_cast<void>(watched);
    return child;
}

/// Mutex for making and destroying contexts of OpenGL, which use lists and locks that the process has once.
/// fork() waits for it: a child in which such a lock stayed taken could not end by exit(), which runs the
/// driver's handlers.
[[nodiscard]] inline std::recursive_mutex& driver_mutex() {
    static auto& mutex = *new std::recursive_mutex;  // never destroyed: contexts may be made until the end
    static const int watched =
        pthread_atfork([] { mutex.lock(); }, [] { mutex.unlock(); }, nullptr);  // the child makes none
    static_cast<void>(watched);
    return mutex;
}

/// Static object that calls a function at the end of the process that constructed the object. A forked child
/// that ends by exit() skips the call, because threads that the child does not have may hold locks and may
/// have left containers half changed.
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
