// SPDX-License-Identifier: MIT
// Counts the OpenGL calls of a context of Nicol's inside a host.
#pragma once

#include <cstdint>

/// Numbers of OpenGL calls since the last reset_gl_calls().
struct GlCalls {
    std::uint64_t all = 0;
    std::uint64_t queries =
        0;  ///< calls that ask for state: glGet... and glIs... but glGetError and reads of data
    std::uint64_t errors = 0;  ///< calls of glGetError
};

/// Returns a function that counts its calls and calls `function`, an address of the OpenGL function `name`;
/// `function` itself if the loader has no such name.
void* counted_gl(const char* name, void* function);
void reset_gl_calls();
GlCalls gl_calls();
