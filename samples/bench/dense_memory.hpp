// SPDX-License-Identifier: MIT
// Which orders of the dense method fit into memory.
#pragma once

#include "stage.hpp"

/// Bytes that the dense method's matrices take grow as (order + 1)^4; measured at a low order, told for
/// others.
class DenseMemory {
public:
    explicit DenseMemory(const Workshop& workshop);
    /// In gigabytes.
    [[nodiscard]] double at(int order) const;

private:
    double per_entry_ = 0;
};
