// SPDX-License-Identifier: MIT
#define NICOL_LANES 4
#define NICOL_VECTORS 2
#define NICOL_KERNEL legendre_kernel_avx2
#include "harmonics/legendre_kernel_impl.hpp"
