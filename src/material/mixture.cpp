// SPDX-License-Identifier: MIT
#include "material/mixture.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "error.hpp"
#include "material/reflectance.hpp"
#include "material/texture_numbers.hpp"

namespace nicol {
namespace {

// Least roughness. A narrower lobe looks the same at any order that light is projected to.
constexpr double kLeastAlpha = 0.01;
/// Ratio of neighbouring roughnesses. Interpolation half-way between two alphas of this ratio has an error of
/// about 1 % in the rows of a response.
constexpr double kAlphaRatio = 1.2;
/// Most numbers of each of two textures, because every pair of numbers gets a layer.
constexpr std::size_t kMostOfPair = 8;

bool is_anisotropic(const MaterialLayer& layer) {
    return layer.material->anisotropic();
}

SpatialVariation parts_of(const MaterialPtr& material, const char* of) {
    require(material != nullptr, std::string(of) + ": the material is null; give one");
    if (material->smooth_boundary() != nullptr)
        throw Error(
            ErrorCode::unsupported,
            "a material that light passes is part of a blend, a mask or a normal map, or is scaled by "
            "a texture; use it alone");
    if (const SpatialVariation* variation = material->variation()) return *variation;
    SpatialVariation out;
    out.layers.push_back({.material = material});
    return out;
}

void require_texture(const TexturePtr& texture, const char* of) {
    require(texture != nullptr, std::string(of) + ": the texture is null; give one");
}

std::size_t index_of(const TexturePtr& texture, SpatialVariation& variation) {
    const auto found = std::ranges::find(variation.textures, texture);
    const auto index = static_cast<std::size_t>(found - variation.textures.begin());
    if (index == variation.textures.size()) variation.textures.push_back(texture);
    return index;
}

/// Multiplies all layers by a factor that depends on a texture.
void multiply(SpatialVariation& variation, LayerFactor factor, const TexturePtr& texture) {
    if (texture->constant()) {
        const glm::vec3 value = factor_value(factor, texture->mean());
        for (MaterialLayer& layer : variation.layers) layer.scale *= value;
        std::erase_if(variation.layers,
                      [](const MaterialLayer& layer) { return layer.scale == glm::vec3(0); });
        return;
    }
    factor.texture = index_of(texture, variation);
    for (MaterialLayer& layer : variation.layers) layer.factors.push_back(factor);
}

/// Appends the layers of `from` to `to`. Unless `to` has no layers yet, both must have the same normal
/// variation and the same opacity, and if both are anisotropic the same rotation.
void append(const SpatialVariation& from, SpatialVariation& to, const char* of) {
    const bool first = to.layers.empty();
    require(first || (from.normal == to.normal && from.opacity == to.opacity &&
                      from.translucent == to.translucent),
            std::string(of) +
                ": the parts have normal maps, bump maps or opacities of their own; give them to the whole");
    if (first || std::ranges::any_of(from.layers, is_anisotropic)) {
        require(
            from.rotation == to.rotation || std::ranges::none_of(to.layers, is_anisotropic),
            std::string(of) + ": the parts' axes are rotated in different ways; rotate those of the whole");
        to.rotation = from.rotation;
    }
    to.normal = from.normal;
    to.opacity = from.opacity;
    to.translucent = from.translucent;
    for (MaterialLayer layer : from.layers) {
        for (LayerFactor& factor : layer.factors)
            factor.texture = index_of(from.textures[factor.texture], to);
        to.layers.push_back(std::move(layer));
    }
}

/// Returns make(t) for each of the numbers, interpolated by the texture's value at a point.
MaterialPtr interpolated(const std::function<MaterialPtr(double t)>& make, const TexturePtr& texture,
                         const std::vector<double>& numbers) {
    SpatialVariation out;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        SpatialVariation part = parts_of(make(numbers[i]), "with_number");
        if (numbers.size() > 1)
            multiply(part,
                     {.kind = LayerFactor::Kind::hat,
                      .texture = 0,
                      .low = static_cast<float>(numbers[i == 0 ? 0 : i - 1]),
                      .middle = static_cast<float>(numbers[i]),
                      .high = static_cast<float>(numbers[std::min(i + 1, numbers.size() - 1)])},
                     texture);
        append(part, out, "with_number");
    }
    return mixture(std::move(out));
}

}  // namespace

namespace {

MaterialPtr multiplied(const MaterialPtr& material, const LayerFactor& factor, const TexturePtr& scale) {
    SpatialVariation out = parts_of(material, "scaled");
    require_texture(scale, "scaled");
    const SpatialVariation whole = out;
    multiply(out, factor, scale);
    // A material scaled by 0 keeps one layer, which is black.
    if (out.layers.empty()) {
        out.layers.push_back(whole.layers.front());
        out.layers.front().scale = glm::vec3(0);
        out.layers.front().factors.clear();
    }
    return mixture(std::move(out));
}

}  // namespace

MaterialPtr scaled(const MaterialPtr& material, const TexturePtr& scale) {
    return scaled_by(LayerFactor::Kind::value, material, scale);
}

MaterialPtr scaled_by(LayerFactor::Kind kind, const MaterialPtr& material, const TexturePtr& scale) {
    return multiplied(material, {.kind = kind, .texture = 0}, scale);
}

