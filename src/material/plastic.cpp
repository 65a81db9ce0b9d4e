// SPDX-License-Identifier: MIT
#include "material/plastic.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include "material/boundary_transmittance.hpp"
#include "material/conductor.hpp"
#include "material/key.hpp"
#include "material/microfacet.hpp"
#include "material/reflectance.hpp"
#include "material/shared_terms.hpp"
#include "material/textured.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

struct DepolarizingLanes {
    Facets<float> facets;
    RelativeIndex<float> index;
    float base;              // scale of the base
    const Lanes& in;         // transmittance from the light
    const Lanes& from_base;  // transmittance towards the viewer
};

// Computes both terms of Plastic for sixteen pairs of directions.
template <class Number>
[[gnu::always_inline]] inline void reflect_depolarizing(const DepolarizingLanes& plastic,
                                                        const LaneVectors& towards_light,
                                                        const LaneVectors& towards_viewer, LaneMueller* out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> light;
        Vector3<Number> viewer;
        load_part(towards_light, first, light);
        load_part(towards_viewer, first, viewer);
        Number in;
        Number from_base;
        load_part(plastic.in, first, in);
        load_part(plastic.from_base, first, from_base);
        const Number lower = light.z < viewer.z ? light.z : viewer.z;  // GCC 12 vectorises one condition
        const auto above = lower > 0.0F;
        store_part<Number>(above ? plastic.base * in * from_base : Number{}, first, out[0].m[0]);
        const FacetReflection<Number> facet = facet_reflection(plastic.facets, light, viewer);
        store_part<Number>(facet.scale * dielectric_reflection(facet.cosine, plastic.index).a, first,
                           out[1].m[0]);
    }
}

PlasticParameters checked(PlasticParameters p) {
    check_plastic(p);
    return p;
}

// Depolarizing plastic with two terms, the base and the boundary.
class Plastic final : public Material, public SharedTerms {
public:
    explicit Plastic(PlasticParameters parameters)
        : smooth_(take_smooth(parameters.alpha.value, parameters.distribution)),
          p_(checked(std::move(parameters))),
          eta_(p_.int_ior / p_.ext_ior),
          transmittance_(smooth_ ? BoundaryTransmittance(eta_)
                                 : BoundaryTransmittance(eta_, p_.distribution, p_.alpha.value)) {}

    [[nodiscard]] int channels() const noexcept override {
        return static_cast<int>(
            std::max(p_.diffuse_reflectance.values.size(), p_.specular_reflectance.values.size()));
    }
    [[nodiscard]] int terms() const noexcept override { return 2; }
    [[nodiscard]] double weight(int term, int channel) const override {
        if (term == 1) return of_channel(p_.specular_reflectance.values, channel);
        const double r = of_channel(p_.diffuse_reflectance.values, channel);
        return r / (1 - (p_.nonlinear ? r : 1) * transmittance_.returned());
    }
    [[nodiscard]] double lobe_width(int term) const noexcept override {
        return term == 0 ? 1 : p_.alpha.value;
    }
    [[nodiscard]] Distribution distribution(int) const noexcept override { return p_.distribution; }
    [[nodiscard]] bool smooth(int term) const noexcept override { return smooth_ && term == 1; }
    [[nodiscard]] std::string content_key() const override {
        return with_terms(named()
                              .add("diffuse_reflectance", p_.diffuse_reflectance.values)
                              .add("specular_reflectance", p_.specular_reflectance.values)
                              .add("nonlinear", p_.nonlinear));
    }
    [[nodiscard]] std::string own_terms_key() const override { return with_terms(named()); }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        Mueller m;
        m(0, 0) = term == 0 ? base_scale() * transmittance_.at(towards_light.z) *
                                  transmittance_.at(towards_viewer.z)
                            : boundary(towards_light, towards_viewer);
        return m;
    }
    void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                        std::size_t /*columns*/, std::span<LaneMueller> out) const override {
        Lanes in;
        Lanes from_base;
        transmittance_.at_lanes(towards_light.z, in);
        transmittance_.at_lanes(towards_viewer.z, from_base);
        out[0] = out[1] = {};
        dispatch<reflect_depolarizing<FourLanes>, reflect_depolarizing<EightLanes>,
                 reflect_depolarizing<AllLanes>>(
            DepolarizingLanes{.facets = {p_.distribution, static_cast<float>(p_.alpha.value)},
                              .index = RelativeIndex<float>(eta_),
                              .base = static_cast<float>(base_scale()),
                              .in = in,
                              .from_base = from_base},
            towards_light, towards_viewer, out.data());
    }

private:
    [[nodiscard]] Key named() const { return Key(smooth_ ? "plastic" : "roughplastic"); }
    [[nodiscard]] std::string with_terms(Key key) const {
        return key.add("eta", eta_)
            .add("alpha", p_.alpha.value)
            .add("distribution", p_.distribution == Distribution::ggx)
            .text();
    }

    // Returns 1 / (pi eta^2), because radiance falls by eta^2 on its way out.
    [[nodiscard]] double base_scale() const { return 1 / (eta_ * eta_ * std::numbers::pi); }

    // Returns the single reflection off the facets whose normal is the half vector.
    [[nodiscard]] double boundary(const glm::dvec3& light, const glm::dvec3& viewer) const {
        const FacetReflection<double> facet =
            facet_reflection({p_.distribution, p_.alpha.value}, components(light), components(viewer));
        return facet.scale * dielectric_reflection(facet.cosine, RelativeIndex<double>(eta_)).a;
    }

    bool smooth_;
    PlasticParameters p_;  // values only, no textures
    double eta_;
    BoundaryTransmittance transmittance_;
};

}  // namespace

MaterialPtr plastic(const PlasticParameters& parameters) {
    if (!textured(parameters.diffuse_reflectance, parameters.specular_reflectance, parameters.alpha))
        return std::make_shared<Plastic>(parameters);
    PlasticParameters base = parameters;
    base.diffuse_reflectance = factor(parameters.diffuse_reflectance);
    base.specular_reflectance = {0};
    const auto make_base = [&](double alpha) {
        base.alpha = alpha;
        const MaterialPtr material = plastic(base);
        if (!parameters.diffuse_reflectance.texture || !base.nonlinear)
            return times(material, parameters.diffuse_reflectance);
        // Light that returns to a white base makes the base 1 / (1 - returned) times as bright.
        return scaled_again(material, parameters.diffuse_reflectance.texture, 1 - 1 / material->weight(0, 0));
    };
    PlasticParameters boundary = parameters;
    boundary.diffuse_reflectance = {0};
    boundary.specular_reflectance = factor(parameters.specular_reflectance);
    const auto make_boundary = [&boundary](double alpha) {
        boundary.alpha = alpha;
        return plastic(boundary);
    };
    return sum(at_roughness(make_base, parameters.alpha),
               times(at_roughness(make_boundary, parameters.alpha), parameters.specular_reflectance));
}

}  // namespace nicol
