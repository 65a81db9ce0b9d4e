// SPDX-License-Identifier: MIT
#define NICOL_LANES 8
#define NICOL_VECTORS 4
#define NICOL_SPLIT_VECTORS 3
#define NICOL_KERNEL vector_kernel_avx512
#include "harmonics/vector_kernel_impl.hpp"
