// SPDX-License-Identifier: MIT
// Which orders of the dense method fit into memory.
#pragma once

#include "stage.hpp"

/// The size of the dense method's matrices grows as (order + 1)^4; measured at a low order and extrapolated.
class DenseMemory {
public:
    explicit DenseMemory(const SceneSource& source);
    /// In gigabytes.
    [[nodiscard]] double at(int order) const;

private:
    double per_entry_ = 0;
};
