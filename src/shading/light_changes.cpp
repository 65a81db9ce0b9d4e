// SPDX-License-Identifier: MIT
#include "shading/light_changes.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "shading/normal_variation.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_parts.hpp"

namespace nicol {
namespace {

template <class Number>
[[gnu::always_inline]] inline void scale_all(const Lanes& factors, float by, LaneLight& light) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Number factor;
        load_part(factors, first, factor);
        factor *= by;
        for (std::array<Lanes, 4>& of_channel : light.irradiance)
            for (std::size_t p = 0; p < light.components; ++p) {
                Number value;
                load_part(of_channel[p], first, value);
                store_part(Number(value * factor), first, of_channel[p]);
            }
    }
}

}  // namespace

std::uint32_t above(const LaneVectors& facets, const LaneLight& light) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float rise = facets.x[i] * light.towards.x[i] + facets.y[i] * light.towards.y[i] +
                           facets.z[i] * light.towards.z[i];
        out |= (rise > 0 ? 1U : 0U) << i;
    }
    return out;
}

void scale(const Lanes& factors, LaneLight& light, float by) {
    dispatch<scale_all<FourLanes>, scale_all<EightLanes>, scale_all<AllLanes>>(factors, by, light);
}

void hide(std::uint32_t points, LaneLight& light) {
    if (points == 0) return;
    Lanes factors;
    for (std::size_t i = 0; i < kLanes; ++i) factors[i] = (points >> i & 1U) != 0 ? 0.0F : 1.0F;
    scale(factors, light);
}

void give_channels(std::size_t channels, LaneLight& light) {
    if (light.irradiance.size() >= channels) return;
    const std::array<Lanes, 4> grey = light.irradiance.front();
    light.irradiance.resize(channels, grey);
}

void add_unpolarized(std::span<const std::array<Lanes, 4>> irradiance, LaneLight& light) {
    give_channels(irradiance.size(), light);
    for (std::size_t c = 0; c < light.irradiance.size(); ++c) {
        const Lanes& other = irradiance[irradiance.size() == 1 ? 0 : c][0];
        for (std::size_t i = 0; i < kLanes; ++i) light.irradiance[c][0][i] += other[i];
    }
}

Lanes brightness(const LaneLight& light) {
    Lanes out{};
    for (const std::array<Lanes, 4>& of_channel : light.irradiance)
        for (std::size_t i = 0; i < kLanes; ++i) out[i] += of_channel[0][i];
    return out;
}

Lanes only(std::uint32_t points, const Lanes& numbers) {
    Lanes out;
    for (std::size_t i = 0; i < kLanes; ++i) out[i] = numbers[i] * static_cast<float>(points >> i & 1U);
    return out;
}

void dim_at_slant(std::span<const glm::vec3> unperturbed, std::span<const glm::vec3> normals,
                  LaneLight& light) {
    Lanes factors{};
    for (std::size_t i = 0; i < unperturbed.size(); ++i) {
        const glm::vec3 towards = vector_at(light.towards, i);
        factors[i] =
            terminator_shadowing(glm::dot(unperturbed[i], normals[i]), glm::dot(unperturbed[i], towards));
    }
    scale(factors, light);
}

void scatter(std::span<const glm::vec3> normals, const Lanes& variances, const Lanes& u, const Lanes& v,
             LaneLight& light) {
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::vec3 middle = vector_at(light.towards, i);
        // Any axis across the direction serves, because the disc is round.
        const glm::vec3 other = std::abs(middle.z) < 0.7F ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
        const glm::vec3 x = glm::normalize(glm::cross(middle, other));
        const float radius = 2 * std::sqrt(variances[i] * u[i]);  // of an even disc of the same variance
        const float angle = 2 * std::numbers::pi_v<float> * v[i];
        const glm::vec3 away = std::cos(angle) * x + std::sin(angle) * glm::cross(middle, x);
        const glm::vec3 place = glm::normalize(middle + radius * away);
        if (glm::dot(place, normals[i]) > 0) put(light.towards, i, place);
    }
}

}  // namespace nicol
