// SPDX-License-Identifier: MIT
// What shadows do to the spectra of responses.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/visibility.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol {

/// The mean power spectrum of the visibility of a scene's vertices, from a sample of them.
class VisibilityPower {
public:
    /// Up to here the spectrum is projected; above, it falls as that of edges does, with the square of l.
    static constexpr int kOrder = 24;

    VisibilityPower(const Visibility& visibility, const DirectionSet& directions,
                    std::span<const glm::vec3> normals);

    /// The visible part of the directions above the horizon, mean over the vertices.
    [[nodiscard]] double fraction() const noexcept { return fraction_; }

    /// What a response of this spin (0 or 2) has after it is multiplied by the visibility, as the mean over
    /// all rotations between both: its energy in order `to` is the sum over `from` of the energy before it in
    /// that order times coupling[to (order + 1) + from].
    [[nodiscard]] std::vector<double> coupling(int order, int spin) const;

private:
    double fraction_ = 1;
    std::vector<double> energy_;  // by order, to kOrder
};

}  // namespace nicol
