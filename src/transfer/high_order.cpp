// SPDX-License-Identifier: MIT
#include "transfer/high_order.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "nicol/error.hpp"

namespace nicol {
namespace {

constexpr int most_channels = 16;
using Probed = std::array<glm::vec4, most_channels>;

void require(bool condition, const std::string& what) {
    if (!condition) throw Error(ErrorCode::invalid_argument, what);
}

// The blocks (0,0) (1,0) (0,1) (1,1) and (2,2) (3,2) (2,3) (3,3) of a mirror-symmetric factor.
glm::vec4 even_product(const float* first, const float* rest, const glm::vec4& s) {
    return {first[0] * s[0] + rest[0] * s[1], first[1] * s[0] + rest[1] * s[1],
            rest[2] * s[2] + rest[4] * s[3], rest[3] * s[2] + rest[5] * s[3]};
}

// The blocks that change sign with the side.
glm::vec4 odd_product(const float* first, const float* rest, const glm::vec4& s) {
    return {rest[0] * s[2] + rest[4] * s[3], rest[1] * s[2] + rest[5] * s[3],
            first[0] * s[0] + rest[2] * s[1], first[1] * s[0] + rest[3] * s[1]};
}

}  // namespace

HighOrder::HighOrder(const HighOrderFactors& factors, const HighOrderMaps& maps,
                     const glm::dmat3& light_to_world)
    : factors_(factors), maps_(maps), world_to_light_(glm::transpose(light_to_world)) {
    require(maps.centre != nullptr, "high orders need a map for the mirror direction");
    require(factors.spread() == 0 || maps.around != nullptr,
            "high orders need a map around the mirror direction");
    require(!factors.normal() || maps.normal != nullptr, "high orders need a map for the normal");
    for (const LobeMap* map : {maps.centre, maps.around, maps.normal}) {
        if (map == nullptr) continue;
        require(map->channels() == maps.centre->channels() && map->channels() >= 1 &&
                    map->channels() <= most_channels,
                "the maps of high orders must have the same 1 to " + std::to_string(most_channels) +
                    " channels; one has " + std::to_string(map->channels()));
        require(map->polarized() == maps.centre->polarized(),
                "the maps of high orders must be all polarized or all not");
    }
    require(factors.channels() == 1 || maps.centre->channels() == 1 ||
                factors.channels() == maps.centre->channels(),
            "factors of " + std::to_string(factors.channels()) + " channels cannot serve maps of " +
                std::to_string(maps.centre->channels()));
}

void HighOrder::look_up(const Viewpoint& view, const glm::vec3& position, const glm::vec3& normal,
                        const glm::vec2& visible_fraction, std::span<glm::vec4> out) const {
    const glm::dvec3 n = normal;
    const glm::dvec3 v = view.towards(glm::dvec3(position));
    const glm::dvec3 camera = view.frame(v)[0];
    // A normal that faces away is treated as seen at 90 degrees, from anywhere if it does so exactly.
    const double cosine = glm::dot(n, v);
    glm::dvec3 seen = v;
    if (cosine < 0) {
        seen -= cosine * n;
        seen = glm::dot(seen, seen) > 1e-10 ? glm::normalize(seen) : camera;
    }
    const glm::dvec3 d = seen - 2 * std::max(cosine, 0.0) * n;
    // Seen head-on, every plane is one of incidence.
    glm::dvec3 x = glm::cross(n, seen);
    x = glm::dot(x, x) > 1e-10 ? glm::normalize(x) : camera;
    const glm::dvec3 y = glm::cross(d, x);

    Probed centre;
    Probed up;
    Probed down;
    Probed sum;
    Probed difference;
    Probed base;
    const auto channels = static_cast<std::size_t>(maps_.centre->channels());
    const auto probe = [&](const LobeMap& map, const glm::dvec3& direction, const glm::dvec3& axis,
                           Probed& to) {
        map.look_up(glm::vec3(world_to_light_ * direction), glm::vec3(world_to_light_ * axis),
                    std::span(to).first(channels));
    };
    probe(*maps_.centre, d, x, centre);
    const bool around = factors_.spread() > 0;
    if (around) {
        const double c = std::cos(factors_.spread());
        const double s = std::sin(factors_.spread());
        probe(*maps_.around, c * d + s * y, x, up);
        probe(*maps_.around, c * d - s * y, x, down);
        probe(*maps_.around, c * d + s * x, c * x - s * d, sum);
        probe(*maps_.around, c * d - s * x, c * x + s * d, difference);
        for (std::size_t i = 0; i < channels; ++i) {
            const glm::vec4 left = difference[i];
            difference[i] = sum[i] - left;
            sum[i] += left;
        }
    }
    if (factors_.normal()) probe(*maps_.normal, -n, x, base);

    // From the s-frame to the camera's, as cos and sin of twice the angle.
    const double c = glm::dot(camera, x);
    const double s = glm::dot(camera, glm::cross(v, x));
    const auto cos2 = static_cast<float>(c * c - s * s);
    const auto sin2 = static_cast<float>(2 * c * s);
    std::array<float, HighOrderFactors::kElements> f{};
    const bool polarized = maps_.centre->polarized();
    const std::size_t used = polarized ? f.size() : HighOrderFactors::kUnpolarized;
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (i == 0 || factors_.channels() > 1)
            factors_.at(static_cast<float>(cosine), static_cast<int>(i), std::span(f).first(used));
        const std::size_t light = channels == 1 ? 0 : i;
        constexpr auto rest = static_cast<std::size_t>(HighOrderFactors::kUnpolarized);
        glm::vec4 lobe = even_product(&f[0], &f[rest], centre[light]);
        if (around) {
            lobe += even_product(&f[2], &f[rest + 6], up[light]) +
                    even_product(&f[4], &f[rest + 12], down[light]) +
                    even_product(&f[6], &f[rest + 18], sum[light]) +
                    odd_product(&f[8], &f[rest + 24], difference[light]);
        }
        lobe *= visible_fraction[0];
        if (factors_.normal()) lobe += visible_fraction[1] * base[light][0] * glm::vec4(f[10], f[11], 0, 0);
        out[i] = {lobe[0], cos2 * lobe[1] + sin2 * lobe[2], cos2 * lobe[2] - sin2 * lobe[1], lobe[3]};
    }
}

void HighOrder::run(const Viewpoint& view, std::span<const glm::vec3> positions,
                    std::span<const glm::vec3> normals, std::span<const std::uint8_t> visible,
                    std::span<const glm::vec2> visible_fraction, std::size_t first, std::size_t last,
                    std::span<const std::span<glm::vec4>> out) const {
    require(out.size() >= 1 && out.size() <= most_channels,
            "high orders of " + std::to_string(out.size()) + " channels");
    Probed stokes;
    for (std::size_t v = first; v < last; ++v) {
        if (visible[v] == 0) continue;
        const glm::vec2 fraction = visible_fraction.empty() ? glm::vec2(1.0F) : visible_fraction[v];
        look_up(view, positions[v], normals[v], fraction, std::span(stokes).first(out.size()));
        for (std::size_t c = 0; c < out.size(); ++c) out[c][v] += stokes[c];
    }
}

}  // namespace nicol
