// SPDX-License-Identifier: MIT
#include "visibility/visibility_directions.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>

#include "error.hpp"
#include "harmonics/evaluate.hpp"
#include "harmonics/psh.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

std::vector<glm::dvec3> fibonacci_lattice(int count) {
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1) / static_cast<double>(count);
        const double rho = std::sqrt(1 - z * z);
        const double phi = 2 * pi * std::fmod(i / std::numbers::phi, 1.0);
        directions.emplace_back(rho * std::cos(phi), rho * std::sin(phi), z);
    }
    return directions;
}

// Returns the place of a direction on a curve that fills the sphere: the interleaved bits of its two
// coordinates on the unfolded octahedron.
std::uint32_t place(const glm::dvec3& d) {
    const double norm = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    double u = d.x / norm;
    double v = d.y / norm;
    if (d.z < 0) {
        const double folded = std::copysign(1 - std::abs(v), u);
        v = std::copysign(1 - std::abs(u), v);
        u = folded;
    }
    const auto cell = [](double x) {
        return static_cast<std::uint32_t>(std::clamp((x + 1) * 512, 0.0, 1023.0));
    };
    const std::uint32_t column = cell(u);
    const std::uint32_t row = cell(v);
    std::uint32_t out = 0;
    for (int bit = 0; bit < 10; ++bit) {
        out |= (column >> bit & 1U) << (2 * bit) | (row >> bit & 1U) << (2 * bit + 1);
    }
    return out;
}

// Returns the weights nearest to equal ones that integrate all harmonics of the order. The harmonics on the
// lattice are nearly orthogonal, so subtracting the projected error converges quickly.
std::vector<double> exact_weights(const std::vector<glm::dvec3>& directions, int order) {
    const double equal = 4 * pi / static_cast<double>(directions.size());
    const std::size_t count = psh_count(order);
    std::vector<double> harmonics(count * directions.size());
    std::vector<std::complex<double>> unused(count);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        harmonics_at(order, directions[i], std::span(harmonics).subspan(i * count, count), unused);
    }
    std::vector<double> weights(directions.size(), equal);
    std::vector<double> moments(count);
    for (int step = 0; step < 50; ++step) {
        std::ranges::fill(moments, 0.0);
        for (std::size_t i = 0; i < directions.size(); ++i) {
            for (std::size_t k = 0; k < count; ++k) moments[k] += weights[i] * harmonics[i * count + k];
        }
        moments[0] -= std::sqrt(4 * pi);
        const double worst = std::abs(
            *std::ranges::max_element(moments, [](double a, double b) { return std::abs(a) < std::abs(b); }));
        if (worst < 1e-13) break;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            for (std::size_t k = 0; k < count; ++k)
                weights[i] -= equal * harmonics[i * count + k] * moments[k];
        }
    }
    return weights;
}

}  // namespace

DirectionSet::DirectionSet(int count) {
    if (count < kFewest || count > kMost) {
        throw Error(ErrorCode::invalid_argument, std::to_string(count) + " directions; there must be " +
                                                     std::to_string(kFewest) + " to " +
                                                     std::to_string(kMost));
    }
    std::vector<glm::dvec3> lattice = fibonacci_lattice(count);
    std::ranges::stable_sort(lattice, {}, place);
    const int order = std::min(kExactOrder, static_cast<int>(std::sqrt(count) / 2));
    for (const double weight : exact_weights(lattice, order)) weights_.push_back(static_cast<float>(weight));
    for (const glm::dvec3& direction : lattice) directions_.emplace_back(direction);
    fill_bundles();
}

DirectionSet DirectionSet::rotated(const glm::dmat3& axes) const {
    DirectionSet out = *this;
    for (glm::vec3& direction : out.directions_)
        direction = glm::vec3(glm::normalize(axes * glm::dvec3(direction)));
    out.fill_bundles();
    return out;
}

void DirectionSet::fill_bundles() {
    bundles_.resize((size() + RayBundle::kRays - 1) / RayBundle::kRays);
    for (std::size_t i = 0; i < bundles_.size() * RayBundle::kRays; ++i) {
        const glm::vec3& direction = directions_[std::min(i, size() - 1)];
        RayBundle& bundle = bundles_[i / RayBundle::kRays];
        bundle.x[i % RayBundle::kRays] = direction.x;
        bundle.y[i % RayBundle::kRays] = direction.y;
        bundle.z[i % RayBundle::kRays] = direction.z;
    }
}

}  // namespace nicol
