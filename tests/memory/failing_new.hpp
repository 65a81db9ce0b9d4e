// SPDX-License-Identifier: MIT
// A lack of memory on order.
#pragma once

#include <cstdint>

namespace memory_test {

/// The allocations that a Shortage counts.
enum class Reach : std::uint8_t {
    library,  ///< operator new in libnicol's own code, on any thread
    thread    ///< operator new and malloc in any library but libc, on the thread of the Shortage
};

/// Counts allocations. If a position is given, the allocation there fails, and all later ones if it is
/// lasting.
class Shortage {
public:
    explicit Shortage(Reach reach = Reach::library);
    Shortage(std::int64_t position, bool lasting, Reach reach = Reach::library);
    /// Memory is back.
    ~Shortage();
    Shortage(const Shortage&) = delete;
    Shortage& operator=(const Shortage&) = delete;

    /// Allocations so far.
    [[nodiscard]] std::int64_t count() const;
};

}  // namespace memory_test
