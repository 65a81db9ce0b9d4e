// SPDX-License-Identifier: MIT
// A program that makes a context by its environment variables and prints the outcome: "ok BACKEND RENDERER"
// or "error CODE MESSAGE". The program is separate, because EGL reads its environment once per process.
#include <cstdio>
#include <cstring>

#include "error.hpp"
#include "gl/context.hpp"

int main(int count, char** arguments) {
    nicol::gl::ContextRequest request;
    if (count > 1 && std::strcmp(arguments[1], "egl") == 0) request.backend = nicol::gl::Backend::egl;
    if (count > 1 && std::strcmp(arguments[1], "osmesa") == 0) request.backend = nicol::gl::Backend::osmesa;
    try {
        const auto context = nicol::gl::Context::create(request);
        const nicol::gl::ContextInfo& info = context->info();
        std::printf("ok %s %s\n", info.backend == nicol::gl::Backend::egl ? "egl" : "osmesa",
                    info.renderer.c_str());
        for (const nicol::gl::FailedAttempt& attempt : context->failed_attempts())
            std::printf("failed %s: %s\n", attempt.what.c_str(), attempt.reason.c_str());
    } catch (const nicol::Error& error) {
        std::printf("error %d %s\n", static_cast<int>(error.code()), error.what());
    }
    return 0;
}
