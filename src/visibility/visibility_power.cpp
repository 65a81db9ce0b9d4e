// SPDX-License-Identifier: MIT
#include "visibility/visibility_power.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "harmonics/psh.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

}  // namespace

VisibilityPower::VisibilityPower(const VisibilityHarmonics& harmonics, const Visibility& visibility,
                                 std::span<const glm::vec3> normals, std::span<const std::uint32_t> vertices)
    : energy_(static_cast<std::size_t>(kOrder) + 1) {
    const DirectionSet& directions = harmonics.directions();
    const std::size_t size = psh_count(kOrder);
    std::vector<Lanes> coefficients((vertices.size() + kLanes - 1) / kLanes * size);
    harmonics.project(visibility, normals, vertices, coefficients);
    double seen = 0;
    double all = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const std::size_t v = vertices[k];
        for (int l = 0; l <= kOrder; ++l) {
            for (int m = -l; m <= l; ++m) {
                const auto value =
                    static_cast<double>(coefficients[k / kLanes * size + psh_index(l, m)][k % kLanes]);
                energy_[static_cast<std::size_t>(l)] += value * value / static_cast<double>(vertices.size());
            }
        }
        for (std::size_t i = 0; i < directions.size(); ++i) {
            if (!(glm::dot(directions.directions()[i], normals[v]) > 0)) continue;
            all += 1;
            if (visibility.seen(v, i)) seen += 1;
        }
    }
    if (all > 0) fraction_ = seen / all;
    // The mean over the last orders keeps an order that happens to vanish from deciding.
    constexpr int tail = 8;
    for (int l = kOrder - tail + 1; l <= kOrder; ++l)
        edge_ += energy_[static_cast<std::size_t>(l)] * l * l / tail;
}

double VisibilityPower::energy(int l) const {
    return l <= kOrder ? energy_[static_cast<std::size_t>(l)] : edge_ / (static_cast<double>(l) * l);
}

OrderCoupling::OrderCoupling(int order, int spin) : order_(order), spin_(spin) {
    for (int to = spin; to <= order; ++to) {
        for (int from = spin; from <= order; ++from) {
            Wigner3jRun& run = runs_.emplace_back(wigner_3j_run(from, to, spin, -spin));
            for (double& symbol : run.value) symbol *= (2 * to + 1) / (4 * pi) * symbol;
        }
    }
}

std::vector<double> OrderCoupling::of(const VisibilityPower& visibility) const {
    std::vector<double> energies;
    for (int l = 0; l <= 2 * order_; ++l) energies.push_back(visibility.energy(l));
    const auto size = static_cast<std::size_t>(order_) + 1;
    std::vector<double> out(size * size);
    auto run = runs_.begin();
    for (int to = spin_; to <= order_; ++to) {
        for (int from = spin_; from <= order_; ++from, ++run) {
            double sum = 0;
            for (std::size_t i = 0; i < run->value.size(); ++i)
                sum += energies[static_cast<std::size_t>(run->first_l1) + i] * run->value[i];
            out[static_cast<std::size_t>(to) * size + static_cast<std::size_t>(from)] = sum;
        }
    }
    return out;
}

}  // namespace nicol
