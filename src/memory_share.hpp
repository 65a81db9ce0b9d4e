// SPDX-License-Identifier: MIT
// Account of large blocks of memory, which a host may keep.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "error.hpp"

namespace nicol {

/// Function that is told the bytes of large blocks: a positive number before memory is taken, a negative one
/// after it was given back. Returns false to refuse a positive number. Thread-safe; throws nothing.
using MemoryMonitor = std::function<bool(std::int64_t bytes)>;

/// Memory of one owner, of which a monitor knows. An empty monitor is told nothing.
class MemoryShare {
public:
    explicit MemoryShare(MemoryMonitor monitor = {}, std::uint64_t bytes = 0) : monitor_(std::move(monitor)) {
        reserve(bytes);
    }
    ~MemoryShare() { settle(0); }
    MemoryShare(MemoryShare&& other) noexcept
        : monitor_(std::move(other.monitor_)), bytes_(std::exchange(other.bytes_, 0)) {}
    MemoryShare& operator=(MemoryShare&& other) noexcept {
        std::swap(monitor_, other.monitor_);
        std::swap(bytes_, other.bytes_);
        return *this;
    }

    [[nodiscard]] bool monitored() const noexcept { return static_cast<bool>(monitor_); }
    [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }

    /// Enlarges the share to `bytes` if it is smaller. Throws Error(out_of_memory) if the monitor refuses.
    void reserve(std::uint64_t bytes) {
        if (bytes <= bytes_) return;
        if (monitor_ && !monitor_(static_cast<std::int64_t>(bytes - bytes_)))
            throw Error(ErrorCode::out_of_memory,
                        "the memory monitor refused " + std::to_string(bytes - bytes_) + " bytes");
        bytes_ = bytes;
    }
    /// Sets the share to what its owner holds. A refusal comes too late: the share then stays as it is.
    void settle(std::uint64_t bytes) noexcept {
        if (bytes == bytes_) return;
        const std::int64_t change = static_cast<std::int64_t>(bytes) - static_cast<std::int64_t>(bytes_);
        if (!monitor_ || monitor_(change) || change < 0) bytes_ = bytes;
    }

private:
    MemoryMonitor monitor_;
    std::uint64_t bytes_ = 0;
};

}  // namespace nicol
