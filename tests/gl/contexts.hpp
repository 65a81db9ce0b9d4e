// SPDX-License-Identifier: MIT
// For tests that need OpenGL: every backend, one context each.
#pragma once

#include <cstdlib>
#include <numeric>
#include <optional>
#include <string_view>

#include "gl/context.hpp"
#include "test.hpp"

namespace nicol::gl {

inline constexpr Backend every_backend[] = {Backend::egl, Backend::osmesa};

inline const char* name_of(Backend backend) {
    return backend == Backend::egl ? "egl" : backend == Backend::osmesa ? "osmesa" : "automatic";
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

/// Calls test(context) once a backend where the environment has NICOL_TEST_BACKENDS=all, else once.
template <class Test>
void on_one_backend(Test test) {
    const char* const wanted = std::getenv("NICOL_TEST_BACKENDS");
    if (wanted != nullptr && std::string_view(wanted) == "all") return on_every_backend(test);
    test(make_context(Backend::egl));
}

}  // namespace nicol::gl

/// A test case that `each` calls with fresh contexts.
#define CONTEXT_TEST_CASE(title, each, run)                              \
    static void run(const std::shared_ptr<nicol::gl::Context>& context); \
    TEST_CASE(title) {                                                   \
        nicol::gl::each(run);                                            \
    }                                                                    \
    static void run(const std::shared_ptr<nicol::gl::Context>& context)

/// A test case of what is computed, which is alike on every backend: `tests/run.sh --all` runs it on each,
/// other runs on one.
#define IMAGE_TEST_CASE(title) CONTEXT_TEST_CASE(title, on_one_backend, DOCTEST_ANONYMOUS(run_on_))

/// A test case of OpenGL itself, of contexts, lifetimes or memory: runs once a backend.
#define GL_TEST_CASE(title) CONTEXT_TEST_CASE(title, on_every_backend, DOCTEST_ANONYMOUS(run_on_))

/// The same, on the context's thread.
#define GL_THREAD_TEST_CASE(title) GL_THREAD_TEST_CASE_NAMED(title, DOCTEST_ANONYMOUS(run_on_))
#define GL_THREAD_TEST_CASE_NAMED(title, test)                            \
    static void test(const std::shared_ptr<nicol::gl::Context>& context); \
    GL_TEST_CASE(title) {                                                 \
        context->run([&] { test(context); });                             \
    }                                                                     \
    static void test(const std::shared_ptr<nicol::gl::Context>& context)
