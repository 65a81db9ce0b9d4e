// SPDX-License-Identifier: MIT
// A gate that holds a job.
#pragma once

#include <atomic>
#include <cstdint>

namespace capi_test {

/// A progress callback that blocks its job until the gate is opened.
class Gate {
public:
    static std::int32_t callback(void* user, const char*, double) {
        auto& gate = *static_cast<Gate*>(user);
        gate.entered_ = true;
        gate.entered_.notify_all();
        gate.answer_.wait(closed);
        return gate.answer_;
    }
    void wait_until_entered() { entered_.wait(false); }
    void open(std::int32_t answer = 1) {
        answer_ = answer;
        answer_.notify_all();
    }

private:
    static constexpr std::int32_t closed = -1;
    std::atomic<bool> entered_ = false;
    std::atomic<std::int32_t> answer_ = closed;
};

}  // namespace capi_test
