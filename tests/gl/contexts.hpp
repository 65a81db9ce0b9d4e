// SPDX-License-Identifier: MIT
// Contexts and test-case macros for tests that need OpenGL, one context per backend.
#pragma once

#include <cstdlib>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "backends.hpp"
#include "gl/context.hpp"
#include "test.hpp"

namespace nicol::gl {

/// Returns the backends that tests of OpenGL itself run on.
inline std::vector<Backend> every_backend() {
    if (test::wanted_backends() == "egl") return {Backend::egl};
    return {Backend::egl, Backend::osmesa};
}

inline const char* name_of(Backend backend) {
    return backend == Backend::egl ? "egl" : backend == Backend::osmesa ? "osmesa" : "automatic";
}

/// Returns the bytes of all kinds together.
inline std::size_t total_bytes(const MemoryUse& use) {
    return std::accumulate(use.bytes.begin(), use.bytes.end(), std::size_t{0});
}

/// Returns a new context of that backend. A failure fails the test.
inline std::shared_ptr<Context> make_context(Backend backend) {
    return Context::create({backend, std::nullopt});
}

/// Calls test(context) once per backend, inside a doctest note of its name.
template <class Test>
void on_every_backend(Test test) {
    for (const Backend backend : every_backend()) {
        CAPTURE(name_of(backend));
        test(make_context(backend));
    }
}

/// Calls test(context) once per backend if NICOL_TEST_BACKENDS is "all", else once with EGL.
template <class Test>
void on_one_backend(Test test) {
    if (test::wanted_backends() == "all") return on_every_backend(test);
    test(make_context(Backend::egl));
}

/// Returns the factor of tolerances: 10 on graphics processors, which interpolate and filter with fewer bits
/// than the processor does.
inline double tolerance_of(const std::shared_ptr<Context>& context) {
    return context->info().software ? 1 : 10;
}

}  // namespace nicol::gl

/// A test case that runs under `each` with new contexts.
#define CONTEXT_TEST_CASE(title, each, run)                              \
    static void run(const std::shared_ptr<nicol::gl::Context>& context); \
    TEST_CASE(title) {                                                   \
        nicol::gl::each(run);                                            \
    }                                                                    \
    static void run(const std::shared_ptr<nicol::gl::Context>& context)

/// A test case of computed images, which are equal on every backend. `tests/run.sh --all` runs it on every
/// backend, and other runs on one.
#define IMAGE_TEST_CASE(title) CONTEXT_TEST_CASE(title, on_one_backend, DOCTEST_ANONYMOUS(run_on_))

/// A test case of OpenGL itself, contexts, lifetimes or memory, run once per backend.
#define GL_TEST_CASE(title) CONTEXT_TEST_CASE(title, on_every_backend, DOCTEST_ANONYMOUS(run_on_))

/// A GL_TEST_CASE that runs on the context's thread.
#define GL_THREAD_TEST_CASE(title) GL_THREAD_TEST_CASE_NAMED(title, DOCTEST_ANONYMOUS(run_on_))
#define GL_THREAD_TEST_CASE_NAMED(title, test)                            \
    static void test(const std::shared_ptr<nicol::gl::Context>& context); \
    GL_TEST_CASE(title) {                                                 \
        context->run([&] { test(context); });                             \
    }                                                                     \
    static void test(const std::shared_ptr<nicol::gl::Context>& context)
