// SPDX-License-Identifier: MIT
#include "material/spatial_variation.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"
#include "simd/mixed_bits.hpp"

namespace nicol {
namespace {

float hat(const LayerFactor& factor, float t) {
    const float end = t <= factor.middle ? factor.low : factor.high;
    if (end == factor.middle) return 1;
    if (t <= 0) return 0;
    return std::max(0.0F, (1 / end - 1 / t) / (1 / end - 1 / factor.middle));
}

template <class Needs>
bool any_texture(const SpatialVariation& variation, const Needs& needs) {
    const auto of = [&](const TexturePtr& texture) { return texture != nullptr && needs(*texture); };
    return std::ranges::any_of(variation.textures, of) || of(variation.normal.texture) ||
           of(variation.rotation.directions) || of(variation.opacity);
}

// Values of a texture at sixteen points, with the range of the first channel.
struct LaneValues {
    std::array<Lanes, 4> color;
    float least, most;
};

// Returns whether the factor is a hat that is 0 at all sixteen points.
bool is_zero(const LayerFactor& factor, const LaneValues& of) {
    return factor.kind == LayerFactor::Kind::hat &&
           ((factor.low != factor.middle && of.most <= factor.low) ||
            (factor.high != factor.middle && of.least >= factor.high));
}

// Computes hat() of sixteen values.
[[gnu::always_inline]] inline void hats(const LayerFactor& factor, const LaneVector& t, LaneVector& out) {
    constexpr float little = 1e-6F;  // below any `low`
    const LaneVector inverse = 1.0F / (t > little ? t : LaneVector{} + little);
    const float middle = 1 / factor.middle;
    const float rise = factor.low == factor.middle ? 0 : 1 / (1 / factor.low - middle);
    const float fall = factor.high == factor.middle ? 0 : 1 / (1 / factor.high - middle);
    const LaneVector below = rise == 0 ? LaneVector{} + 1.0F : (1 / factor.low - inverse) * rise;
    const LaneVector above = fall == 0 ? LaneVector{} + 1.0F : (1 / factor.high - inverse) * fall;
    out = t <= factor.middle ? below : above;
    out = out > 0 ? out : LaneVector{};
}

// Computes factor_value() of sixteen values, for factors that are the same for every colour.
[[gnu::always_inline]] inline void scalar_factors(const LayerFactor& factor, const LaneVector& t,
                                                  LaneVector& out) {
    if (factor.kind == LayerFactor::Kind::hat) return hats(factor, t, out);
    out = t > 0 ? t : LaneVector{};
    out = out < 1 ? out : LaneVector{} + 1.0F;
    if (factor.kind == LayerFactor::Kind::complement) out = 1.0F - out;
}

// Returns bits: bit i is set if a, b or c is not 0 in lane i.
[[gnu::always_inline]] inline std::uint32_t not_zero(const LaneVector& a, const LaneVector& b,
                                                     const LaneVector& c) {
    constexpr IntVector each{1 << 0, 1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                             1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
    const LaneVector none{};
    const LaneVector sum = (a > 0 ? a : -a) + (b > 0 ? b : -b) + (c > 0 ? c : -c);
    alignas(64) std::array<std::int32_t, kLanes> bits;
    *reinterpret_cast<IntVector*>(bits.data()) = sum > none ? each : IntVector{};
    for (std::size_t half = kLanes / 2; half > 0; half /= 2)
        for (std::size_t i = 0; i < half; ++i) bits[i] |= bits[i + half];
    return static_cast<std::uint32_t>(bits[0]);
}

[[gnu::always_inline]] inline void weigh(const MaterialLayer& layer, std::span<const LaneValues> values,
                                         LayerWeights& out) {
    out.points = 0;
    for (const LayerFactor& factor : layer.factors)
        if (is_zero(factor, values[factor.texture])) return;
    LaneVector weight[3];
    for (glm::length_t c = 0; c < 3; ++c) weight[c] = LaneVector{} + layer.scale[c];
    for (const LayerFactor& factor : layer.factors) {
        const LaneValues& of = values[factor.texture];
        if (factor.colored()) {
            for (std::size_t c = 0; c < 3; ++c) {
                LaneVector t;
                load(&of.color[c], t);
                if (factor.kind == LayerFactor::Kind::again)
                    t *= (1 - factor.middle) / (1.0F - factor.middle * t);
                weight[c] *= t;
            }
        } else {
            LaneVector t, f;
            load(of.color.data(), t);
            scalar_factors(factor, t, f);
            for (LaneVector& w : weight) w *= f;
        }
    }
    for (std::size_t c = 0; c < 3; ++c) store(&out.value[c], weight[c]);
    out.points = not_zero(weight[0], weight[1], weight[2]);
    out.equal = not_zero(weight[0] - weight[1], weight[0] - weight[2], LaneVector{}) == 0;
}

[[gnu::always_inline]] inline void weigh_all(std::span<const MaterialLayer> layers,
                                             std::span<LaneValues> values, std::span<LayerWeights> out) {
    for (LaneValues& of : values) {
        Lanes least = of.color[0], most = least;
        for (std::size_t half = kLanes / 2; half > 0; half /= 2)
            for (std::size_t i = 0; i < half; ++i) {
                least[i] = least[i] < least[i + half] ? least[i] : least[i + half];
                most[i] = most[i] > most[i + half] ? most[i] : most[i + half];
            }
        of.least = least[0];
        of.most = most[0];
    }
    for (std::size_t l = 0; l < layers.size(); ++l) weigh(layers[l], values, out[l]);
}

}  // namespace

glm::vec3 factor_value(const LayerFactor& factor, const glm::vec4& texture) {
    switch (factor.kind) {
        case LayerFactor::Kind::value:
            return {texture};
        case LayerFactor::Kind::fraction:
            return glm::vec3(std::clamp(texture.x, 0.0F, 1.0F));
        case LayerFactor::Kind::complement:
            return glm::vec3(1 - std::clamp(texture.x, 0.0F, 1.0F));
        case LayerFactor::Kind::again:
            return (1 - factor.middle) * glm::vec3(texture) / (1.0F - factor.middle * glm::vec3(texture));
        case LayerFactor::Kind::hat:
            break;
    }
    return glm::vec3(hat(factor, texture.x));
}

glm::vec3 factor_slope(const LayerFactor& factor, const glm::vec4& texture) {
    if (factor.kind == LayerFactor::Kind::value) return glm::vec3(1);
    if (factor.kind == LayerFactor::Kind::again) {
        const glm::vec3 left = 1.0F - factor.middle * glm::vec3(texture);
        return (1 - factor.middle) / (left * left);
    }
    const bool clamped = texture.x < 0 || texture.x > 1;
    return glm::vec3(clamped ? 0.0F : factor.kind == LayerFactor::Kind::fraction ? 1.0F : -1.0F);
}

bool SpatialVariation::needs_texcoords() const {
    return normal.kind != NormalVariation::Kind::none ||
           any_texture(*this, [](const Texture& texture) { return texture.needs_texcoords(); });
}

bool SpatialVariation::needs_colors(ColorsOf of) const {
    return any_texture(*this, [of](const Texture& texture) { return texture.needs_colors(of); });
}

bool SpatialVariation::needs_footprint() const {
    const auto needs = [](const TexturePtr& texture) {
        return texture != nullptr && texture->needs_footprint();
    };
    return needs(normal.texture) || needs(rotation.directions) || std::ranges::any_of(textures, needs);
}

bool SpatialVariation::present(const TexturePoint& point, float threshold) const {
    if (opacity == nullptr) return true;
    const glm::vec4 value = opacity->at(point);
    const float covered = opacity->channels() == 4 ? value.w : value.x;
    return translucent ? covered > threshold : covered >= 0.5F;
}

float threshold_at(std::uint32_t surface, float b1, float b2) {
    // The two sides of a surface have corners 1 and 2 in opposite order, and weights that differ by rounding.
    constexpr float steps = 1 << 20;
    const auto [low, high] = std::minmax({b1, b2});
    std::uint32_t hash = mixed(surface);
    for (const float weight : {low, high})
        hash = mixed(hash + static_cast<std::uint32_t>(std::clamp(weight, 0.0F, 1.0F) * steps));
    return static_cast<float>(hash >> 8) * 0x1p-24F;
}

void SpatialVariation::weights(const TexturePoint& point, std::span<glm::vec3> out) const {
    std::array<glm::vec4, kMostTextures> values;
    for (std::size_t t = 0; t < textures.size(); ++t) values[t] = textures[t]->at(point);
    for (std::size_t l = 0; l < layers.size(); ++l) {
        glm::vec3 weight = layers[l].scale;
        for (const LayerFactor& factor : layers[l].factors)
            weight *= factor_value(factor, values[factor.texture]);
        out[l] = weight;
    }
}

void SpatialVariation::weights(const TexturePoints& points, std::span<LayerWeights> out) const {
    std::array<LaneValues, kMostTextures> values;
    for (std::size_t t = 0; t < textures.size(); ++t) textures[t]->at_lanes(points, values[t].color);
    dispatch<weigh_all>(std::span(layers), std::span(values).first(textures.size()), out);
}

}  // namespace nicol
