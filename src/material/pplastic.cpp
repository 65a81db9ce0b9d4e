// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "material/microfacet.hpp"
#include "material/reflectance.hpp"
#include "nicol/error.hpp"
#include "nicol/fresnel.hpp"
#include "nicol/material.hpp"

namespace nicol {
namespace {

const glm::dvec3 normal(0, 0, 1);

// A frame for light along `propagation` whose x is the s-axis of the plane it spans with `axis`. Any
// perpendicular will do where they are parallel: there the s- and p-axis are alike.
Frame s_frame(const glm::dvec3& axis, const glm::dvec3& propagation) {
    const glm::dvec3 s = glm::cross(axis, propagation);
    const double length = glm::length(s);
    if (length < 1e-12) return theta_phi_frame(propagation);
    return frame_with_x(propagation, s / length);
}

class Pplastic final : public Material {
public:
    explicit Pplastic(PplasticParameters parameters) : p_(std::move(parameters)), eta_(p_.int_ior / p_.ext_ior) {
        check_reflectance(p_.diffuse_reflectance, "diffuse_reflectance");
        check_reflectance(p_.specular_reflectance, "specular_reflectance");
        check_range(p_.int_ior, 1e-3, 1e3, "int_ior");
        check_range(p_.ext_ior, 1e-3, 1e3, "ext_ior");
        check_range(p_.alpha, 0.001, 1, "alpha");
        const std::size_t kd = p_.diffuse_reflectance.size();
        const std::size_t ks = p_.specular_reflectance.size();
        if (kd != ks && kd != 1 && ks != 1) {
            throw Error(ErrorCode::invalid_argument,
                        "diffuse_reflectance has " + std::to_string(kd) +
                            " channels and specular_reflectance " + std::to_string(ks) +
                            "; they must agree, or one of them have a single value");
        }
    }

    [[nodiscard]] int channels() const noexcept override {
        return static_cast<int>(std::max(p_.diffuse_reflectance.size(), p_.specular_reflectance.size()));
    }
    [[nodiscard]] int terms() const noexcept override { return 2; }
    [[nodiscard]] double weight(int term, int channel) const override {
        return of_channel(term == 0 ? p_.diffuse_reflectance : p_.specular_reflectance, channel);
    }
    [[nodiscard]] double lobe_width(int term) const noexcept override { return term == 0 ? 1 : p_.alpha; }

    [[nodiscard]] Mueller evaluate(int term, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        if (towards_light.z <= 0 || towards_viewer.z <= 0) return {};
        return term == 0 ? base(towards_light, towards_viewer) : boundary(towards_light, towards_viewer);
    }

private:
    // Through the smooth boundary, depolarizing scattering inside, and out again.
    [[nodiscard]] Mueller base(const glm::dvec3& light, const glm::dvec3& viewer) const {
        const Mueller in = fresnel_transmission(light.z, eta_);
        const Mueller out = fresnel_transmission(viewer.z, eta_);
        Mueller m;
        for (std::size_t row = 0; row < 4; ++row) {
            for (std::size_t column = 0; column < 4; ++column) {
                m(row, column) = out(row, 0) * in(0, column) / std::numbers::pi;
            }
        }
        return in_theta_phi(m, normal, light, viewer);
    }

    // Single reflection off the facets whose normal is the half vector.
    [[nodiscard]] Mueller boundary(const glm::dvec3& light, const glm::dvec3& viewer) const {
        const glm::dvec3 half = glm::normalize(light + viewer);
        const double d = facet_density(p_.distribution, p_.alpha, half.z);
        const double g = facet_visibility(p_.distribution, p_.alpha, light.z) *
                         facet_visibility(p_.distribution, p_.alpha, viewer.z);
        const Mueller reflected = fresnel_reflection(std::min(1.0, glm::dot(viewer, half)), eta_);
        return in_theta_phi((d * g / (4 * light.z * viewer.z)) * reflected, half, light, viewer);
    }

    // From the s-frames about `axis` to the frames that Material promises.
    [[nodiscard]] static Mueller in_theta_phi(const Mueller& m, const glm::dvec3& axis,
                                              const glm::dvec3& light, const glm::dvec3& viewer) {
        const double in = angle_between(s_frame(axis, -light), theta_phi_frame(-light));
        const double out = angle_between(s_frame(axis, viewer), theta_phi_frame(viewer));
        return in_turned_frames(m, in, out);
    }

    PplasticParameters p_;
    double eta_;
};

}  // namespace

MaterialPtr pplastic(const PplasticParameters& parameters) {
    return std::make_shared<Pplastic>(parameters);
}

}  // namespace nicol
