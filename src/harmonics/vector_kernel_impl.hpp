// SPDX-License-Identifier: MIT
// VectorKernel for vectors of NICOL_LANES doubles; included by one source for each instruction set.
#include "harmonics/fft_kernel.hpp"
#include "harmonics/legendre_kernel.hpp"

namespace nicol {

extern const VectorKernel NICOL_KERNEL;
const VectorKernel NICOL_KERNEL = {synthesize, analyze, fft_stage, multiply_lanes, low_degrees};

}  // namespace nicol
