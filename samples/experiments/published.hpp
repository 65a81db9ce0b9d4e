// SPDX-License-Identifier: MIT
// Reader of arrays published by the paper's authors.
#pragma once

#include <string>

#include "field.hpp"

/// Returns the doubles of member `coeff` of an uncompressed NumPy archive. Throws std::runtime_error naming
/// the file unless there are at least `count`.
Doubles published(const std::string& path, std::size_t count);
