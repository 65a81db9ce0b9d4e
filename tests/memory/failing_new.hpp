// SPDX-License-Identifier: MIT
// A lack of memory on order.
#pragma once

#include <cstdint>

namespace memory_test {

/// Counts allocations that libnicol's own code makes with operator new, on whatever thread. Where a position
/// is given the one there throws std::bad_alloc; where it is lasting, so do all after it.
class Shortage {
public:
    Shortage();
    Shortage(std::int64_t position, bool lasting);
    /// Memory is back.
    ~Shortage();
    Shortage(const Shortage&) = delete;
    Shortage& operator=(const Shortage&) = delete;

    /// Allocations so far.
    [[nodiscard]] std::int64_t count() const;
};

}  // namespace memory_test
