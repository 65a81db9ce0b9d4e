// SPDX-License-Identifier: MIT
// Projection of a scene's distant light to coefficients.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <optional>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "light/channel_factors.hpp"
#include "light/environment.hpp"
#include "render/kept_projection.hpp"
#include "stage/options.hpp"
#include "stage/statistics.hpp"
#include "versioned.hpp"

namespace nicol {

/// Returns the Stokes components that a light has; null: no light.
[[nodiscard]] LightKind light_kind(const Environment* light);

/// Multiplies light by the window against ringing of RenderOptions::dering. The window is its own transpose.
void suppress_ringing(PshVector& light, double strength);

/// Components and channels that a light is given even if they are zero or equal.
struct LeastLight {
    LightKind kind = LightKind::unpolarized;
    int channels = 1;
    bool operator==(const LeastLight&) const = default;
};

/// Coefficients of the distant light. Low orders are kept in the axes of the scene's geometry, for the
/// transfer methods; all orders are kept in the light's own axes, for the high orders. Both have a part of
/// the light's scale, and have one channel if all channels are multiples of one.
class LightProjection {
public:
    /// Projects the light; repeats only what changes require. environment: the scene's environment, or a part
    /// of it. whole: whether the coefficients have all of the scale, so that factors() are 1.
    /// rotation: from the light's axes to the geometry's. Adds times and counts to `statistics`.
    void update(const EnvironmentPtr& environment, double scale, bool whole, const RenderOptions& options,
                const LeastLight& least, const glm::dmat3& rotation, KeptProjection& projection,
                Statistics& statistics);

    /// Returns the layout of the low orders.
    [[nodiscard]] const LightLayout& layout() const { return *layout_; }
    /// Returns the low orders in the geometry's axes. Another layout means another version, too; a change of
    /// the high orders alone does not.
    [[nodiscard]] const Versioned<PshVector>& rotated() const noexcept { return rotated_; }
    [[nodiscard]] const Versioned<PshVector>& distant() const noexcept { return distant_; }
    /// Returns the part of the scale and of channels that the coefficients do not have. What they light is
    /// multiplied by it, so that a change of the scale relights nothing.
    [[nodiscard]] const ChannelFactors& factors() const noexcept { return factors_; }
    /// Returns the last order of distant() that is not zero, but at least order_low.
    [[nodiscard]] int last_order() const noexcept { return last_order_; }

private:
    void project(const EnvironmentPtr& environment, int low, int high, LightKind kind, int channels,
                 const RenderOptions& options, KeptProjection& projection);

    // Inputs: environment, low and high order, kind, least channels, dering, disabled optimisations.
    Stage<EnvironmentPtr, int, int, LightKind, int, double, std::uint32_t> projecting_;
    Versioned<PshVector> light_;  // coefficients in the environment's axes, unscaled, windowed
    std::optional<LightLayout> layout_;
    int last_order_ = -1;
    Stage<Version, double> checking_, scaling_;  // inputs: light_, scale
    Versioned<PshVector> distant_;
    std::vector<double> ratios_;  // of channels to the only channel of light_; empty: none is shared
    ChannelFactors factors_;
    Stage<Version, glm::dmat3> rotating_;
    std::optional<LightKind> rotated_kind_;  // kind of the layout that rotated_ belongs to
    Versioned<PshVector> rotated_;
};

}  // namespace nicol
