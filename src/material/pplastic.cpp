// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "material/frames.hpp"
#include "material/key.hpp"
#include "material/material.hpp"
#include "material/microfacet.hpp"
#include "material/reflectance.hpp"
#include "material/shared_terms.hpp"
#include "material/textured.hpp"
#include "polarization/fresnel.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

struct LanePlastic {
    LanePlastic(const PplasticParameters& p, const glm::dvec2& alpha, double eta)
        : facets{p.distribution, static_cast<float>(alpha.x), static_cast<float>(alpha.y)},
          index(eta),
          base(!black(p.diffuse_reflectance.values)),
          boundary(!black(p.specular_reflectance.values)) {}
    Facets<float> facets;
    RelativeIndex<float> index;
    bool base, boundary;  // true: the term has a weight other than 0
};

// Computes Pplastic::base() and Pplastic::boundary() for sixteen pairs of directions.
template <class Number>
[[gnu::always_inline]] inline void reflect_plastic(const LanePlastic& plastic,
                                                   const LaneVectors& towards_light,
                                                   const LaneVectors& towards_viewer, std::size_t columns,
                                                   LaneMueller* out) {
    LaneMueller& base = out[0];
    if (plastic.base) base = {};
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> light;
        Vector3<Number> viewer;
        load_part(towards_light, first, light);
        load_part(towards_viewer, first, viewer);
        if (plastic.boundary) {
            const FacetReflection<Number> facet = facet_reflection(plastic.facets, light, viewer);
            store_reflection(facet, dielectric_reflection(facet.cosine, plastic.index), columns, first,
                             out[1]);
        }
        if (!plastic.base) continue;
        Number in;
        Number in_difference;
        Number from_base;
        Number from_difference;
        dielectric_transmission(light.z, plastic.index, in, in_difference);
        dielectric_transmission(viewer.z, plastic.index, from_base, from_difference);
        const Number lower = light.z < viewer.z ? light.z : viewer.z;  // GCC 12 vectorises one condition
        const auto above = lower > 0.0F;
        const Number lambert = above ? Number{} + 1 / std::numbers::pi_v<float> : Number{};
        from_base *= lambert;
        from_difference *= -lambert;
        store_part<Number>(from_base * in, first, base.m[0]);
        store_part<Number>(from_difference * in, first, base.m[4]);
        if (columns > 1) {
            store_part<Number>(-from_base * in_difference, first, base.m[1]);
            store_part<Number>(-from_difference * in_difference, first, base.m[5]);
        }
    }
}

class Pplastic final : public Material, public SharedTerms {
public:
    explicit Pplastic(PplasticParameters parameters)
        : p_(std::move(parameters)),
          eta_(p_.int_ior / p_.ext_ior),
          alpha_(p_.alpha.value, p_.alpha_v.value != 0 ? p_.alpha_v.value : p_.alpha.value),
          lanes_(p_, alpha_, eta_) {
        check_plastic(p_);
        check_range(alpha_.y, 0.001, 1, "alpha_v");
        if (alpha_.x == alpha_.y) return;
        PplasticParameters mean = p_;
        mean.alpha = std::sqrt(alpha_.x * alpha_.y);
        mean.alpha_v = 0;
        isotropic_ = std::make_unique<const Pplastic>(std::move(mean));
    }

