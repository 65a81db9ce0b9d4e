// SPDX-License-Identifier: MIT
#include "transfer/vertex_view.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>

#include "nicol/stokes.hpp"

namespace nicol {

VertexView::VertexView(const LightLayout& layout)
    : powers_cos_(static_cast<std::size_t>(layout.order()) + 1),
      powers_sin_(powers_cos_.size()),
      cosine_(layout.size()),
      sine_(layout.size()) {
    for (const LightLayout::Entry& e : layout.entries()) frequency_.push_back(e.azimuthal_frequency());
}

void VertexView::look(const Viewpoint& view, const glm::vec3& position, const glm::vec3& normal) {
    const Frame surface = theta_phi_frame(glm::dvec3(normal));
    const glm::dvec3 world = view.towards(glm::dvec3(position));
    const glm::dvec3 local = world * surface;  // transposed times world
    const double rho = std::hypot(local.x, local.y);
    zenith_ = std::atan2(rho, local.z);

    const std::complex<double> turn =
        rho > 0 ? std::complex<double>(local.x, local.y) / rho : std::complex<double>(1);
    std::complex<double> power = 1;
    for (std::size_t m = 0; m < powers_cos_.size(); ++m) {
        powers_cos_[m] = static_cast<float>(power.real());
        powers_sin_[m] = static_cast<float>(power.imag());
        power = {power.real() * turn.real() - power.imag() * turn.imag(),
                 power.real() * turn.imag() + power.imag() * turn.real()};
    }
    for (std::size_t j = 0; j < frequency_.size(); ++j) {
        const int k = frequency_[j];
        const auto m = static_cast<std::size_t>(std::abs(k));
        cosine_[j] = powers_cos_[m];
        sine_[j] = k < 0 ? -powers_sin_[m] : powers_sin_[m];
    }

    // cos and sin of twice the angle between the frames.
    const Frame from = surface * theta_phi_frame(local);
    const glm::dvec3 x = view.frame(world)[0];
    const double c = glm::dot(x, from[0]);
    const double s = glm::dot(x, from[1]);
    cos2_ = static_cast<float>(c * c - s * s);
    sin2_ = static_cast<float>(2 * c * s);
}

VertexView::TablePosition VertexView::position_in(int angles) const {
    const double x = std::min(zenith_ / (std::numbers::pi / 2), 1.0) * (angles - 1);
    const int angle = std::min(static_cast<int>(x), angles - 2);
    return {angle, static_cast<float>(x - angle)};
}

}  // namespace nicol
