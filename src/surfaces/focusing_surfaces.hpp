// SPDX-License-Identifier: MIT
// Surfaces that send the light of local lights on to others, and places on them where paths begin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surfaces/geometry.hpp"

namespace nicol {

/// Triangles of one smooth material.
struct FocusingSurface {
    std::size_t range;
    std::vector<std::uint32_t> triangles;
    std::vector<double> areas;  ///< cumulative, the last above 0

    /// Start of a path.
    struct Place {
        std::uint32_t triangle;
        double b1, b2;  ///< barycentric weights of corners 1 and 2
        double choice;  ///< from 0 to 1, spread evenly over paths that begin near each other
    };
    /// Returns the place where path i of `count` begins. Triangles have paths in proportion to their areas,
    /// each by a sequence of its own.
    [[nodiscard]] Place place(std::size_t i, std::size_t count) const;
};

/// Returns whether surfaces of a material send the light of local lights on to others: smooth glass, and
/// mirrors without textures.
[[nodiscard]] bool focuses_light(const Material& material);

/// Returns the surfaces that cast shadows and focus light: one for each side of a two-sided surface.
[[nodiscard]] std::vector<FocusingSurface> focusing_surfaces(const WorldGeometry& geometry);

}  // namespace nicol
