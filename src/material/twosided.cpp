// SPDX-License-Identifier: MIT
#include <utility>

#include "error.hpp"
#include "material/material.hpp"
#include "material/mixed_terms.hpp"
#include "material/mixture.hpp"
#include "material/shared_terms.hpp"

namespace nicol {
namespace {

class Twosided final : public Material, public SharedTerms, public MixedTerms {
public:
    explicit Twosided(MaterialPtr front) : front_(std::move(front)) {
        // The front owns its isotropic counterpart.
        if (front_->anisotropic())
            isotropic_ = std::make_unique<const Twosided>(MaterialPtr(front_, &front_->isotropic()));
    }

    [[nodiscard]] int channels() const noexcept override { return front_->channels(); }
    [[nodiscard]] int terms() const noexcept override { return front_->terms(); }
    [[nodiscard]] double weight(int term, int channel) const override {
        return front_->weight(term, channel);
    }
    [[nodiscard]] double lobe_width(int term) const noexcept override { return front_->lobe_width(term); }
    [[nodiscard]] glm::dvec2 lobe_widths(int term) const noexcept override {
        return front_->lobe_widths(term);
    }
    [[nodiscard]] const Material& isotropic() const noexcept override {
        return isotropic_ ? *isotropic_ : *this;
    }
    [[nodiscard]] Distribution distribution(int term) const noexcept override {
        return front_->distribution(term);
    }
    [[nodiscard]] bool mixed(int term) const override { return is_mixed(*front_, term); }
    [[nodiscard]] bool smooth(int term) const noexcept override { return front_->smooth(term); }
    [[nodiscard]] bool mirror_symmetric() const noexcept override { return front_->mirror_symmetric(); }
    [[nodiscard]] bool twosided() const noexcept override { return true; }
    [[nodiscard]] std::string content_key() const override { return front_->content_key(); }
    [[nodiscard]] std::string own_terms_key() const override { return terms_key(*front_); }
    [[nodiscard]] const IsotropicMatrix* matrix(int channel) const override {
        return front_->matrix(channel);
    }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        const bool back = towards_viewer.z < 0;
        return front_->evaluate(term, on_front(towards_light, back), on_front(towards_viewer, back));
    }
    void evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                        std::span<Mueller> out) const override {
        const bool back = towards_viewer.z < 0;
        front_->evaluate_terms(on_front(towards_light, back), on_front(towards_viewer, back), out);
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                        std::size_t columns, std::span<LaneMueller> out) const override {
        LaneVectors light = towards_light;
        LaneVectors viewer = towards_viewer;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float side = towards_viewer.z[i] < 0 ? -1.0F : 1.0F;
            for (LaneVectors* const d : {&light, &viewer}) {
                d->y[i] *= side;
                d->z[i] *= side;
            }
        }
        front_->evaluate_lanes(light, viewer, columns, out);
    }

private:
    // Rotation by 180 degrees about x. It negates theta-hat and phi-hat, which changes no Stokes component.
    static glm::dvec3 on_front(const glm::dvec3& d, bool back) {
        return back ? glm::dvec3(d.x, -d.y, -d.z) : d;
    }

    MaterialPtr front_;
    std::unique_ptr<const Twosided> isotropic_;  // null: the front is isotropic
};

}  // namespace

MaterialPtr twosided(MaterialPtr material) {
    if (material == nullptr)
        throw Error(ErrorCode::invalid_argument, "twosided: the material is null; give one");
    if (material->smooth_boundary() != nullptr)
        throw Error(ErrorCode::invalid_argument,
                    "twosided: the material lets light through and has two sides by itself; use it alone");
    if (const SpatialVariation* variation = material->variation()) {
        SpatialVariation both = *variation;
        for (MaterialLayer& layer : both.layers) layer.material = twosided(layer.material);
        return mixture(std::move(both));
    }
    return std::make_shared<Twosided>(std::move(material));
}

}  // namespace nicol
