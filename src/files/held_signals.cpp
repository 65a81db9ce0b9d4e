// SPDX-License-Identifier: MIT
#include "files/held_signals.hpp"

#include <ctime>
#include <initializer_list>

namespace nicol {

HeldSignals::HeldSignals() noexcept {
    sigset_t pending;
    sigemptyset(&added_);
    sigpending(&pending);
    for (const int number : {SIGXFSZ, SIGPIPE})
        if (sigismember(&pending, number) == 0) sigaddset(&added_, number);
    pthread_sigmask(SIG_BLOCK, &added_, &mask_);
}

HeldSignals::~HeldSignals() {
    // A signal that a write has sent would arrive as soon as the mask is restored, so it is consumed first.
    const timespec at_once{};
    while (sigtimedwait(&added_, nullptr, &at_once) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &mask_, nullptr);
}

}  // namespace nicol
