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

}  // namespace nicol::gl

/// A test case that runs once a backend, each time with a fresh `context`.
#define GL_TEST_CASE(title) GL_TEST_CASE_NAMED(title, DOCTEST_ANONYMOUS(run_on_))
#define GL_TEST_CASE_NAMED(title, run)                                   \
    static void run(const std::shared_ptr<nicol::gl::Context>& context); \
    TEST_CASE(title) {                                                   \
        nicol::gl::on_every_backend(run);                                \
    }                                                                    \
    static void run(const std::shared_ptr<nicol::gl::Context>& context)

/// The same, on the context's thread.
#define GL_THREAD_TEST_CASE(title) GL_THREAD_TEST_CASE_NAMED(title, DOCTEST_ANONYMOUS(run_on_))
#define GL_THREAD_TEST_CASE_NAMED(title, test)                            \
    static void test(const std::shared_ptr<nicol::gl::Context>& context); \
    GL_TEST_CASE(title) {                                                 \
        context->run([&] { test(context); });                             \
    }                                                                     \
    static void test(const std::shared_ptr<nicol::gl::Context>& context)
