// SPDX-License-Identifier: MIT
#include "harmonics/vector_kernel.hpp"

namespace nicol {

extern const VectorKernel vector_kernel_baseline;
#ifdef NICOL_X86_KERNELS
extern const VectorKernel vector_kernel_avx2;
extern const VectorKernel vector_kernel_avx512;
#endif

namespace {

struct Available {
    const VectorKernel* kernels[3] = {&vector_kernel_baseline};
    int count = 1;

    Available() {
#ifdef NICOL_X86_KERNELS
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
            kernels[count++] = &vector_kernel_avx2;
            if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                __builtin_cpu_supports("avx512vl"))
                kernels[count++] = &vector_kernel_avx512;
        }
#endif
    }
};

const Available& available() {
    static const Available instance;
    return instance;
}

}  // namespace

int vector_kernel_count() {
    return available().count;
}

const VectorKernel& vector_kernel(int i) {
    return *available().kernels[i];
}

const VectorKernel& vector_kernel() {
    return vector_kernel(vector_kernel_count() - 1);
}

}  // namespace nicol
