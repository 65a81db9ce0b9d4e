// SPDX-License-Identifier: MIT
// Measurement in a process of its own, with cold caches.
#pragma once

#include <functional>
#include <vector>

/// The result of `measure` in a fork of this process, which must not have started threads. Throws
/// std::runtime_error with the message of its exception.
std::vector<double> in_child(const std::function<std::vector<double>()>& measure);
