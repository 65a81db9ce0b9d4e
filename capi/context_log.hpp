// SPDX-License-Identifier: MIT
// Log callback of a context, which may change while messages arrive on other threads.
#pragma once

#include <cstdint>
#include <mutex>
#include <shared_mutex>
#include <string>

#include "nicol.h"

namespace nicol::capi {

class ContextLog {
public:
    /// Replaces the callback; NULL: none. Returns when no thread is in the callback before, so that the
    /// caller may release what belongs to it.
    void set(nicol_log_callback callback, void* user) {
        const std::lock_guard lock(mutex_);
        callback_ = callback;
        user_ = user;
    }
    void send(std::uint32_t severity, const std::string& line) const {
        const std::shared_lock lock(mutex_);
        if (callback_ != nullptr) callback_(user_, severity, NICOL_OK, line.c_str());
    }

private:
    mutable std::shared_mutex mutex_;
    nicol_log_callback callback_ = nullptr;
    void* user_ = nullptr;
};

}  // namespace nicol::capi
