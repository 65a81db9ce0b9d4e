// SPDX-License-Identifier: MIT
// What each vertex sees of the environment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "visibility/visibility_directions.hpp"

namespace nicol {

/// A bit for every vertex and direction of a DirectionSet: 1 where the environment is seen. Directions that
/// are not above the vertex's horizon (its shading normal's) are 0.
class Visibility {
public:
    Visibility() = default;
    /// All zero.
    Visibility(std::size_t directions, std::size_t vertices)
        : directions_(directions),
          words_((directions + 63) / 64),
          bits_(words_ * vertices),
          open_(vertices) {}

    /// What bits() and open() of another gave.
    Visibility(std::size_t directions, std::vector<std::uint64_t> bits, std::vector<std::uint8_t> open)
        : directions_(directions),
          words_((directions + 63) / 64),
          bits_(std::move(bits)),
          open_(std::move(open)) {}

    [[nodiscard]] std::size_t vertices() const noexcept { return open_.size(); }
    [[nodiscard]] std::size_t directions() const noexcept { return directions_; }

    /// Direction i is bit i % 64 of word i / 64; bits past the last direction are 0.
    [[nodiscard]] std::span<const std::uint64_t> at(std::size_t vertex) const {
        return {bits_.data() + vertex * words_, words_};
    }
    [[nodiscard]] std::span<std::uint64_t> at(std::size_t vertex) {
        return {bits_.data() + vertex * words_, words_};
    }
    [[nodiscard]] bool seen(std::size_t vertex, std::size_t direction) const {
        return (at(vertex)[direction / 64] >> (direction % 64) & 1) != 0;
    }

    /// Nothing above the vertex's horizon is blocked.
    [[nodiscard]] bool unoccluded(std::size_t vertex) const { return open_[vertex] != 0; }
    void set_unoccluded(std::size_t vertex, bool open) { open_[vertex] = open ? 1 : 0; }
    [[nodiscard]] std::size_t unoccluded_count() const;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return bits_.size() * sizeof(std::uint64_t) + open_.size();
    }
    [[nodiscard]] std::span<const std::uint64_t> bits() const noexcept { return bits_; }
    [[nodiscard]] std::span<const std::uint8_t> open() const noexcept { return open_; }

private:
    std::size_t directions_ = 0;
    std::size_t words_ = 0;  // of one vertex
    std::vector<std::uint64_t> bits_;
    std::vector<std::uint8_t> open_;
};

}  // namespace nicol
