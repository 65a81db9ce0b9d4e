// SPDX-License-Identifier: MIT
// Effect of shadows on the power spectra of responses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "harmonics/wigner3j.hpp"
#include "visibility/visibility.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol {

/// Mean power spectrum of the visibility at vertices.
class VisibilityPower {
public:
    /// Highest order that is projected. Above it, the spectrum is assumed to fall with the square of l, as
    /// for edges.
    static constexpr int kOrder = 24;

    /// harmonics: of order kOrder. normals: of all vertices. vertices: at least one.
    VisibilityPower(const VisibilityHarmonics& harmonics, const Visibility& visibility,
                    std::span<const glm::vec3> normals, std::span<const std::uint32_t> vertices);

    /// Returns the visible fraction of the directions above the horizon, as the mean over the vertices.
    [[nodiscard]] double fraction() const noexcept { return fraction_; }
    /// Returns the energy of an order.
    [[nodiscard]] double energy(int l) const;

private:
    double fraction_ = 1;
    std::vector<double> energy_;  // energy by order, 0 to kOrder
    double edge_ = 0;             // energy of higher orders, times the square of the order
};

/// Coupling of orders when a response of this spin (0 or 2) is multiplied by visibility, as the mean over all
/// rotations between them.
class OrderCoupling {
public:
    OrderCoupling(int order, int spin);

    /// Returns the coupling: the energy of the product in order `to` is the sum over `from` of the response's
    /// energy in order `from` times out[to (order + 1) + from].
    [[nodiscard]] std::vector<double> of(const VisibilityPower& visibility) const;

private:
    int order_, spin_;
    std::vector<Wigner3jRun> runs_;  // squared, times the degrees, [to][from]
};

}  // namespace nicol
