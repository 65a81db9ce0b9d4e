// SPDX-License-Identifier: MIT
// Shadow rays from sixteen points to samples of lights.
#pragma once

#include <cstdint>

#include "geometry/ray_scene.hpp"
#include "light/lane_light.hpp"
#include "shading/glass_shadows.hpp"
#include "shading/pixel_origins.hpp"

namespace nicol {

/// Shadow rays of points. They begin at origins beside the points, so that the points' own surface does not
/// occlude them.
class ShadowRays {
public:
    /// Keeps references to the arguments, which must outlive the object. glass: glass that the scene does not
    /// contain, null for none.
    ShadowRays(const RayScene& scene, const GlassShadows* glass, const LaneVectors& points,
               const LaneVectors& origins)
        : scene_(scene), glass_(glass), points_(points), origins_(origins) {}

    /// Returns whether glass may dim light.
    [[nodiscard]] bool through_glass() const noexcept { return glass_ != nullptr; }

    /// Returns the bits of `points` whose light sample, as seen from the points, is not occluded, and dims
    /// the light that passes glass. Rays end at the samples: parallel to the light's direction they would
    /// pass through a light that is close.
    [[nodiscard]] std::uint32_t visible(LaneLight& light, std::uint32_t points) {
        return visible(light, points, origins_);
    }
    /// Does the same for rays that begin at other origins.
    [[nodiscard]] std::uint32_t visible(LaneLight& light, std::uint32_t points, const LaneVectors& origins);
    /// Returns the same bits of light that was found from the object's origins, and dims nothing.
    [[nodiscard]] std::uint32_t visible_from_origins(const LaneLight& light, std::uint32_t points);

    /// Returns the number of rays.
    [[nodiscard]] std::uint64_t count() const { return count_; }

private:
    std::uint32_t traced(const LaneVectors& origins, std::uint32_t points);

    RayPacket packet_;
    const RayScene& scene_;
    const GlassShadows* glass_;
    const LaneVectors& points_;
    const LaneVectors& origins_;
    std::uint64_t count_ = 0;
};

/// Shadows of one light or lobe with few rays: if the first few samples are visible from all points, or
/// hidden from all points, the other samples are assumed to be so too, unless glass may dim them.
class LightShadows {
public:
    /// rays: null if nothing casts shadows. places: origins of the samples' rays in turn; null: those of
    /// `rays`. probes: number of those first samples; samples that light no point do not count.
    LightShadows(ShadowRays* rays, PixelOrigins* places, std::uint32_t probes)
        : rays_(rays), places_(places), probes_(probes) {}

    /// Returns the bits of `points` that the next light sample reaches, and dims the light that passes glass.
    [[nodiscard]] std::uint32_t reached(LaneLight& light, std::uint32_t points);
    /// Returns the bits of `points` that the only sample of a light reaches from any place, and multiplies
    /// the light by the fraction of the places that it reaches. One ray decides for each point if all points
    /// agree, or if light may pass glass.
    [[nodiscard]] std::uint32_t reached_in_part(LaneLight& light, std::uint32_t points);
    /// Returns whether some points were reached by a sample and some were not, as at the edge of a shadow.
    [[nodiscard]] bool at_edge() const { return seen_ && hidden_; }
    /// Returns the expected squared error of the fractions of reached_in_part(), over the fractions' squares.
    [[nodiscard]] const Lanes& doubts() const { return doubts_; }
    /// Returns whether reached_in_part() may have such an error.
    [[nodiscard]] bool doubtful() const { return doubtful_; }

private:
    using Origins = const LaneVectors& (PixelOrigins::*)(std::size_t place);
    // reached() for rays from a place in the pixels.
    std::uint32_t reached_from(Origins origins, std::size_t place, LaneLight& light, std::uint32_t points);

    Lanes doubts_{};
    ShadowRays* rays_;
    PixelOrigins* places_;
    std::uint32_t probes_;
    std::uint32_t traced_ = 0;
    bool seen_ = false;    // whether any sample is visible from any point
    bool hidden_ = false;  // whether any sample is hidden from any point
    bool doubtful_ = false;
};

}  // namespace nicol
