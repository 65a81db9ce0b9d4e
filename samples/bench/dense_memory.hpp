// SPDX-License-Identifier: MIT
// The memory use of the dense method by order.
#pragma once

#include "stage.hpp"

/// Size of the dense method's matrices, which grows as (order + 1)^4; measured at a low order and
/// extrapolated.
class DenseMemory {
public:
    explicit DenseMemory(const SceneSource& source);
    /// Returns the size in gigabytes.
    [[nodiscard]] double at(int order) const;

private:
    double per_entry_ = 0;
};
