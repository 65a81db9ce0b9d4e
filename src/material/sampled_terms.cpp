// SPDX-License-Identifier: MIT
#include "material/sampled_terms.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "material/key.hpp"
#include "material/shared_terms.hpp"
#include "material/spatial_variation.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

// Some terms of a material.
class SomeTerms final : public Material, public SharedTerms {
public:
    SomeTerms(MaterialPtr material, std::vector<int> terms)
        : material_(std::move(material)), terms_(std::move(terms)) {
        if (material_->anisotropic())
            isotropic_ =
                std::make_unique<const SomeTerms>(MaterialPtr(material_, &material_->isotropic()), terms_);
    }

    [[nodiscard]] int channels() const noexcept override { return material_->channels(); }
    [[nodiscard]] int terms() const noexcept override { return static_cast<int>(terms_.size()); }
    [[nodiscard]] double weight(int term, int channel) const override {
        return material_->weight(of(term), channel);
    }
    [[nodiscard]] double lobe_width(int term) const noexcept override {
        return material_->lobe_width(of(term));
    }
    [[nodiscard]] glm::dvec2 lobe_widths(int term) const noexcept override {
        return material_->lobe_widths(of(term));
    }
    [[nodiscard]] Distribution distribution(int term) const noexcept override {
        return material_->distribution(of(term));
    }
    [[nodiscard]] bool smooth(int term) const noexcept override { return material_->smooth(of(term)); }
    [[nodiscard]] const Material& isotropic() const noexcept override {
        return isotropic_ ? *isotropic_ : *this;
    }
    [[nodiscard]] bool mirror_symmetric() const noexcept override { return material_->mirror_symmetric(); }
    [[nodiscard]] std::string content_key() const override {
        const std::string whole = material_->content_key();
        if (whole.empty()) return {};
        Key key("terms");
        for (const int term : terms_) key.add("term", term);
        return key.add("of", "(" + whole + ")").text();
    }
    [[nodiscard]] std::string own_terms_key() const override {
        const std::string whole = terms_key(*material_);
        if (whole.empty()) return {};
        Key key("terms");
        for (const int term : terms_) key.add("term", term);
        return key.add("of", "(" + whole + ")").text();
    }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        return material_->evaluate(of(term), towards_light, towards_viewer);
    }
    void evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                        std::span<Mueller> out) const override {
        const std::span<Mueller> all = work_space<SomeTerms, Mueller>(count());
        material_->evaluate_terms(towards_light, towards_viewer, all);
        for (std::size_t t = 0; t < terms_.size(); ++t) out[t] = all[static_cast<std::size_t>(terms_[t])];
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                        std::size_t columns, std::span<LaneMueller> out) const override {
        const std::span<LaneMueller> all = work_space<SomeTerms, LaneMueller>(count());
        material_->evaluate_lanes(towards_light, towards_viewer, columns, all);
        for (std::size_t t = 0; t < terms_.size(); ++t) out[t] = all[static_cast<std::size_t>(terms_[t])];
    }

private:
    [[nodiscard]] int of(int term) const { return terms_[static_cast<std::size_t>(term)]; }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(material_->terms()); }

    MaterialPtr material_;
    std::vector<int> terms_;
    std::unique_ptr<const SomeTerms> isotropic_;  // null: the material is isotropic
};

}  // namespace

bool is_sampled(const Material& material, int term, SampledTerms sampled) {
    if (sampled.kind == SampledTerms::none || material.matrix(0) != nullptr) return false;
    if (sampled.kind == SampledTerms::smooth) return material.smooth(term);
    const glm::dvec2 widths = material.lobe_widths(term);
    return widths.x != widths.y ||
           (sampled.kind == SampledTerms::anisotropic_narrow && widths.x < sampled.narrowest);
}

bool any_sampled(const Material& material, SampledTerms sampled) {
    return any_term(material,
                    [&](const Material& layer, int term) { return is_sampled(layer, term, sampled); });
}

bool finds_lights(const Lobe& lobe, SampledTerms sampled) {
    return sampled.kind == SampledTerms::anisotropic_narrow &&
           std::max(lobe.alpha.x, lobe.alpha.y) < kNarrowestLobe;
}

bool finds_lights(const Material& material, int term, SampledTerms sampled) {
    return is_sampled(material, term, sampled) && finds_lights(material.lobe(term), sampled);
}

MaterialPtr some_terms(const MaterialPtr& material, const std::function<bool(int)>& has) {
    std::vector<int> terms;
    for (int t = 0; t < material->terms(); ++t)
        if (has(t)) terms.push_back(t);
    if (terms.size() == static_cast<std::size_t>(material->terms())) return material;
    if (terms.empty()) return diffuse({0});
    return std::make_shared<const SomeTerms>(material, std::move(terms));
}

MaterialPtr in_harmonics(const MaterialPtr& material, SampledTerms sampled) {
    return some_terms(material, [&](int term) { return !is_sampled(*material, term, sampled); });
}

}  // namespace nicol
