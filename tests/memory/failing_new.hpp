// SPDX-License-Identifier: MIT
// Simulated shortages of memory.
#pragma once

#include <cstdint>

namespace memory_test {

/// The allocations that a Shortage counts.
enum class Reach : std::uint8_t {
    library,  ///< operator new in libnicol's own code, on any thread
    thread    ///< operator new and malloc in any library but libc, on the thread of the Shortage
};

/// A counter of allocations. If a position is given, the allocation at that position fails, and all later
/// ones fail if the shortage is lasting.
class Shortage {
public:
    explicit Shortage(Reach reach = Reach::library);
    Shortage(std::int64_t position, bool lasting, Reach reach = Reach::library);
    /// Ends the shortage.
    ~Shortage();
    Shortage(const Shortage&) = delete;
    Shortage& operator=(const Shortage&) = delete;

    /// Returns the number of allocations so far.
    [[nodiscard]] std::int64_t count() const;
};

}  // namespace memory_test
