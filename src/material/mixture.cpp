// SPDX-License-Identifier: MIT
#include "material/mixture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "material/key.hpp"
#include "material/reflectance.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

// Least roughness. A narrower lobe looks the same at any order that light is projected to.
constexpr double kLeastAlpha = 0.01;
/// Ratio of neighbouring roughnesses. Interpolation half-way between two alphas of this ratio has an error of
/// about 1 % in the rows of a response.
constexpr double kAlphaRatio = 1.2;
/// Most values of a texture that get a layer each. kMostOfPair limits the values of each of two textures,
/// interpolated ones included, because every pair of values gets a layer.
constexpr std::size_t kMostValues = 16;
constexpr std::size_t kMostOfPair = 8;

/// Sum of weighted layers. Its terms are those of the layers, times the mean of the layer's weight.
class Layered final : public Material {
public:
    explicit Layered(SpatialVariation variation) : variation_(std::move(variation)) {
        for (const MaterialLayer& layer : variation_.layers) add(layer);
        varies_ = variation_.normal.kind != NormalVariation::Kind::none || variation_.opacity != nullptr ||
                  !variation_.textures.empty();
        // A material whose mean is black still has a term.
        if (terms_.empty())
            terms_.push_back(
                {.material = variation_.layers.front().material, .index = 0, .scale = glm::dvec3(0)});
        make_isotropic();
        make_behind();
    }

    [[nodiscard]] int channels() const noexcept override { return channels_; }
    [[nodiscard]] int terms() const noexcept override { return static_cast<int>(terms_.size()); }
    [[nodiscard]] double weight(int term, int channel) const override {
        const Term& of = at(term);
        const int own = of.material->channels() == 1 ? 0 : channel;
        // The scales are equal unless there are three channels.
        return of.material->weight(of.index, own) * of.scale[channels_ == 3 ? channel : 0];
    }
    [[nodiscard]] double lobe_width(int term) const noexcept override {
        const Term& of = at(term);
        return of.material->lobe_width(of.index);
    }
    [[nodiscard]] glm::dvec2 lobe_widths(int term) const noexcept override {
        const Term& of = at(term);
        return of.material->lobe_widths(of.index);
    }
    [[nodiscard]] const Material& isotropic() const noexcept override {
        return isotropic_ ? *isotropic_ : *this;
    }
    [[nodiscard]] Distribution distribution(int term) const noexcept override {
        return at(term).material->distribution(at(term).index);
    }
    [[nodiscard]] bool smooth(int term) const noexcept override {
        const Term& of = at(term);
        return of.material->smooth(of.index);
    }
    [[nodiscard]] bool mirror_symmetric() const noexcept override {
        return std::ranges::all_of(
            variation_.layers, [](const MaterialLayer& layer) { return layer.material->mirror_symmetric(); });
    }
    [[nodiscard]] bool twosided() const noexcept override {
        return std::ranges::any_of(variation_.layers, has_two_sides);
    }
    [[nodiscard]] MaterialPtr behind() const override { return behind_; }
    [[nodiscard]] std::string content_key() const override {
        Key key("layered");
        for (const Term& term : terms_) {
            const std::string own = term.material->content_key();
            if (own.empty()) return {};
            key.add("of", "(" + own + ")").add("term", term.index);
            for (glm::length_t c = 0; c < 3; ++c) key.add("scale", term.scale[c]);
        }
        return key.text();
    }
    [[nodiscard]] const SpatialVariation* variation() const noexcept override {
        return varies_ ? &variation_ : nullptr;
    }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        const Term& of = at(term);
        return of.material->evaluate(of.index, towards_light, towards_viewer);
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                        std::size_t columns, std::span<LaneMueller> out) const override {
        // Terms of one layer follow each other, so each layer is evaluated once.
        const Material* evaluated = nullptr;
        std::span<LaneMueller> of_layer;
        for (std::size_t t = 0; t < terms_.size(); ++t) {
            const Material& material = *terms_[t].material;
            if (&material != evaluated) {
                evaluated = &material;
                of_layer = work_space<Layered, LaneMueller>(static_cast<std::size_t>(material.terms()));
                material.evaluate_lanes(towards_light, towards_viewer, columns, of_layer);
            }
            out[t] = of_layer[static_cast<std::size_t>(terms_[t].index)];
        }
    }

