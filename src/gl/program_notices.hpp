// SPDX-License-Identifier: MIT
// Queue of notices about cached programs.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace nicol::gl {

/// Queue of notices that arise on a context's thread. The calling thread delivers them, because only that
/// thread may call the log.
class ProgramNotices {
public:
    void set_receiver(std::function<void(const std::string&)> receiver) {
        const std::lock_guard lock(mutex_);
        receiver_ = std::move(receiver);
    }
    void add(std::string notice) {
        const std::lock_guard lock(mutex_);
        if (receiver_) waiting_.push_back(std::move(notice));
    }
    /// Passes all waiting notices to the receiver.
    void deliver() {
        std::vector<std::string> notices;
        std::function<void(const std::string&)> receiver;
        {
            const std::lock_guard lock(mutex_);
            if (waiting_.empty()) return;
            notices.swap(waiting_);
            receiver = receiver_;
        }
        for (const std::string& notice : notices) receiver(notice);
    }

private:
    std::mutex mutex_;
    std::function<void(const std::string&)> receiver_;
    std::vector<std::string> waiting_;
};

}  // namespace nicol::gl
