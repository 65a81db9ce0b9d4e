// SPDX-License-Identifier: MIT
// Visibility of a scene that changes, without changes that are too small to be shown.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "visibility/visibility.hpp"

namespace nicol {

/// Visibility that relight and shade use. After a change of the scene most vertices that see something else
/// do so in one or two directions only, less than the bake's directions resolve. Such a vertex keeps the
/// visibility that its light was computed with, and needs no relight. Differences do not add up, because each
/// change compares with the bake of all vertices.
class ShownVisibility {
public:
    /// Shows the bake as it is.
    void show(std::shared_ptr<const Visibility> baked);
    /// Shows a bake, but keeps what is shown of vertices whose visibility differs in at most `negligible`
    /// directions. former: for each vertex, its index in the former bake, or kNoVertex; set to kNoVertex for
    /// all vertices whose shown visibility changes.
    void follow(std::shared_ptr<const Visibility> baked, std::span<std::uint32_t> former,
                std::size_t negligible);

    [[nodiscard]] const Visibility* get() const noexcept { return shown_.get(); }
    /// Returns 1 for each vertex that shows another visibility than its bake's; empty: there are none.
    [[nodiscard]] std::span<const std::uint8_t> lagging() const noexcept { return lagging_; }

private:
    std::shared_ptr<const Visibility> shown_;
    std::vector<std::uint8_t> lagging_;
};

}  // namespace nicol
