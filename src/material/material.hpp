// SPDX-License-Identifier: MIT
// Polarimetric reflectance (pBRDF) in the angular domain.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "harmonics/operator.hpp"
#include "material/lane_mueller.hpp"
#include "material/parameter.hpp"
#include "polarization/lane_points.hpp"
#include "polarization/mueller.hpp"

namespace nicol {

struct SpatialVariation;

/// A pBRDF without the cosine, as a sum of colourless terms with one weight a colour channel:
/// M(channel) = sum over t of weight(t, channel) * evaluate(t, ...). Immutable.
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
    /// with the normal along z and, of an anisotropic material, x where texture coordinate u grows. Frames:
    /// the theta-phi frames of the propagation directions, -towards_light and towards_viewer. Zero where
    /// either lies below the horizon. Units 1/sr.
    [[nodiscard]] virtual Mueller evaluate(int term, const glm::dvec3& towards_light,
                                           const glm::dvec3& towards_viewer) const = 0;

    /// All terms at once: out[t] = evaluate(t, ...) for t < terms(); faster where terms share work.
    virtual void evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                                std::span<Mueller> out) const;

    /// evaluate_terms() of sixteen pairs of directions, in single precision: out[t] for t < terms() but for
    /// terms whose weight is 0 in every channel, which may be left as they are.
    /// `columns`: 4, or 1 for the first column of each alone, all that unpolarized light needs; the others
    /// are unspecified then.
    virtual void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                                std::size_t columns, std::span<LaneMueller> out) const;

    /// Angular radius of the narrowest feature of a term around the mirror direction, radians: what an
    /// integration over incident directions has to resolve.
    [[nodiscard]] virtual double lobe_width(int term) const noexcept = 0;
    /// The widths along x and along y; the smaller one is lobe_width().
    [[nodiscard]] virtual glm::dvec2 lobe_widths(int term) const noexcept {
        return glm::dvec2(lobe_width(term));
    }

    /// Whether a term stands for a smooth surface: the delta function of a mirror, which no table can hold,
    /// as a narrow lobe. A mirror shows lights without a size as points, which no pixel sees: such a term
    /// reflects nothing of them, though evaluate() has its values.
    [[nodiscard]] virtual bool smooth(int /*term*/) const noexcept { return false; }

    /// What stands for it in harmonics, whose tables are of isotropic materials: itself, or the isotropic
    /// counterpart that it keeps, of as many terms with the same weights and mirror symmetry.
    [[nodiscard]] virtual const Material& isotropic() const noexcept { return *this; }
    /// Whether the azimuth of the frame's x axis matters.
    [[nodiscard]] bool anisotropic() const noexcept { return &isotropic() != this; }

    /// Whether the isotropic() pBRDF is its own mirror image in every plane through the normal: mirroring
    /// both directions reverses the sign of what mixes (s0, s1) with (s2, s3), and changes nothing else.
    /// Measurements are not quite.
    [[nodiscard]] virtual bool mirror_symmetric() const noexcept { return true; }
    /// Pairings of the numbers of light (LightLayout) that rows of its response need: 1 or 2.
    [[nodiscard]] std::size_t pairings() const noexcept { return mirror_symmetric() ? 1 : 2; }

    /// Whether the back of a surface reflects like its front. Then evaluate() is also defined where both
    /// directions are below the horizon; tables hold the front only.
    [[nodiscard]] virtual bool twosided() const noexcept { return false; }

    /// Everything the values depend on, as text: materials of equal key have equal values. Empty where that
    /// is unknown, as for a callback.
    [[nodiscard]] virtual std::string content_key() const { return {}; }

    /// The coefficient matrix of a channel, cosine included, where the material is defined by one; else null.
    /// evaluate() is then its reconstruction, and tables are made from it without integrating.
    [[nodiscard]] virtual const IsotropicMatrix* matrix(int channel) const;

    /// How the material varies over a surface; null: it is the same everywhere. All other functions are then
    /// of its mean.
    [[nodiscard]] virtual const SpatialVariation* variation() const noexcept { return nullptr; }

protected:
    Material() = default;
};

using MaterialPtr = std::shared_ptr<const Material>;

/// M(channel), the sum over terms; frames and range of Material::evaluate().
[[nodiscard]] Mueller evaluate(const Material& material, int channel, const glm::dvec3& towards_light,
                               const glm::dvec3& towards_viewer);

enum class Distribution { beckmann, ggx };

/// Mitsuba 3's `pplastic`: a rough dielectric boundary over a diffuse base.
struct PplasticParameters {
    ColorParameter diffuse_reflectance{0.5};   ///< 0..1
    ColorParameter specular_reflectance{1.0};  ///< 0..1
    double int_ior = 1.49;                     ///< above 0
    double ext_ior = 1.000277;                 ///< above 0
    NumberParameter alpha = 0.1;               ///< roughness, 0.001..1; a texture is moved to 0.01..1
    Distribution distribution = Distribution::beckmann;
};
/// Throws Error(invalid_argument) naming the parameter that is out of range, and what the functions of
/// mixture.hpp throw for its textures.
[[nodiscard]] MaterialPtr pplastic(const PplasticParameters& parameters);

/// Lambertian and depolarizing, reflectance / pi, which lies in 0..1. Throws as pplastic().
[[nodiscard]] MaterialPtr diffuse(const ColorParameter& reflectance);

/// The material on both sides: twosided() is true.
/// Throws Error(invalid_argument) for null.
[[nodiscard]] MaterialPtr twosided(MaterialPtr material);

/// A material defined by a function.
struct CallbackParameters {
    /// Mueller matrix, without the cosine, 1/sr, for unit directions in the surface's frame with z > 0 each.
    /// Both frames have x along the s-axis towards_light x towards_viewer and z along the propagation, as
    /// Fresnel's matrices do. (Where the directions are equal, x is any perpendicular direction, the same for
    /// both.) Called from several threads at once; its exceptions are passed on.
    std::function<Mueller(int channel, const glm::dvec3& towards_light, const glm::dvec3& towards_viewer)>
        reflect;
    int channels = 1;       ///< 1..16
    double lobe_width = 1;  ///< see Material::lobe_width(), 0.001..1
};
/// Tests the function at some directions. Throws Error(invalid_argument) for a parameter out of range, a
/// matrix that is not finite (later also from evaluate()), and a function that is not isotropic, which a
/// Material cannot represent, or not mirror symmetric, which is mostly a mistake with its frames.
[[nodiscard]] MaterialPtr callback_material(CallbackParameters parameters);

}  // namespace nicol
