// SPDX-License-Identifier: MIT
// The floating-point environment that everything here computes in.
#pragma once

#include <cfenv>

namespace nicol {

/// While an object lives, its thread has the environment in which C programs begin: numbers are rounded to
/// nearest, subnormal numbers are kept, and nothing traps. Then the thread's environment is as before, with
/// its flags. Made and destroyed by one thread; threads that it starts inherit the environment.
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
