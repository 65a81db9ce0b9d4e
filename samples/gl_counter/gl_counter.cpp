// SPDX-License-Identifier: MIT
#include "gl_counter.hpp"

#include <glad/gl.h>

#include <array>
#include <string_view>

namespace {

// Each function's own position in kFunctions.
enum Position : std::size_t {
#define GL_FUNCTION(type, name) position_of_##name,
#include "gl_functions.inc"
#undef GL_FUNCTION
    position_count
};

std::array<std::uint64_t, position_count> counts{};

template <std::size_t position, class Function>
struct Counted;

template <std::size_t position, class Result, class... Arguments>
struct Counted<position, Result(GLAD_API_PTR*)(Arguments...)> {
    static inline Result(GLAD_API_PTR* real)(Arguments...) = nullptr;
    static Result GLAD_API_PTR call(Arguments... arguments) {
        ++counts[position];
        return real(arguments...);
    }
    static void* wrap(void* function) {
        real = reinterpret_cast<Result(GLAD_API_PTR*)(Arguments...)>(function);
        return reinterpret_cast<void*>(&call);
    }
};

struct Named {
    std::string_view name;
    void* (*wrap)(void* function);
};

constexpr std::array<Named, position_count> kFunctions{{
#define GL_FUNCTION(type, name) {"gl" #name, Counted<position_of_##name, type>::wrap},
#include "gl_functions.inc"
#undef GL_FUNCTION
}};

bool asks_for_state(std::string_view name) {
    const bool reads = name.ends_with("Image") || name.ends_with("SubData");
    return !reads && (name.starts_with("glGet") || name.starts_with("glIs"));
}

}  // namespace

void* counted_gl(const char* name, void* function) {
    if (function == nullptr) return nullptr;
    for (const Named& known : kFunctions)
        if (known.name == name) return known.wrap(function);
    return function;
}

void reset_gl_calls() {
    counts.fill(0);
}

GlCalls gl_calls() {
    GlCalls calls;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const std::string_view name = kFunctions[i].name;
        calls.all += counts[i];
        if (name == "glGetError")
            calls.errors += counts[i];
        else if (asks_for_state(name))
            calls.queries += counts[i];
    }
    return calls;
}
