// SPDX-License-Identifier: MIT
#include "material/clearcoat.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "error.hpp"
#include "material/conductor.hpp"
#include "material/key.hpp"
#include "material/mixed_terms.hpp"
#include "material/mixture.hpp"
#include "material/reflectance.hpp"
#include "polarization/fresnel.hpp"

namespace nicol {
namespace {

// Transmission through the coat in theta-phi frames of the macro surface, whose s-axis is phi-hat:
// [[a, b, 0, 0], [b, a, 0, 0], [0, 0, c, 0], [0, 0, 0, c]].
template <class Real>
struct Passage {
    Real a, b, c;
};

template <class Real>
Passage<Real> passage(Real cosine, const RelativeIndex<Real>& index) {
    Real mean = 0;
    Real difference = 0;
    dielectric_transmission(std::min(cosine, Real{1}), index, mean, difference);
    // The rotation by 90 degrees negates s1 and s2.
    return {mean, -difference, std::sqrt((mean + difference) * (mean - difference))};
}

// Replaces the matrix m(row, column) by out m in, in place.
template <class Real, class Element>
void pass(const Passage<Real>& in, const Passage<Real>& out, const Element& m) {
    for (std::size_t column = 0; column < 4; ++column) {
        const Real first = m(0, column);
        m(0, column) = out.a * first + out.b * m(1, column);
        m(1, column) = out.b * first + out.a * m(1, column);
        m(2, column) *= out.c;
        m(3, column) *= out.c;
    }
    for (std::size_t row = 0; row < 4; ++row) {
        const Real first = m(row, 0);
        const Real second = m(row, 1);
        m(row, 0) = first * in.a + second * in.b;
        m(row, 1) = first * in.b + second * in.a;
        m(row, 2) *= in.c;
        m(row, 3) *= in.c;
    }
}

// Material below a coat.
class BelowCoat final : public Material, public MixedTerms {
public:
    BelowCoat(MaterialPtr base, double eta) : base_(std::move(base)), eta_(eta) {
        if (base_->anisotropic())
            isotropic_ = std::make_unique<const BelowCoat>(MaterialPtr(base_, &base_->isotropic()), eta);
    }

    [[nodiscard]] int channels() const noexcept override { return base_->channels(); }
    [[nodiscard]] int terms() const noexcept override { return base_->terms(); }
    [[nodiscard]] double weight(int term, int channel) const override { return base_->weight(term, channel); }
    [[nodiscard]] double lobe_width(int term) const noexcept override { return base_->lobe_width(term); }
    [[nodiscard]] glm::dvec2 lobe_widths(int term) const noexcept override {
        return base_->lobe_widths(term);
    }
    [[nodiscard]] Distribution distribution(int term) const noexcept override {
        return base_->distribution(term);
    }
    [[nodiscard]] bool mixed(int term) const override { return is_mixed(*base_, term); }
    [[nodiscard]] bool smooth(int term) const noexcept override { return base_->smooth(term); }
    [[nodiscard]] const Material& isotropic() const noexcept override {
        return isotropic_ ? *isotropic_ : *this;
    }
    [[nodiscard]] bool mirror_symmetric() const noexcept override { return base_->mirror_symmetric(); }
    [[nodiscard]] std::string content_key() const override {
        const std::string base = base_->content_key();
        return base.empty() ? base : Key("below a coat").add("eta", eta_).text() + "(" + base + ")";
    }
    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        Mueller m = base_->evaluate(term, towards_light, towards_viewer);
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        const RelativeIndex<double> index(eta_);
        pass(passage(towards_light.z, index), passage(towards_viewer.z, index),
             [&](std::size_t row, std::size_t column) -> double& { return m(row, column); });
        return m;
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                        std::size_t /*columns*/, std::span<LaneMueller> out) const override {
        // The first column depends on two columns of the base.
        base_->evaluate_lanes(towards_light, towards_viewer, 4, out);
        const RelativeIndex<float> index(eta_);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const bool above = towards_light.z[i] > 0 && towards_viewer.z[i] > 0;
            const Passage<float> none{0, 0, 0};
            const Passage<float> in = above ? passage(towards_light.z[i], index) : none;
            const Passage<float> passed = above ? passage(towards_viewer.z[i], index) : none;
            for (LaneMueller& matrix : out)
                pass(in, passed, [&](std::size_t row, std::size_t column) -> float& {
                    return matrix.m[4 * row + column][i];
                });
        }
    }

private:
    MaterialPtr base_;
    double eta_;
    std::unique_ptr<const BelowCoat> isotropic_;  // null: the base is isotropic
};

MaterialPtr below(const MaterialPtr& material, double eta) {
    if (const SpatialVariation* variation = material->variation()) {
        SpatialVariation all = *variation;
        for (MaterialLayer& layer : all.layers) layer.material = below(layer.material, eta);
        return mixture(std::move(all));
    }
    return std::make_shared<BelowCoat>(material, eta);
}

}  // namespace

MaterialPtr clearcoat(const MaterialPtr& material, const ClearcoatParameters& parameters) {
    if (material == nullptr) throw Error(ErrorCode::invalid_argument, "clearcoat: the material is null");
    if (material->smooth_boundary() != nullptr || material->twosided())
        throw Error(ErrorCode::invalid_argument,
                    "clearcoat: the material transmits light or is two-sided; coat an opaque front");
    check_range(parameters.factor.value, 0, 1, "clearcoat");
    check_range(parameters.eta, 0.01, 100, "index of the coat");
    const NumberParameter& factor = parameters.factor;
    if (factor.value == 0 && !factor.texture) return material;
    MaterialPtr coated =
        sum(below(material, parameters.eta),
            rough_conductor(
                {.eta = {parameters.eta}, .alpha = parameters.alpha, .distribution = Distribution::ggx}));
    if (factor.texture) return blend(material, coated, factor.texture);
    if (factor.value == 1) return coated;
    return blend(material, coated, constant_texture(glm::vec4(static_cast<float>(factor.value)), 1));
}

}  // namespace nicol
