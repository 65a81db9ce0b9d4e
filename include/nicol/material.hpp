// SPDX-License-Identifier: MIT
// Polarimetric reflectance (pBRDF) in the angular domain.
#pragma once

#include <memory>
#include <vector>

#include "nicol/mueller.hpp"

namespace nicol {

/// An isotropic pBRDF without the cosine, as a sum of colourless terms with one weight a colour channel:
/// M(channel) = sum over t of weight(t, channel) * evaluate(t, ...). Mirror symmetric about every plane
/// through the normal. Immutable.
class Material {
public:
    virtual ~Material() = default;
    Material(const Material&) = delete;
    Material& operator=(const Material&) = delete;

    /// 1 (the same in every channel) or more.
    [[nodiscard]] virtual int channels() const noexcept = 0;
    [[nodiscard]] virtual int terms() const noexcept = 0;
    [[nodiscard]] virtual double weight(int term, int channel) const = 0;

    /// Mueller matrix for light from `towards_light` to `towards_viewer`, unit vectors in the surface's frame
    /// with the normal along z. Frames: the theta-phi frames of the propagation directions, -towards_light
    /// and towards_viewer. Zero where either lies below the horizon. Units 1/sr.
    [[nodiscard]] virtual Mueller evaluate(int term, const glm::dvec3& towards_light,
                                           const glm::dvec3& towards_viewer) const = 0;

    /// Angular radius of the narrowest feature of a term around the mirror direction, radians: what an
    /// integration over incident directions has to resolve.
    [[nodiscard]] virtual double lobe_width(int term) const noexcept = 0;

protected:
    Material() = default;
};

using MaterialPtr = std::shared_ptr<const Material>;

enum class Distribution { beckmann, ggx };

/// Mitsuba 3's `pplastic`: a rough dielectric boundary over a diffuse base.
struct PplasticParameters {
    std::vector<double> diffuse_reflectance{0.5};   ///< 0..1, one value or one a channel
    std::vector<double> specular_reflectance{1.0};  ///< 0..1, one value or one a channel
    double int_ior = 1.49;                          ///< above 0
    double ext_ior = 1.000277;                      ///< above 0
    double alpha = 0.1;                             ///< roughness, 0.001..1
    Distribution distribution = Distribution::beckmann;
};
/// Throws Error(invalid_argument) naming the parameter that is out of range.
[[nodiscard]] MaterialPtr pplastic(const PplasticParameters& parameters);

/// Lambertian and depolarizing, reflectance / pi. Throws as pplastic().
[[nodiscard]] MaterialPtr diffuse(const std::vector<double>& reflectance);

}  // namespace nicol
