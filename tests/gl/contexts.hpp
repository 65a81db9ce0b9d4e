// SPDX-License-Identifier: MIT
// For tests that need OpenGL: every backend, one context each.
#pragma once

#include <numeric>
#include <optional>

#include "gl/context.hpp"
#include "test.hpp"

namespace nicol::gl {

inline constexpr Backend every_backend[] = {Backend::egl, Backend::osmesa};

inline const char* name_of(Backend backend) {
    switch (backend) {
        case Backend::egl:
            return "egl";
        case Backend::osmesa:
            return "osmesa";
        case Backend::host:
        case Backend::automatic:
            break;
    }
    return "automatic";
}

/// Of all kinds together.
inline std::size_t total_bytes(const MemoryUse& use) {
    return std::accumulate(use.bytes.begin(), use.bytes.end(), std::size_t{0});
}

/// A fresh context of that backend; failing to make one fails the test.
inline std::shared_ptr<Context> make_context(Backend backend) {
    return Context::create({backend, std::nullopt});
}

/// Calls test(context) once a backend, inside a doctest note of its name.
template <class Test>
void on_every_backend(Test test) {
    for (const Backend backend : every_backend) {
        CAPTURE(name_of(backend));
        test(make_context(backend));
    }
}

}  // namespace nicol::gl
