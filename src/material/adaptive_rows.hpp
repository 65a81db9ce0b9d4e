// SPDX-License-Identifier: MIT
// Rows of a table by angle, computed where they vary and interpolated elsewhere.
#pragma once

#include <functional>
#include <span>

namespace nicol {

/// Table of rows at evenly spaced angles 0..last.
struct AngleTable {
    std::span<float> data;  ///< [angle][number]
    int last;               ///< a multiple of widest_step, at least three times as large
    int widest_step;        ///< steps between angles that are always computed; a power of 2 times least_step
    int least_step;         ///< least steps between computed angles
    float tolerance;        ///< error of interpolated numbers, relative to the table's largest number

    [[nodiscard]] std::size_t width() const noexcept {
        return data.size() / (static_cast<std::size_t>(last) + 1);
    }
    [[nodiscard]] std::span<float> row(int angle) const {
        return data.subspan(static_cast<std::size_t>(angle) * width(), width());
    }
};

/// Fills a table. compute(angles) must assign the rows of some angles. A row is computed if cubics through
/// the rows around it were not good enough next to it, one step before; else it is such a cubic.
void fill_adaptively(const AngleTable& table,
                     const std::function<void(std::span<const int> angles)>& compute);

}  // namespace nicol
