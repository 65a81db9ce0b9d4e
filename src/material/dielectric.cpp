// SPDX-License-Identifier: MIT
#include "material/dielectric.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "error.hpp"
#include "material/key.hpp"
#include "material/reflectance.hpp"

namespace nicol {
namespace {

class Dielectric final : public Material {
public:
    explicit Dielectric(SmoothBoundary boundary) : boundary_(std::move(boundary)) {}

    [[nodiscard]] int channels() const noexcept override {
        return static_cast<int>(std::max(boundary_.reflectance.size(), boundary_.transmittance.size()));
    }
    [[nodiscard]] int terms() const noexcept override { return 1; }
    [[nodiscard]] double weight(int, int) const override { return 0; }
    [[nodiscard]] double lobe_width(int) const noexcept override { return 1; }
    [[nodiscard]] const SmoothBoundary* smooth_boundary() const noexcept override { return &boundary_; }
    [[nodiscard]] std::string content_key() const override {
        return Key("dielectric")
            .add("eta", boundary_.eta)
            .add("slab", boundary_.behind == SmoothBoundary::Behind::slab)
            .add("reflectance", boundary_.reflectance)
            .add("transmittance", boundary_.transmittance)
            .text();
    }
    [[nodiscard]] Mueller evaluate(int, const glm::dvec3&, const glm::dvec3&) const override { return {}; }

private:
    SmoothBoundary boundary_;
};

void check_factor(const ColorParameter& color, const std::string& name) {
    if (color.texture != nullptr)
        throw Error(ErrorCode::unsupported,
                    name + " of a material that light passes is a texture; give a constant colour");
    check_reflectance(color.values, name);
}

MaterialPtr smooth_boundary(SmoothBoundary::Behind behind, const DielectricParameters& p) {
    check_range(p.int_ior, 1e-3, 1e3, "int_ior");
    check_range(p.ext_ior, 1e-3, 1e3, "ext_ior");
    check_factor(p.specular_reflectance, "specular_reflectance");
    check_factor(p.specular_transmittance, "specular_transmittance");
    check_channels(p.specular_reflectance.values.size(), "specular_reflectance",
                   p.specular_transmittance.values.size(), "specular_transmittance");
    return std::make_shared<Dielectric>(SmoothBoundary{.behind = behind,
                                                       .eta = p.int_ior / p.ext_ior,
                                                       .reflectance = p.specular_reflectance.values,
                                                       .transmittance = p.specular_transmittance.values});
}

}  // namespace

MaterialPtr dielectric(const DielectricParameters& parameters) {
    return smooth_boundary(SmoothBoundary::Behind::body, parameters);
}

MaterialPtr thin_dielectric(const DielectricParameters& parameters) {
    return smooth_boundary(SmoothBoundary::Behind::slab, parameters);
}

}  // namespace nicol
