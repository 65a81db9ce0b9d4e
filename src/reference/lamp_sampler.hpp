// SPDX-License-Identifier: MIT
// Places of the surfaces that shine.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "reference/traced_surface.hpp"

namespace nicol {

/// Samples places evenly by area: of every surface that shines while there are few of them, else of one that
/// is chosen in proportion to its power.
class LampSampler {
public:
    /// More lamps than this share one sample.
    static constexpr std::size_t kFew = 16;

    /// Those that are black are left out.
    explicit LampSampler(std::span<const TracedSurface> surfaces);

    /// Samples to take for each point that is lit.
    [[nodiscard]] std::size_t samples() const noexcept;
    /// A place for the sample with this index, `point` in [0, 1)^2: a hit without its distance.
    [[nodiscard]] RayHit sample(std::size_t index, glm::dvec2 point) const;
    /// The density of all samples together on a surface, by area; 0 where none are taken.
    [[nodiscard]] double density(std::uint32_t surface) const { return densities_[surface]; }

private:
    struct Lamp {
        std::uint32_t surface;
        std::vector<double> areas;  ///< of triangles, cumulative
        double power;
    };
    std::vector<Lamp> lamps_;
    std::vector<double> powers_;     ///< cumulative
    std::vector<double> densities_;  ///< by surface
};

}  // namespace nicol
