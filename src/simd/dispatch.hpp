// SPDX-License-Identifier: MIT
// Choice of the instruction set at run time, so that one binary serves several generations of processors.
#pragma once

#include <utility>

namespace nicol {

/// Instruction sets, each of which contains the one before. baseline: the instructions that every processor
/// of the architecture has (SSE2 on x86-64).
enum class InstructionSet { baseline, avx2, avx512 };

/// Returns the best instruction set of this processor, limited by the environment variable
/// NICOL_INSTRUCTION_SET (baseline, avx2 or avx512) if the variable is set at the first call.
[[nodiscard]] InstructionSet instruction_set();

namespace detail {

template <auto Loop, class Signature = decltype(Loop)>
struct Compiled;

// The target attribute of a function also applies to functions inlined into it, and `Loop` is always inlined.
template <auto Loop, class Result, class... Parameters>
struct Compiled<Loop, Result (*)(Parameters...)> {
    static Result baseline(Parameters... parameters) { return Loop(std::forward<Parameters>(parameters)...); }
#ifdef __x86_64__
    [[gnu::target("avx2,fma,bmi,bmi2")]] static Result avx2(Parameters... parameters) {
        return Loop(std::forward<Parameters>(parameters)...);
    }
#ifdef __clang__
    // Without this attribute Clang splits vectors of 512 bits into pairs of 256.
    [[clang::min_vector_width(512)]]
#endif
    [[gnu::target("avx2,fma,bmi,bmi2,avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]] static Result
    avx512(Parameters... parameters) {
        return Loop(std::forward<Parameters>(parameters)...);
    }
#endif
};

}  // namespace detail

/// Calls a function that is compiled for each instruction set. The function must be [[gnu::always_inline]],
/// and so must the functions it calls that matter for speed: other functions, lambdas included, are compiled
/// for the baseline unless the compiler happens to inline them. Vectors wider than 16 bytes are passed and
/// returned by reference. Give three functions if an instruction set needs source of its own.
template <auto Baseline, auto Avx2 = Baseline, auto Avx512 = Avx2, class... Arguments>
decltype(auto) dispatch(Arguments&&... arguments) {
#ifdef __x86_64__
    switch (instruction_set()) {
        case InstructionSet::avx512:
            return detail::Compiled<Avx512>::avx512(std::forward<Arguments>(arguments)...);
        case InstructionSet::avx2:
            return detail::Compiled<Avx2>::avx2(std::forward<Arguments>(arguments)...);
        case InstructionSet::baseline:
            break;
    }
#endif
    return detail::Compiled<Baseline>::baseline(std::forward<Arguments>(arguments)...);
}

}  // namespace nicol
