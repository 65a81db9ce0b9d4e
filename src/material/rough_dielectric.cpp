// SPDX-License-Identifier: MIT
// Rough glass: what its front reflects, and a material that also transmits.
#include <algorithm>
#include <memory>
#include <utility>

#include "error.hpp"
#include "material/conductor.hpp"
#include "material/dielectric.hpp"
#include "material/frames.hpp"
#include "material/microfacet.hpp"
#include "material/reflectance.hpp"
#include "polarization/slab.hpp"

namespace nicol {
namespace {

// Reflection of a slab whose facets are slabs.
class RoughSlab final : public Material {
public:
    explicit RoughSlab(SmoothBoundary boundary) : boundary_(std::move(boundary)) {}

    [[nodiscard]] int channels() const noexcept override {
        return std::max(terms(), static_cast<int>(boundary_.reflectance.size()));
    }
    [[nodiscard]] int terms() const noexcept override {
        return boundary_.film ? boundary_.film->channels() : 1;
    }
    [[nodiscard]] double weight(int term, int channel) const override {
        return terms() == 1 || term == channel ? of_channel(boundary_.reflectance, channel) : 0;
    }
    [[nodiscard]] double lobe_width(int) const noexcept override { return boundary_.alpha; }
    [[nodiscard]] Distribution distribution(int) const noexcept override { return boundary_.distribution; }
    [[nodiscard]] std::string content_key() const override {
        return "reflection of " + boundary_.content_key();
    }
    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        const FacetReflection<double> facet =
            facet_reflection({boundary_.distribution, boundary_.alpha, boundary_.alpha},
                             components(towards_light), components(towards_viewer));
        if (boundary_.film)
            return in_rotated_frames(facet.scale, boundary_.film->reflection(term, facet.cosine),
                                     facet.rotations);
        return facet.scale *
               in_rotated_frames(slab_split(facet.cosine, boundary_.eta).reflection, facet.rotations);
    }

private:
    SmoothBoundary boundary_;
};

// Material with a rough boundary.
class Transmitting final : public Material {
public:
    Transmitting(MaterialPtr reflection, SmoothBoundary boundary)
        : reflection_(std::move(reflection)),
          boundary_(std::move(boundary)),
          channels_(std::max(reflection_->channels(), boundary_.channels())) {
        if (reflection_->anisotropic())
            isotropic_ = std::make_unique<const Transmitting>(
                MaterialPtr(reflection_, &reflection_->isotropic()), boundary_);
    }

    [[nodiscard]] int channels() const noexcept override { return channels_; }
    [[nodiscard]] int terms() const noexcept override { return reflection_->terms(); }
    [[nodiscard]] double weight(int term, int channel) const override {
        return reflection_->weight(term, reflection_->channels() == 1 ? 0 : channel);
    }
    [[nodiscard]] double lobe_width(int term) const noexcept override {
        return reflection_->lobe_width(term);
    }
    [[nodiscard]] glm::dvec2 lobe_widths(int term) const noexcept override {
        return reflection_->lobe_widths(term);
    }
    [[nodiscard]] Distribution distribution(int term) const noexcept override {
        return reflection_->distribution(term);
    }
    [[nodiscard]] bool smooth(int term) const noexcept override { return reflection_->smooth(term); }
    [[nodiscard]] const Material& isotropic() const noexcept override {
        return isotropic_ ? *isotropic_ : *this;
    }
    [[nodiscard]] const SpatialVariation* variation() const noexcept override {
        return reflection_->variation();
    }
    [[nodiscard]] const SmoothBoundary* smooth_boundary() const noexcept override { return &boundary_; }
    [[nodiscard]] std::string content_key() const override {
        const std::string reflection = reflection_->content_key();
        return reflection.empty() ? reflection : boundary_.content_key() + "(" + reflection + ")";
    }
    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        return reflection_->evaluate(term, towards_light, towards_viewer);
    }
    void evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                        std::span<Mueller> out) const override {
        reflection_->evaluate_terms(towards_light, towards_viewer, out);
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                        std::size_t columns, std::span<LaneMueller> out) const override {
        reflection_->evaluate_lanes(towards_light, towards_viewer, columns, out);
    }

private:
    MaterialPtr reflection_;
    SmoothBoundary boundary_;
    int channels_;
    std::unique_ptr<const Transmitting> isotropic_;  // null: this material is isotropic
};

}  // namespace

MaterialPtr rough_reflection(const SmoothBoundary& boundary, const NumberParameter& alpha) {
    check_range(boundary.alpha, 0.001, 1, "alpha");
    if (boundary.behind == SmoothBoundary::Behind::slab) return std::make_shared<RoughSlab>(boundary);
    check_range(boundary.eta, 0.01, 100, "int_ior / ext_ior of a rough surface");
    return rough_conductor({.eta = {boundary.eta},
                            .specular_reflectance = boundary.reflectance,
                            .alpha = alpha,
                            .distribution = boundary.distribution,
                            .film = boundary.film});
}

MaterialPtr transmitting(MaterialPtr reflection, SmoothBoundary boundary) {
    if (!boundary.rough())
        throw Error(ErrorCode::invalid_argument, "alpha is 0; expected the roughness of a boundary");
    return std::make_shared<Transmitting>(std::move(reflection), std::move(boundary));
}

}  // namespace nicol
