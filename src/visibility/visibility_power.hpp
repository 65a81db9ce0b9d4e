// SPDX-License-Identifier: MIT
// Effect of shadows on the power spectra of responses.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/visibility.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol {

/// Mean power spectrum of the visibility over a scene's vertices, from a sample of them.
class VisibilityPower {
public:
    /// Highest order that is projected. Above it, the spectrum is assumed to fall with the square of l, as
    /// for edges.
    static constexpr int kOrder = 24;

    VisibilityPower(const Visibility& visibility, const DirectionSet& directions,
                    std::span<const glm::vec3> normals);

    /// Returns the visible fraction of the directions above the horizon, as the mean over the vertices.
    [[nodiscard]] double fraction() const noexcept { return fraction_; }

    /// Returns the coupling of orders when a response of this spin (0 or 2) is multiplied by the visibility,
    /// as the mean over all rotations between them. The energy of the product in order `to` is the sum over
    /// `from` of the response's energy in order `from` times coupling[to (order + 1) + from].
    [[nodiscard]] std::vector<double> coupling(int order, int spin) const;

private:
    double fraction_ = 1;
    std::vector<double> energy_;  // energy by order, 0 to kOrder
};

}  // namespace nicol
