// SPDX-License-Identifier: MIT
// Visibility of the environment at each vertex.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "visibility/visibility_directions.hpp"

namespace nicol {

/// Index of no vertex.
inline constexpr std::uint32_t kNoVertex = ~std::uint32_t{0};

/// One bit for every vertex and direction of a DirectionSet: 1 if the environment is visible. Directions
/// below the horizon of the vertex (of its shading normal) have 0.
class Visibility {
public:
    Visibility() = default;
    /// Makes visibility with all bits zero.
    Visibility(std::size_t directions, std::size_t vertices)
        : directions_(directions),
          words_((directions + 63) / 64),
          bits_(words_ * vertices),
          unoccluded_(vertices) {}

    /// Takes over the bits() and unoccluded() of another object.
    Visibility(std::size_t directions, std::vector<std::uint64_t> bits, std::vector<std::uint8_t> unoccluded)
        : directions_(directions),
          words_((directions + 63) / 64),
          bits_(std::move(bits)),
          unoccluded_(std::move(unoccluded)) {}

    [[nodiscard]] std::size_t vertices() const noexcept { return unoccluded_.size(); }
    [[nodiscard]] std::size_t directions() const noexcept { return directions_; }

    /// Returns the bits of one vertex: direction i is bit i % 64 of word i / 64; bits past the last direction
    /// are 0.
    [[nodiscard]] std::span<const std::uint64_t> at(std::size_t vertex) const {
        return {bits_.data() + vertex * words_, words_};
    }
    [[nodiscard]] std::span<std::uint64_t> at(std::size_t vertex) {
        return {bits_.data() + vertex * words_, words_};
    }
    [[nodiscard]] bool seen(std::size_t vertex, std::size_t direction) const {
        return (at(vertex)[direction / 64] >> (direction % 64) & 1) != 0;
    }

    /// Returns whether nothing above the vertex's horizon is blocked.
    [[nodiscard]] bool unoccluded(std::size_t vertex) const { return unoccluded_[vertex] != 0; }
    void set_unoccluded(std::size_t vertex, bool value) { unoccluded_[vertex] = value ? 1 : 0; }
    /// Gives a vertex what another object, of as many directions, holds of its vertex `source`.
    void take(std::size_t vertex, const Visibility& from, std::size_t source) {
        std::ranges::copy(from.at(source), at(vertex).begin());
        set_unoccluded(vertex, from.unoccluded(source));
    }
    [[nodiscard]] std::size_t unoccluded_count() const;

    /// Returns the visibility of these vertices, in this order.
    [[nodiscard]] Visibility selected(std::span<const std::uint32_t> vertices) const;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return bits_.size() * sizeof(std::uint64_t) + unoccluded_.size();
    }
    [[nodiscard]] std::span<const std::uint64_t> bits() const noexcept { return bits_; }
    /// Returns 1 for each unoccluded vertex, else 0.
    [[nodiscard]] std::span<const std::uint8_t> unoccluded() const noexcept { return unoccluded_; }

private:
    std::size_t directions_ = 0;
    std::size_t words_ = 0;  // number of words per vertex
    std::vector<std::uint64_t> bits_;
    std::vector<std::uint8_t> unoccluded_;
};

}  // namespace nicol
