// SPDX-License-Identifier: MIT
#define NICOL_LANES 2
#define NICOL_VECTORS 2
#define NICOL_KERNEL legendre_kernel_baseline
#include "harmonics/legendre_kernel_impl.hpp"
