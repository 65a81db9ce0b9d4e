// SPDX-License-Identifier: MIT
#define NICOL_LANES 8
#define NICOL_VECTORS 4
#define NICOL_KERNEL legendre_kernel_avx512
#include "harmonics/legendre_kernel_impl.hpp"
