// SPDX-License-Identifier: MIT
// Arrays that the paper's authors published.
#pragma once

#include <string>

#include "field.hpp"

/// The doubles of member `coeff` of a NumPy archive that is not compressed. Throws std::runtime_error naming
/// the file unless there are `count` of them.
Doubles published(const std::string& path, std::size_t count);
