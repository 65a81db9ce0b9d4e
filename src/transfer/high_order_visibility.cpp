// SPDX-License-Identifier: MIT
#include "transfer/high_order_visibility.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "material/high_order_gains.hpp"
#include "nicol/error.hpp"
#include "nicol/psh.hpp"

namespace nicol {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int most_order = 64;
// Where nearly all of a lobe lies below the horizon, what is left of it says little.
constexpr float least_part = 0.1F;

float fraction(float seen, float everything) {
    return std::clamp(seen / std::max(everything, least_part), 0.0F, 1.0F);
}

}  // namespace

HighOrderVisibility::HighOrderVisibility(int order, double width, HorizonExtension extension)
    : order_(order) {
    if (order < 0 || order > most_order) {
        throw Error(ErrorCode::invalid_argument, "the order of visibility is " + std::to_string(order) +
                                                     "; it must lie in 0 to " + std::to_string(most_order));
    }
    if (!(width >= 0 && width <= 4)) {
        throw Error(ErrorCode::invalid_argument,
                    "the width of a lobe is " + std::to_string(width) + "; it must lie in 0 to 4 radians");
    }
    // A gain of about 1/4 is left at the last order, so that the lobe hardly rings.
    const OrderGains lobe = gaussian_gains(std::max(width, 1.7 / (order + 1)), 0, order);
    lobe_.assign(lobe.begin(), lobe.end());
    const OrderGains cosine = cosine_gains(0, order);
    // P_l(0), for the integral of P_l over -1..0.
    std::vector<double> p{1, 0};
    for (int l = 1; l <= order; ++l) p.push_back(-l * p[static_cast<std::size_t>(l) - 1] / (l + 1.0));
    for (int l = 0; l <= order; ++l) {
        const auto i = static_cast<std::size_t>(l);
        const double norm = std::sqrt((2 * l + 1) / (4 * pi));
        cosine_.push_back(static_cast<float>(cosine[i] * norm * (l % 2 == 0 ? 1 : -1)));
        double all = l == 0 ? std::sqrt(4 * pi) : 0;
        if (extension == HorizonExtension::dark)
            all = 2 * pi * norm * (l == 0 ? 1 : (p[i + 1] - p[i - 1]) / (2 * l + 1));
        everything_.push_back(static_cast<float>(all));
    }
    for (int m = 0; m <= order; ++m) {
        for (int l = m + 1; l <= order; ++l) {
            const double l2 = l * l;
            const double m2 = m * m;
            const double before = (l - 1.0) * (l - 1.0);
            climb_.push_back(static_cast<float>(std::sqrt((4 * l2 - 1) / (l2 - m2))));
            climb_.push_back(
                static_cast<float>(std::sqrt((2 * l + 1) * (before - m2) / ((2 * l - 3) * (l2 - m2)))));
        }
    }
}

glm::vec2 HighOrderVisibility::at(std::span<const float> visibility, const glm::vec3& d) const {
    const auto v = [&](int l, int m) { return visibility[psh_index(l, m)]; };
    float seen = 0;
    float all = 0;
    float base_seen = 0;
    float base_all = 0;
    const float* climb = climb_.data();
    // Y_lm = P_lm(z) times the real or imaginary part of (x + i y)^m, with the sine powers in the latter.
    auto start = static_cast<float>(1 / std::sqrt(4 * pi));
    float cosine = 1;
    float sine = 0;
    for (int m = 0; m <= order_; ++m) {
        float value = start;
        float before = 0;
        for (int l = m; l <= order_; ++l) {
            if (l > m) {
                const float next = climb[0] * d.z * value - climb[1] * before;
                before = value;
                value = next;
                climb += 2;
            }
            const auto i = static_cast<std::size_t>(l);
            const float scaled = lobe_[i] * value;
            if (m == 0) {
                seen += scaled * v(l, 0);
                all += scaled * everything_[i];
                base_seen += cosine_[i] * v(l, 0);
                base_all += cosine_[i] * everything_[i];
            } else {
                seen += scaled * (cosine * v(l, m) + sine * v(l, -m));
            }
        }
        const auto next = static_cast<float>(m + 1);
        start *= -std::sqrt((2 * next + 1) / (2 * next));
        if (m == 0) start *= std::numbers::sqrt2_v<float>;
        const float turned = cosine * d.x - sine * d.y;
        sine = sine * d.x + cosine * d.y;
        cosine = turned;
    }
    return {fraction(seen, all), fraction(base_seen, base_all)};
}

std::vector<float> HighOrderVisibility::constants() const {
    std::vector<float> all;
    for (const std::vector<float>* table : {&lobe_, &cosine_, &everything_, &climb_}) {
        all.insert(all.end(), table->begin(), table->end());
    }
    return all;
}

void HighOrderVisibility::run(const Viewpoint& view, std::span<const glm::vec3> positions,
                              std::span<const glm::vec3> normals, std::span<const std::uint8_t> visible,
                              std::span<const float> visibility, std::size_t first, std::size_t last,
                              std::span<glm::vec2> out) const {
    const std::size_t size = psh_count(order_);
    for (std::size_t i = first; i < last; ++i) {
        if (visible[i] == 0) continue;
        const Frame frame = theta_phi_frame(glm::dvec3(normals[i]));
        const glm::dvec3 world = view.towards(glm::dvec3(positions[i]));
        const glm::dvec3 v = world * frame;
        glm::dvec3 d(v.x, v.y, -std::max(v.z, 0.0));
        // Straight from behind any direction along the surface serves, as in HighOrder.
        if (glm::dot(d, d) <= 1e-10) d = view.frame(world)[0] * frame;
        out[i] = at(visibility.subspan(i * size, size), glm::vec3(glm::normalize(d)));
    }
}

}  // namespace nicol
