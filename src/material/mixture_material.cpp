// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "material/key.hpp"
#include "material/mixed_terms.hpp"
#include "material/mixture.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

/// Sum of weighted layers. Its terms are those of the layers, times the mean of the layer's weight.
class Mixture final : public Material, public MixedTerms {
public:
    explicit Mixture(SpatialVariation variation) : variation_(std::move(variation)) {
        for (const MaterialLayer& layer : variation_.layers) {
            add(layer);
        }
        varies_ = variation_.normal.kind != NormalVariation::Kind::none || variation_.rotation.any() ||
                  variation_.opacity != nullptr || !variation_.textures.empty();
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
    [[nodiscard]] bool mixed(int term) const override { return is_mixed(*at(term).material, at(term).index); }
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
        Key key("mixture");
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
                of_layer = work_space<Mixture, LaneMueller>(static_cast<std::size_t>(material.terms()));
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
        if (std::ranges::none_of(variation_.layers,
                                 [](const MaterialLayer& layer) { return layer.material->anisotropic(); }))
            return;
        SpatialVariation layers = variation_;
        // Each layer's material owns its isotropic counterpart.
        for (MaterialLayer& layer : layers.layers)
            layer.material = MaterialPtr(layer.material, &layer.material->isotropic());
        isotropic_ = std::make_shared<const Mixture>(std::move(layers));
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
        if (!same) behind_ = mixture(std::move(layers));
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

}  // namespace

MaterialPtr mixture(SpatialVariation variation) {
    require(!variation.layers.empty(), "mixture: there is no layer");
    require(variation.textures.size() <= SpatialVariation::kMostTextures,
            "a material of " + std::to_string(variation.textures.size()) + " textures; at most " +
                std::to_string(SpatialVariation::kMostTextures));
    const bool plain = variation.layers.size() == 1 && variation.textures.empty() &&
                       variation.opacity == nullptr && variation.normal.kind == NormalVariation::Kind::none &&
                       !variation.rotation.any() && variation.layers.front().scale == glm::vec3(1);
    if (plain) return variation.layers.front().material;
    return std::make_shared<Mixture>(std::move(variation));
}

}  // namespace nicol
