// SPDX-License-Identifier: MIT
// Distant light averaged over solid angles, for samples of lobes.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <vector>

#include "light/environment.hpp"
#include "light/equirect_texels.hpp"
#include "light/lane_light.hpp"

namespace nicol {

/// Images of an environment, each with half as many columns as the one before (a mip map). Immutable; threads
/// share it.
class LightPyramid {
public:
    explicit LightPyramid(const Environment& environment);

    /// Computes the mean radiance within about `solid_angles`, in steradians, around unit directions
    /// `out.towards`, in the environment's axes: out.irradiance, out.x and out.components. Linear between
    /// levels, bilinear in each.
    void look_up(const Lanes& solid_angles, LaneLight& out) const;

    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    [[nodiscard]] static EquirectTexels half_of(const EquirectTexels& level, std::size_t planes);
    [[nodiscard]] static glm::vec4 across_columns(const EquirectTexels& level, std::size_t plane, float turn,
                                                  float half_turn, float columns);

    std::size_t channels_;
    std::size_t components_;
    std::size_t planes_;  // one per channel if the light is polarized, else one per four channels
    std::vector<EquirectTexels> levels_;  // rows are pixel-centred but in the first level
};

}  // namespace nicol
