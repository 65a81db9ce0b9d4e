// SPDX-License-Identifier: MIT
// What every test includes: the framework, the standard headers, and checks of errors.
#pragma once

#define DOCTEST_CONFIG_VOID_CAST_EXPRESSIONS  // so that results may be ignored
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "error.hpp"

using std::numbers::pi;

/// An expression as a function without arguments, for error_of() and check_error().
#define CALL(...) [&] { static_cast<void>(__VA_ARGS__); }

/// The message of the nicol::Error that `call` must throw with this code; empty where it throws none.
template <class Call>
std::string error_of(Call&& call, nicol::ErrorCode code = nicol::ErrorCode::invalid_argument) {
    try {
        call();
    } catch (const nicol::Error& e) {
        CHECK_MESSAGE(e.code() == code, e.what());
        return e.what();
    }
    FAIL_CHECK("no error");
    return {};
}

/// Checks that `call` throws nicol::Error with this code and a message that contains every one of `parts`.
template <class Call, class... Parts>
void check_error(nicol::ErrorCode code, Call&& call, const Parts&... parts) {
    const std::string message = error_of(call, code);
    for (const std::string& part : std::vector<std::string>{parts...})
        CHECK_MESSAGE(message.find(part) != std::string::npos, message, " lacks ", part);
}

/// A file of NICOL_TEST_DATA, the folder of third parties' data. Empty, with a message, where it is not
/// there.
inline std::filesystem::path test_data(const std::string& name) {
    const char* folder = std::getenv("NICOL_TEST_DATA");
    const std::filesystem::path file = std::filesystem::path(folder != nullptr ? folder : "") / name;
    if (std::filesystem::exists(file)) return file;
    MESSAGE("skipped: NICOL_TEST_DATA has no " << name);
    return {};
}
