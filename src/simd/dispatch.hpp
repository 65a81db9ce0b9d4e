// SPDX-License-Identifier: MIT
// One binary for several generations of processors: which instruction set runs is decided once, at run time.
#pragma once

#include <utility>

namespace nicol {

/// Each contains the one before. baseline: what every processor of the architecture has (SSE2 on x86-64).
enum class InstructionSet { baseline, avx2, avx512 };

/// The best one that this processor runs, but not above NICOL_INSTRUCTION_SET (baseline, avx2 or avx512)
/// where the environment has that variable at the first call.
[[nodiscard]] InstructionSet instruction_set();

namespace detail {

template <auto Loop, class Signature = decltype(Loop)>
struct Compiled;

// What a function is compiled for reaches what is inlined into it, and `Loop` always is.
template <auto Loop, class Result, class... Parameters>
struct Compiled<Loop, Result (*)(Parameters...)> {
    static Result baseline(Parameters... parameters) { return Loop(std::forward<Parameters>(parameters)...); }
#ifdef __x86_64__
    [[gnu::target("avx2,fma,bmi,bmi2")]] static Result avx2(Parameters... parameters) {
        return Loop(std::forward<Parameters>(parameters)...);
    }
#ifdef __clang__
    // Without this, vectors of 512 bits become pairs of 256.
    [[clang::min_vector_width(512)]]
#endif
    [[gnu::target("avx2,fma,bmi,bmi2,avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]] static Result
    avx512(Parameters... parameters) {
        return Loop(std::forward<Parameters>(parameters)...);
    }
#endif
};

}  // namespace detail

/// Calls a function that is compiled for each instruction set. It must be [[gnu::always_inline]], and so must
/// what it calls that matters for speed: the rest, lambdas included, is compiled for the baseline unless the
/// compiler happens to inline it. Vectors wider than 16 bytes are passed and returned by reference. Three
/// functions where an instruction set needs source of its own.
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