private:
    struct Term {
        MaterialPtr material;
        int index;
        glm::dvec3 scale;
    };
    [[nodiscard]] const Term& at(int term) const { return terms_[static_cast<std::size_t>(term)]; }

    void make_isotropic() {
        const auto anisotropic = [](const MaterialLayer& layer) { return layer.material->anisotropic(); };
        if (std::ranges::none_of(variation_.layers, anisotropic)) return;
        SpatialVariation layers = variation_;
        // Each layer's material owns its isotropic counterpart.
        for (MaterialLayer& layer : layers.layers)
            layer.material = MaterialPtr(layer.material, &layer.material->isotropic());
        isotropic_ = std::make_shared<const Layered>(std::move(layers));
    }

    void make_behind() {
        SpatialVariation layers = variation_;
        std::erase_if(layers.layers, [](const MaterialLayer& layer) { return !has_two_sides(layer); });
        bool same = layers.layers.empty() || layers.layers.size() == variation_.layers.size();
        for (MaterialLayer& layer : layers.layers) {
            const MaterialPtr behind = layer.material->behind();
            if (!behind) continue;
            layer.material = behind;
            same = false;
        }
        if (!same) behind_ = layered(std::move(layers));
    }

    static bool has_two_sides(const MaterialLayer& layer) { return layer.material->twosided(); }

    void add(const MaterialLayer& layer) {
        glm::vec3 mean = layer.scale;
        for (const LayerFactor& factor : layer.factors) {
            const Texture& texture = *variation_.textures[factor.texture];
            mean *= factor_value(factor, texture.mean());
            if (factor.colored() && texture.channels() > 1) need_channels(3);
        }
        if (layer.scale != glm::vec3(layer.scale.x)) need_channels(3);
        need_channels(layer.material->channels());
        if (mean == glm::vec3(0)) return;
        for (int t = 0; t < layer.material->terms(); ++t) {
            bool black = true;
            for (int c = 0; c < layer.material->channels(); ++c)
                black = black && layer.material->weight(t, c) == 0;
            if (!black) terms_.push_back({.material = layer.material, .index = t, .scale = mean});
        }
    }

    void need_channels(int count) {
        require(count == 1 || channels_ == 1 || count == channels_,
                "parts or textures of " + std::to_string(channels_) + " and " + std::to_string(count) +
                    " channels; expected 1 or as many as the others");
        channels_ = std::max(channels_, count);
    }

    SpatialVariation variation_;
    bool varies_ = false;
    int channels_ = 1;
    std::vector<Term> terms_;
    MaterialPtr isotropic_;  // null: no layer is anisotropic
    MaterialPtr behind_;     // null: all layers are the same on the back, or none is two-sided
};

SpatialVariation parts_of(const MaterialPtr& material, const char* of) {
    require(material != nullptr, std::string(of) + ": the material is null; give one");
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
/// variation and the same opacity.
void append(const SpatialVariation& from, SpatialVariation& to, const char* of) {
    const bool first = to.layers.empty();
    require(first || (from.normal == to.normal && from.opacity == to.opacity &&
                      from.translucent == to.translucent),
            std::string(of) +
                ": the parts have normal maps, bump maps or opacities of their own; give them to the whole");
    to.normal = from.normal;
    to.opacity = from.opacity;
    to.translucent = from.translucent;
    for (MaterialLayer layer : from.layers) {
        for (LayerFactor& factor : layer.factors)
            factor.texture = index_of(from.textures[factor.texture], to);
        to.layers.push_back(std::move(layer));
    }
}

/// Returns the values between which a number is interpolated, at most `most` of them if that is given.
std::vector<double> numbers_for(const Texture& texture, double least, double ratio,
                                std::optional<std::size_t> most = {}) {
    const auto inside = [least](float value) { return std::clamp(static_cast<double>(value), least, 1.0); };
    std::vector<double> out;
    for (const float value : texture.values()) out.push_back(inside(value));
    if (out.empty() || out.size() > most.value_or(kMostValues)) {
        out.clear();
        const double low = inside(texture.range().x);
        const double high = inside(texture.range().y);
        int steps = static_cast<int>(std::ceil(std::log(high / low) / std::log(ratio)));
        if (most) steps = std::min(steps, static_cast<int>(*most) - 1);
        for (int i = 0; i < steps; ++i)
            out.push_back(low * std::pow(high / low, i / static_cast<double>(steps)));
        out.push_back(high);
    }
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
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
    return layered(std::move(out));
}

}  // namespace

MaterialPtr layered(SpatialVariation variation) {
    require(!variation.layers.empty(), "layered: there is no layer");
    require(variation.textures.size() <= SpatialVariation::kMostTextures,
            "a material of " + std::to_string(variation.textures.size()) + " textures; at most " +
                std::to_string(SpatialVariation::kMostTextures));
    const bool plain = variation.layers.size() == 1 && variation.textures.empty() &&
                       variation.opacity == nullptr && variation.normal.kind == NormalVariation::Kind::none &&
                       variation.layers.front().scale == glm::vec3(1);
    if (plain) return variation.layers.front().material;
    return std::make_shared<Layered>(std::move(variation));
}

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
    return layered(std::move(out));
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
    return layered(std::move(out));
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
    return layered(std::move(out));
}

MaterialPtr with_number(const std::function<MaterialPtr(double t)>& make, const TexturePtr& texture,
                        double least, double ratio) {
    require_texture(texture, "with_number");
    return interpolated(make, texture, numbers_for(*texture, least, ratio));
}

MaterialPtr with_roughness(const std::function<MaterialPtr(double u, double v)>& make,
                           const TexturePtr& alpha_u, const TexturePtr& alpha_v) {
    require_texture(alpha_u, "with_roughness");
    require_texture(alpha_v, "with_roughness");
    const auto alphas = [](const Texture& texture) {
        return numbers_for(texture, kLeastAlpha, kAlphaRatio, kMostOfPair);
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
    return layered(std::move(out));
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
    return layered(std::move(out));
}

MaterialPtr masked(MaterialPtr material, TexturePtr opacity, bool translucent) {
    SpatialVariation out = parts_of(material, "mask");
    require_texture(opacity, "mask");
    require(out.opacity == nullptr, "mask: the material has an opacity already");
    out.opacity = std::move(opacity);
    out.translucent = translucent;
    constexpr float below_one = 1 - 0x1p-24F;
    if (out.opacity->constant() && out.present({}, below_one)) return material;
    return layered(std::move(out));
}

}  // namespace nicol
