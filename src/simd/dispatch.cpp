// SPDX-License-Identifier: MIT
#include "simd/dispatch.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace nicol {
namespace {

InstructionSet supported() {
#ifdef __x86_64__
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
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
