// SPDX-License-Identifier: MIT
// One binary for several generations of processors.
#pragma once

// Compiles a function for AVX-512, AVX2 and the baseline, and picks at load time. Sanitizers start after the
// loader has picked, so they get the baseline alone.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define NICOL_MULTIVERSION __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define NICOL_MULTIVERSION
#endif
