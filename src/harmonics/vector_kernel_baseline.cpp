// SPDX-License-Identifier: MIT
#define NICOL_LANES 2
#define NICOL_VECTORS 2
#define NICOL_SPLIT_VECTORS 2
#define NICOL_KERNEL vector_kernel_baseline
#include "harmonics/vector_kernel_impl.hpp"
