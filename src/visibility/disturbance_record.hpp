// SPDX-License-Identifier: MIT
// Disturbances of several changes of a scene, one after the other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "visibility/disturbed_rays.hpp"

namespace nicol {

/// Balls around everything that was added and removed. Their number stays small, however many changes there
/// are: balls that follow one another in the record are joined, and reach ever farther.
class DisturbanceRecord {
public:
    void add(std::span<const Ball> added, std::span<const Ball> removed);
    /// Returns the number of changes.
    [[nodiscard]] std::size_t changes() const noexcept { return changes_; }
    /// Returns the record, valid until it changes.
    [[nodiscard]] Disturbances disturbances() const { return {.added = added_, .removed = removed_}; }

private:
    std::vector<Ball> added_, removed_;
    std::size_t changes_ = 0;
};

}  // namespace nicol
