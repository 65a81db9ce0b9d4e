// SPDX-License-Identifier: MIT
// OpenGL backends that tests run on.
#pragma once

#include <cstdlib>
#include <string_view>

namespace nicol::test {

/// Returns the value of NICOL_TEST_BACKENDS: "all", "egl" on machines that have EGL alone, or "".
inline std::string_view wanted_backends() {
    const char* const wanted = std::getenv("NICOL_TEST_BACKENDS");
    return wanted != nullptr ? wanted : "";
}

}  // namespace nicol::test
