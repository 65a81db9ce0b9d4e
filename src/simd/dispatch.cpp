// SPDX-License-Identifier: MIT
#include "simd/dispatch.hpp"

#ifdef __x86_64__
#include <cpuid.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace nicol {
namespace {

#ifdef __x86_64__
// Clang 14's __builtin_cpu_supports() does not know F16C.
bool supports_f16c() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    return __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_F16C) != 0;
}
#endif

InstructionSet supported() {
#ifdef __x86_64__
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") && supports_f16c();
    const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                        __builtin_cpu_supports("avx512vl");
    if (avx2) return avx512 ? InstructionSet::avx512 : InstructionSet::avx2;
#endif
    return InstructionSet::baseline;
}

InstructionSet allowed() {
    const char* const text = std::getenv("NICOL_INSTRUCTION_SET");
    const std::string_view name = text == nullptr ? "" : text;
    if (name == "baseline") return InstructionSet::baseline;
    if (name == "avx2") return InstructionSet::avx2;
    return InstructionSet::avx512;
}

}  // namespace

InstructionSet instruction_set() {
    static const InstructionSet set = std::min(supported(), allowed());
    return set;
}

}  // namespace nicol
