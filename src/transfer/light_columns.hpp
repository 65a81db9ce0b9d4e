// SPDX-License-Identifier: MIT
// Several lights at each of many points.
#pragma once

#include <cstddef>
#include <vector>

#include "simd/lanes.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Lights of points, [point][number][column]: the numbers of a LightLayout in the world's axes, for several
/// lights side by side. The columns fill Lanes; those past the last light are 0.
class LightColumns {
public:
    LightColumns() = default;
    LightColumns(std::size_t points, std::size_t numbers, std::size_t columns)
        : numbers_(numbers), columns_(columns), data_(points * numbers * lanes(), Lanes{}) {}

    [[nodiscard]] std::size_t numbers() const noexcept { return numbers_; }
    [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
    /// Returns the count of Lanes that hold one number of all columns.
    [[nodiscard]] std::size_t lanes() const noexcept { return (columns_ + kLanes - 1) / kLanes; }
    [[nodiscard]] std::size_t points() const noexcept {
        return numbers_ == 0 ? 0 : data_.size() / (numbers_ * lanes());
    }
    /// Returns the lights of one point, [number][Lanes of columns].
    [[nodiscard]] Lanes* at(std::size_t point) { return data_.data() + point * numbers_ * lanes(); }
    [[nodiscard]] const Lanes* at(std::size_t point) const {
        return data_.data() + point * numbers_ * lanes();
    }
    [[nodiscard]] float value(std::size_t point, std::size_t number, std::size_t column) const {
        return at(point)[number * lanes() + column / kLanes][column % kLanes];
    }
    [[nodiscard]] std::size_t bytes() const noexcept { return data_.size() * sizeof(Lanes); }

private:
    std::size_t numbers_ = 0;
    std::size_t columns_ = 0;
    std::vector<Lanes> data_;
};

/// Copies the lights of points from `first` on, as far as there are, to a block of lights, whose channels are
/// the columns.
void get_columns(const LightColumns& from, std::size_t first, VertexLight& light, std::size_t block);
/// Copies a block of lights, whose channels are the columns, to points from `first` on, as far as there are.
void put_columns(const VertexLight& light, std::size_t block, std::size_t first, LightColumns& out);

}  // namespace nicol
