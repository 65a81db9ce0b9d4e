// SPDX-License-Identifier: MIT
// The floating-point environment of all computations in Nicol.
#pragma once

#include <cfenv>

namespace nicol {

/// Guard that gives its thread the environment in which C programs begin: numbers are rounded to nearest,
/// subnormal numbers are kept, and no operation traps. The destructor restores the thread's previous
/// environment and its flags. One thread constructs and destroys the object; threads that this thread starts
/// inherit the environment.
class FloatingEnvironment {
public:
    FloatingEnvironment() noexcept {
        std::fegetenv(&before_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~FloatingEnvironment() { std::fesetenv(&before_); }
    FloatingEnvironment(const FloatingEnvironment&) = delete;
    FloatingEnvironment& operator=(const FloatingEnvironment&) = delete;

private:
    std::fenv_t before_{};
};

}  // namespace nicol
