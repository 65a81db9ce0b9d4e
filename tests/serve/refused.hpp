// SPDX-License-Identifier: MIT
// What a function refuses.
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