    [[nodiscard]] int channels() const noexcept override {
        return static_cast<int>(
            std::max(p_.diffuse_reflectance.values.size(), p_.specular_reflectance.values.size()));
    }
    [[nodiscard]] int terms() const noexcept override { return 2; }
    [[nodiscard]] double weight(int term, int channel) const override {
        return of_channel((term == 0 ? p_.diffuse_reflectance : p_.specular_reflectance).values, channel);
    }
    [[nodiscard]] double lobe_width(int term) const noexcept override {
        return term == 0 ? 1 : std::min(alpha_.x, alpha_.y);
    }
    [[nodiscard]] glm::dvec2 lobe_widths(int term) const noexcept override {
        return term == 0 ? glm::dvec2(1) : alpha_;
    }
    [[nodiscard]] Distribution distribution(int) const noexcept override { return p_.distribution; }
    [[nodiscard]] const Material& isotropic() const noexcept override {
        return isotropic_ ? *isotropic_ : *this;
    }
    [[nodiscard]] std::string content_key() const override {
        return with_terms(Key("pplastic")
                              .add("diffuse_reflectance", p_.diffuse_reflectance.values)
                              .add("specular_reflectance", p_.specular_reflectance.values));
    }
    [[nodiscard]] std::string own_terms_key() const override { return with_terms(Key("pplastic")); }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        return term == 0 ? base(towards_light, towards_viewer) : boundary(towards_light, towards_viewer);
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                        std::size_t columns, std::span<LaneMueller> out) const override {
        dispatch<reflect_plastic<FourLanes>, reflect_plastic<EightLanes>, reflect_plastic<AllLanes>>(
            lanes_, towards_light, towards_viewer, columns, out.data());
    }

private:
    [[nodiscard]] std::string with_terms(Key key) const {
        return key.add("eta", eta_)
            .add("alpha", isotropic_ ? std::vector{alpha_.x, alpha_.y} : std::vector{alpha_.x})
            .add("distribution", p_.distribution == Distribution::ggx)
            .text();
    }

    // Returns transmission through the smooth boundary, depolarizing scattering inside, and transmission out.
    [[nodiscard]] Mueller base(const glm::dvec3& light, const glm::dvec3& viewer) const {
        const Mueller in = fresnel_transmission(light.z, eta_);
        const Mueller out = fresnel_transmission(viewer.z, eta_);
        // The s-axis of the macro surface is phi-hat. The rotation by 90 degrees negates s1.
        const double i = -in(0, 1) / in(0, 0);
        const double o = -out(1, 0) / out(0, 0);
        const double scale = out(0, 0) * in(0, 0) / std::numbers::pi;
        if (!(scale > 0)) return {};
        return Mueller({scale, scale * i, 0, 0, scale * o, scale * o * i});
    }

    // Returns the single reflection off the facets whose normal is the half vector.
    [[nodiscard]] Mueller boundary(const glm::dvec3& light, const glm::dvec3& viewer) const {
        const FacetReflection<double> facet =
            facet_reflection({p_.distribution, alpha_.x, alpha_.y}, components(light), components(viewer));
        return in_rotated_frames(
            facet.scale, dielectric_reflection(facet.cosine, RelativeIndex<double>(eta_)), facet.rotations);
    }

    PplasticParameters p_;  // values only, no textures
    double eta_;
    glm::dvec2 alpha_;  // roughness along x and along y
    LanePlastic lanes_;
    std::unique_ptr<const Pplastic> isotropic_;  // null: this material is isotropic
};

}  // namespace

MaterialPtr pplastic(const PplasticParameters& parameters) {
    if (!textured(parameters.diffuse_reflectance, parameters.specular_reflectance, parameters.alpha,
                  parameters.alpha_v))
        return std::make_shared<Pplastic>(parameters);
    // The base does not depend on the roughness of the boundary above it.
    PplasticParameters base = parameters;
    base.diffuse_reflectance = factor(parameters.diffuse_reflectance);
    base.specular_reflectance = {0};
    base.alpha = parameters.alpha.value;
    base.alpha_v = 0;
    PplasticParameters boundary = parameters;
    boundary.diffuse_reflectance = {0};
    boundary.specular_reflectance = factor(parameters.specular_reflectance);
    const auto make_boundary = [&boundary](double u, double v) {
        boundary.alpha = u;
        boundary.alpha_v = v;
        return pplastic(boundary);
    };
    return sum(times(pplastic(base), parameters.diffuse_reflectance),
               times(at_roughness(make_boundary, parameters.alpha, parameters.alpha_v),
                     parameters.specular_reflectance));
}

}  // namespace nicol
