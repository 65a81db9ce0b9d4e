// SPDX-License-Identifier: MIT
// The problem that a refusing function reports.
#pragma once

#include <doctest/doctest.h>

#include "problem.hpp"

template <typename Function>
Problem refused(Function function) {
    try {
        function();
    } catch (const Refusal& refusal) {
        return refusal.problem;
    }
    FAIL("nothing was refused");
    return {};
}