MaterialPtr scaled_again(const MaterialPtr& material, const TexturePtr& scale, double again) {
    check_range(again, 0, 0.999, "again");
    return multiplied(material,
                      {.kind = LayerFactor::Kind::again, .texture = 0, .middle = static_cast<float>(again)},
                      scale);
}

MaterialPtr sum(const MaterialPtr& first, const MaterialPtr& second) {
    SpatialVariation out = parts_of(first, "sum");
    append(parts_of(second, "sum"), out, "sum");
    return mixture(std::move(out));
}

MaterialPtr blend(const MaterialPtr& first, const MaterialPtr& second, const TexturePtr& weight) {
    require_texture(weight, "blend");
    SpatialVariation a = parts_of(first, "blend");
    SpatialVariation b = parts_of(second, "blend");
    multiply(a, {.kind = LayerFactor::Kind::complement, .texture = 0}, weight);
    multiply(b, {.kind = LayerFactor::Kind::fraction, .texture = 0}, weight);
    SpatialVariation out;
    if (!a.layers.empty()) append(a, out, "blend");
    if (!b.layers.empty()) append(b, out, "blend");
    return mixture(std::move(out));
}

MaterialPtr with_number(const std::function<MaterialPtr(double t)>& make, const TexturePtr& texture,
                        double least, double ratio) {
    require_texture(texture, "with_number");
    return interpolated(make, texture, texture_numbers(*texture, least, ratio));
}

MaterialPtr with_roughness(const std::function<MaterialPtr(double u, double v)>& make,
                           const TexturePtr& alpha_u, const TexturePtr& alpha_v) {
    require_texture(alpha_u, "with_roughness");
    require_texture(alpha_v, "with_roughness");
    const auto alphas = [](const Texture& texture) {
        return texture_numbers(texture, kLeastAlpha, kAlphaRatio, kMostOfPair);
    };
    const std::vector<double> alphas_v = alphas(*alpha_v);
    const auto along_v = [&](double u) {
        return interpolated([&](double v) { return make(u, v); }, alpha_v, alphas_v);
    };
    return interpolated(along_v, alpha_u, alphas(*alpha_u));
}

MaterialPtr with_roughness(const std::function<MaterialPtr(double alpha)>& make, const TexturePtr& alpha) {
    return with_number(make, alpha, kLeastAlpha, kAlphaRatio);
}

MaterialPtr normal_mapped(MaterialPtr material, TexturePtr normals, const MapOptions& options) {
    SpatialVariation out = parts_of(material, "normal map");
    require_texture(normals, "normal map");
    require(normals->channels() >= 3,
            "normal map: the texture has 1 channel; expected 3, the normal's x, y and z");
    require(out.normal.kind == NormalVariation::Kind::none,
            "normal map: the material has a normal or bump map already");
    const glm::vec3 mean(normals->mean());
    const bool flat = normals->constant() && mean.x == 0.5F && mean.y == 0.5F && mean.z > 0.5F;
    if (flat) return material;
    out.normal = {.kind = NormalVariation::Kind::map,
                  .texture = std::move(normals),
                  .mirrored_y = options.mirrored_y,
                  .reversed_back = options.reversed_back || material->twosided(),
                  .shadowed = options.shadowed};
    return mixture(std::move(out));
}

MaterialPtr bump_mapped(MaterialPtr material, TexturePtr heights, double scale, const MapOptions& options) {
    SpatialVariation out = parts_of(material, "bump map");
    require_texture(heights, "bump map");
    require(std::isfinite(scale), "bump map: the scale is not finite");
    require(out.normal.kind == NormalVariation::Kind::none,
            "bump map: the material has a normal or bump map already");
    if (heights->constant() || scale == 0) return material;
    out.normal = {.kind = NormalVariation::Kind::bump,
                  .texture = std::move(heights),
                  .scale = scale,
                  .reversed_back = options.reversed_back || material->twosided(),
                  .shadowed = options.shadowed};
    return mixture(std::move(out));
}

MaterialPtr rotated(const MaterialPtr& material, TexturePtr directions, double angle) {
    SpatialVariation out = parts_of(material, "rotation");
    require(std::isfinite(angle), "rotation: the angle is not finite");
    require(directions == nullptr || directions->channels() >= 3,
            "rotation: the texture has 1 channel; expected 3, of which the first two are the direction");
    require(!out.rotation.any(), "rotation: the material's axes are rotated already");
    if (!material->anisotropic()) return material;
    out.rotation = {.directions = std::move(directions), .angle = angle};
    return mixture(std::move(out));
}

MaterialPtr masked(MaterialPtr material, TexturePtr opacity, bool translucent) {
    SpatialVariation out = parts_of(material, "mask");
    require_texture(opacity, "mask");
    require(out.opacity == nullptr, "mask: the material has an opacity already");
    out.opacity = std::move(opacity);
    out.translucent = translucent;
    constexpr float below_one = 1 - 0x1p-24F;
    if (out.opacity->constant() && out.present({}, below_one)) return material;
    return mixture(std::move(out));
}

}  // namespace nicol
