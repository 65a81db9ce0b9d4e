// SPDX-License-Identifier: MIT
// Measurement in a process of its own, where nothing is warm.
#pragma once

#include <functional>
#include <vector>

/// The numbers that `measure` returns in a fork of this process, which must not have threads yet. Throws
/// std::runtime_error with the message of what it throws.
std::vector<double> in_child(const std::function<std::vector<double>()>& measure);
