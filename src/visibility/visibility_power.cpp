// SPDX-License-Identifier: MIT
#include "visibility/visibility_power.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "harmonics/psh.hpp"
#include "harmonics/wigner3j.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
constexpr std::size_t kSamples = 512;

}  // namespace

VisibilityPower::VisibilityPower(const Visibility& visibility, const DirectionSet& directions,
                                 std::span<const glm::vec3> normals)
    : energy_(static_cast<std::size_t>(kOrder) + 1) {
    const VisibilityHarmonics harmonics(directions, kOrder);
    const std::size_t vertices = visibility.vertices();
    const std::size_t samples = std::min(kSamples, vertices);
    std::vector<float> coefficients(psh_count(kOrder));
    double seen = 0;
    double all = 0;
    for (std::size_t k = 0; k < samples; ++k) {
        const std::size_t v = k * vertices / samples;
        harmonics.project(visibility, v, normals[v], coefficients);
        for (int l = 0; l <= kOrder; ++l) {
            for (int m = -l; m <= l; ++m) {
                const auto value = static_cast<double>(coefficients[psh_index(l, m)]);
                energy_[static_cast<std::size_t>(l)] += value * value / static_cast<double>(samples);
            }
        }
        for (std::size_t i = 0; i < directions.size(); ++i) {
            if (!(glm::dot(directions.directions()[i], normals[v]) > 0)) continue;
            all += 1;
            if (visibility.seen(v, i)) seen += 1;
        }
    }
    if (all > 0) fraction_ = seen / all;
}

std::vector<double> VisibilityPower::coupling(int order, int spin) const {
    // The mean over the last orders keeps an order that happens to vanish from deciding.
    constexpr int tail = 8;
    double edge = 0;
    for (int l = kOrder - tail + 1; l <= kOrder; ++l)
        edge += energy_[static_cast<std::size_t>(l)] * l * l / tail;
    const auto energy = [&](int l) {
        return l <= kOrder ? energy_[static_cast<std::size_t>(l)] : edge / (static_cast<double>(l) * l);
    };
    const auto size = static_cast<std::size_t>(order) + 1;
    std::vector<double> out(size * size);
    for (int to = spin; to <= order; ++to) {
        for (int from = spin; from <= order; ++from) {
            const Wigner3jRun run = wigner_3j_run(from, to, spin, -spin);
            double sum = 0;
            for (std::size_t i = 0; i < run.value.size(); ++i)
                sum += energy(run.first_l1 + static_cast<int>(i)) * run.value[i] * run.value[i];
            out[static_cast<std::size_t>(to) * size + static_cast<std::size_t>(from)] =
                (2 * to + 1) / (4 * pi) * sum;
        }
    }
    return out;
}

}  // namespace nicol
