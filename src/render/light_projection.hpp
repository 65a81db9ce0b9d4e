// SPDX-License-Identifier: MIT
// project: a scene's distant light as coefficients.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <optional>

#include "harmonics/light_layout.hpp"
#include "render/render.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// The Stokes components that a light has; null: darkness.
[[nodiscard]] LightKind light_kind(const Environment* light);

/// Low orders are kept in the axes of the scene's geometry, for the methods of transfer; all orders in the
/// light's own, for the high orders. Both are scaled, and have one channel where all are equal.
class LightProjection {
public:
    /// As far as changes make it necessary. `rotation`: from the light's axes to the geometry's. Adds its
    /// times and counts to `statistics`.
    void update(const Scene& scene, const RenderOptions& options, const glm::dmat3& rotation,
                Statistics& statistics);

    /// Of the low orders.
    [[nodiscard]] const LightLayout& layout() const { return *layout_; }
    [[nodiscard]] const PshVector& rotated() const noexcept { return rotated_; }
    /// Counts the changes of rotated().
    [[nodiscard]] std::uint64_t rotated_revision() const noexcept { return rotated_revision_; }

    [[nodiscard]] const PshVector& distant() const noexcept { return distant_; }
    /// Counts the changes of distant().
    [[nodiscard]] std::uint64_t distant_revision() const noexcept { return distant_revision_; }
    /// The last order of distant() that is worth rendering: order_low where there is nothing above it.
    [[nodiscard]] int last_order() const noexcept { return last_order_; }

private:
    EnvironmentPtr environment_;  // that light_ was projected from
    bool projected_ = false;
    PshVector light_;  // in the environment's axes, unscaled, windowed
    std::optional<LightLayout> layout_;
    int last_order_ = -1;
    double dering_ = 0;
    std::uint32_t disabled_optimisations_ = 0;
    double scale_ = 1;  // of distant_
    PshVector rotated_;
    glm::dmat3 rotated_by_{1.0};
    std::uint64_t rotated_from_ = 0;  // revision of distant_
    std::uint64_t rotated_revision_ = 0;
    PshVector distant_;
    std::uint64_t distant_revision_ = 0;
};

}  // namespace nicol
