// SPDX-License-Identifier: MIT
// Vectors of NICOL_LANES doubles for the sources that are compiled once for each instruction set. Those must
// not include a header with inline functions: the linker could pick their copy of one for a processor that
// cannot run it.
#pragma once

#include "harmonics/vector_kernel.hpp"

namespace nicol {
namespace {

constexpr int kLanes = NICOL_LANES;
typedef double Vector __attribute__((vector_size(8 * kLanes)));
typedef long long Mask __attribute__((vector_size(8 * kLanes)));
typedef double Unaligned __attribute__((vector_size(8 * kLanes), aligned(8), may_alias));

inline const Unaligned& at(const double* p) {
    return *reinterpret_cast<const Unaligned*>(p);
}
inline Unaligned& at(double* p) {
    return *reinterpret_cast<Unaligned*>(p);
}

}  // namespace
}  // namespace nicol
