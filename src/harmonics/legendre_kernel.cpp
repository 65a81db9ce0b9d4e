// SPDX-License-Identifier: MIT
#include "harmonics/legendre_kernel.hpp"

namespace nicol {

extern const LegendreKernel legendre_kernel_baseline;
#ifdef NICOL_X86_KERNELS
extern const LegendreKernel legendre_kernel_avx2;
extern const LegendreKernel legendre_kernel_avx512;
#endif

const LegendreKernel& legendre_kernel() {
#ifdef NICOL_X86_KERNELS
    static const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    static const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (avx512) return legendre_kernel_avx512;
    if (avx2) return legendre_kernel_avx2;
#endif
    return legendre_kernel_baseline;
}

}  // namespace nicol
