// SPDX-License-Identifier: MIT
#include "gl/lending_mutex.hpp"

#include "gl/state.hpp"

namespace nicol::gl {

void LendingMutex::lock() {
    const Host* const host = context_->state().host.get();
    if (host == nullptr || host->borrows())
        mutex_.lock();
    else if (!mutex_.try_lock())
        static_cast<void>(context_->lend_until([this] { return mutex_.try_lock(); }));
}

void LendingMutex::unlock() {
    mutex_.unlock();
    context_->wake();
}

}  // namespace nicol::gl
