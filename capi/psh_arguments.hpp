// SPDX-License-Identifier: MIT
// Checked arguments of the mathematics: every array is a pointer and a length.
#pragma once

#include <cstdint>
#include <span>

#include "boundary.hpp"
#include "harmonics/psh.hpp"
#include "nicol_psh.h"

namespace nicol::capi {

/// An order of the interface. Throws Error(invalid_argument) naming it unless it is at most `highest`.
int read_order(std::uint32_t order, const char* name, std::uint32_t highest = NICOL_PSH_MAX_ORDER);

/// Work space, in bytes, that one call may take: twice what order 4096 needs on its own grid.
inline constexpr std::uint64_t kMaxWorkBytes = std::uint64_t{1} << 32;

/// Coefficients of one vector.
[[nodiscard]] inline std::uint64_t vector_size(int order) {
    return 4 * psh_count(order);
}

/// `vectors` items of `size` doubles that the library reads. Throws Error(invalid_argument) naming the array
/// where it is NULL, has another length or a value that is not finite.
std::span<const double> read_array(const double* values, std::uint64_t count, std::uint64_t vectors,
                                   std::uint64_t size, const char* name);

/// The same that the library writes; nothing is read.
std::span<double> write_array(double* values, std::uint64_t count, std::uint64_t vectors, std::uint64_t size,
                              const char* name);

/// Throws Error(invalid_argument) where the two share memory.
void require_apart(std::span<const double> in, std::span<const double> out, const char* what);
/// The same, but they may be the very same memory.
void require_same_or_apart(std::span<const double> in, std::span<const double> out, const char* what);

}  // namespace nicol::capi
