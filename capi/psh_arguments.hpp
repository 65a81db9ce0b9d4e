// SPDX-License-Identifier: MIT
// Checks of arguments of nicol_psh.h, whose arrays are pointers and lengths.
#pragma once

#include <cstdint>
#include <span>

#include "boundary.hpp"
#include "harmonics/psh.hpp"
#include "nicol_psh.h"

namespace nicol::capi {

/// Reads an order. Throws Error(invalid_argument) naming it unless it is at most `highest`.
int read_order(std::uint32_t order, const char* name, std::uint32_t highest = NICOL_PSH_MAX_ORDER);

/// Largest work space of one call, in bytes: twice the need of order 4096 on the grid of that order.
inline constexpr std::uint64_t kMaxWorkBytes = std::uint64_t{1} << 32;

/// Returns the number of coefficients of one vector.
[[nodiscard]] inline std::uint64_t vector_size(int order) {
    return 4 * psh_count(order);
}

/// Returns input of `vectors` items of `size` doubles. Throws Error(invalid_argument) naming the array if it
/// is NULL, has another length or a value that is not finite.
std::span<const double> read_array(const double* values, std::uint64_t count, std::uint64_t vectors,
                                   std::uint64_t size, const char* name);

/// Returns output of `vectors` items of `size` doubles, which is not read. Throws Error(invalid_argument)
/// naming the array if it is NULL or has another length.
std::span<double> write_array(double* values, std::uint64_t count, std::uint64_t vectors, std::uint64_t size,
                              const char* name);

/// Throws Error(invalid_argument) if the two arrays share memory.
void require_apart(std::span<const double> in, std::span<const double> out, const char* what);
/// Throws Error(invalid_argument) if the two arrays share memory but are not identical.
void require_same_or_apart(std::span<const double> in, std::span<const double> out, const char* what);

}  // namespace nicol::capi
