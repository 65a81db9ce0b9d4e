// SPDX-License-Identifier: MIT
// Polarimetric reflectance (pBRDF) in the angular domain.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "harmonics/operator.hpp"
#include "material/parameter.hpp"
#include "polarization/lane_points.hpp"
#include "polarization/mueller.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Sixteen Mueller matrices, row-major like Mueller: m[4 row + column].
struct LaneMueller {
    std::array<Lanes, 16> m;
};

struct SmoothBoundary;
struct SpatialVariation;

class Material;
using MaterialPtr = std::shared_ptr<const Material>;

/// Distribution of the normals of a rough surface's facets.
enum class Distribution { beckmann, ggx };

/// Facets that reflect as a term of a material does, for samples of the term.
struct Lobe {
    glm::dvec2 alpha;  ///< roughness along x and along y
    Distribution distribution;
    bool operator==(const Lobe&) const = default;
};

/// Polarimetric reflectance (pBRDF) without the cosine: a sum of colourless terms, one weight per channel,
/// M(channel) = sum over t of weight(t, channel) * evaluate(t, ...). Immutable.
class Material {
public:
    virtual ~Material() = default;
    Material(const Material&) = delete;
    Material& operator=(const Material&) = delete;

    /// Returns the number of channels; 1 if the material is equal in every channel.
    [[nodiscard]] virtual int channels() const noexcept = 0;
    [[nodiscard]] virtual int terms() const noexcept = 0;
    [[nodiscard]] virtual double weight(int term, int channel) const = 0;

    /// Returns the Mueller matrix, in 1/sr, for light from `towards_light` to `towards_viewer`: unit vectors
    /// in the surface's frame, whose z is the normal. For an anisotropic material, x points to where texture
    /// coordinate u grows. The matrix refers to the theta-phi frames of the propagation directions,
    /// -towards_light and towards_viewer. The matrix is zero if either vector is below the horizon.
    [[nodiscard]] virtual Mueller evaluate(int term, const glm::dvec3& towards_light,
                                           const glm::dvec3& towards_viewer) const = 0;

    /// Computes all terms: out[t] = evaluate(t, ...) for t < terms(). Faster if the terms share work.
    virtual void evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                                std::span<Mueller> out) const;

    /// Computes evaluate_terms() of sixteen pairs of directions in single precision. Terms whose weight is 0
    /// in every channel may be left unchanged.
    /// `columns` is 4, or 1 to compute only the first column of each matrix, which is all that unpolarized
    /// light needs; the other columns are then unspecified.
    virtual void evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                                std::size_t columns, std::span<LaneMueller> out) const;

    /// Returns the angular radius, in radians, of the narrowest feature of a term around the mirror
    /// direction, which an integration over incident directions has to resolve.
    [[nodiscard]] virtual double lobe_width(int term) const noexcept = 0;
    /// Returns the lobe widths along x and along y; the smaller one is lobe_width().
    [[nodiscard]] virtual glm::dvec2 lobe_widths(int term) const noexcept {
        return glm::dvec2(lobe_width(term));
    }

    /// Returns the distribution of a term's facets; that with the longer tail for other terms.
    [[nodiscard]] virtual Distribution distribution(int /*term*/) const noexcept { return Distribution::ggx; }
    /// Returns the facets of a term.
    [[nodiscard]] Lobe lobe(int term) const noexcept { return {lobe_widths(term), distribution(term)}; }

    /// Returns whether a term replaces a smooth surface: a narrow lobe in place of a mirror's delta function,
    /// which no table can hold. Such a term reflects nothing of lights without a size, although evaluate() is
    /// not 0, because a mirror shows these lights as points, which no pixel sees.
    [[nodiscard]] virtual bool smooth(int /*term*/) const noexcept { return false; }

    /// Returns the isotropic material that tables of harmonics use: this material, or the counterpart that an
    /// anisotropic material keeps, with as many terms, the same weights and the same mirror symmetry.
    [[nodiscard]] virtual const Material& isotropic() const noexcept { return *this; }
    /// Returns whether the azimuth of the frame's x axis matters.
    [[nodiscard]] bool anisotropic() const noexcept { return &isotropic() != this; }

    /// Returns whether the isotropic() pBRDF is its own mirror image in every plane through the normal:
    /// mirroring both directions negates the elements that mix (s0, s1) with (s2, s3), and changes nothing
    /// else. Measured materials deviate a little.
    [[nodiscard]] virtual bool mirror_symmetric() const noexcept { return true; }
    /// Returns the number of pairings (LightLayout) in the rows of the response: 1 or 2.
    [[nodiscard]] std::size_t pairings() const noexcept { return mirror_symmetric() ? 1 : 2; }

    /// Returns whether the back of a surface reflects like its front. evaluate() is then also defined if both
    /// directions are below the horizon; tables hold only the front.
    [[nodiscard]] virtual bool twosided() const noexcept { return false; }

    /// Returns the material that the back of a two-sided surface has; null: the material itself. The two
    /// differ if only some parts of a mixture are two-sided: the others are black on the back.
    [[nodiscard]] virtual MaterialPtr behind() const { return nullptr; }

    /// Returns the boundary that transmits light; null: no light passes. Rays follow the light. A delta
    /// function describes what a smooth boundary reflects, so all terms of its material are 0; the terms of a
    /// material with a rough boundary are what its front reflects.
    [[nodiscard]] virtual const SmoothBoundary* smooth_boundary() const noexcept { return nullptr; }

    /// Returns everything that the values depend on, as text: materials with equal keys have equal values.
    /// Empty if that is unknown, as for a callback.
    [[nodiscard]] virtual std::string content_key() const { return {}; }

    /// Returns the coefficient matrix of a channel, cosine included, if it defines the material; else null.
    /// evaluate() is then its reconstruction, and tables are made from it without integration.
    [[nodiscard]] virtual const IsotropicMatrix* matrix(int channel) const;

    /// Returns the bytes of a measured table; 0 for other materials.
    [[nodiscard]] virtual std::uint64_t bytes() const noexcept { return 0; }

    /// Returns how the material varies over a surface; null: the material is the same everywhere. All other
    /// functions of a varying material describe its mean.
    [[nodiscard]] virtual const SpatialVariation* variation() const noexcept { return nullptr; }

protected:
    Material() = default;
};

/// Returns M(channel), the sum over all terms, with the frames and range of Material::evaluate().
[[nodiscard]] Mueller evaluate(const Material& material, int channel, const glm::dvec3& towards_light,
                               const glm::dvec3& towards_viewer);

/// Parameters of Mitsuba 3's `pplastic`: a rough dielectric boundary over a diffuse base.
struct PplasticParameters {
    ColorParameter diffuse_reflectance{0.5};   ///< 0..1
    ColorParameter specular_reflectance{1.0};  ///< 0..1
    double int_ior = 1.49;                     ///< index of the inside, 0.001..1000
    double ext_ior = 1.000277;                 ///< index of the outside, 0.001..1000
    NumberParameter alpha = 0.1;  ///< roughness along x, 0.001..1; a texture is clamped to 0.01..1
    /// Roughness along y, in the range of alpha; 0: alpha. Different values make the material anisotropic,
    /// and isotropic() then has their geometric mean.
    NumberParameter alpha_v = 0;
    Distribution distribution = Distribution::beckmann;
};
/// Returns the material. Throws Error(invalid_argument) that names the parameter out of range, and what the
/// functions of mixture.hpp throw for its textures.
[[nodiscard]] MaterialPtr pplastic(const PplasticParameters& parameters);

/// Returns a Lambertian, depolarizing material of reflectance 0..1. Throws what pplastic() throws.
[[nodiscard]] MaterialPtr diffuse(const ColorParameter& reflectance);

/// Returns the material for both sides of a surface: twosided() is true.
/// Throws Error(invalid_argument) for null.
[[nodiscard]] MaterialPtr twosided(MaterialPtr material);

/// Parameters of a material defined by a function.
struct CallbackParameters {
    /// Mueller matrix without the cosine, in 1/sr, for unit directions in the surface's frame, each with
    /// z > 0. Both frames have x along the s-axis towards_light x towards_viewer and z along the propagation,
    /// as in Fresnel's matrices. For equal directions, x is any perpendicular direction, the same for both
    /// frames. Called from several threads at once; exceptions are passed on.
    std::function<Mueller(int channel, const glm::dvec3& towards_light, const glm::dvec3& towards_viewer)>
        reflect;
    int channels = 1;       ///< 1..16
    double lobe_width = 1;  ///< radians, 0.001..1, see Material::lobe_width()
};
/// Returns the material after testing the function at some directions. Throws Error(invalid_argument) for a
/// parameter out of range, a matrix that is not finite (later also from evaluate()), a function that is not
/// isotropic, or a function that is not mirror symmetric, which is usually a mistake in its frames.
[[nodiscard]] MaterialPtr callback_material(CallbackParameters parameters);

}  // namespace nicol
