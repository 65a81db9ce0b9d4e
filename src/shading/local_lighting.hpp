// SPDX-License-Identifier: MIT
// Reflection without harmonics: evaluates the pBRDF for samples of local lights and of lobes, and casts
// shadow rays.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "material/layer_weights.hpp"
#include "material/material.hpp"
#include "polarization/views.hpp"
#include "shading/bounced_light.hpp"
#include "shading/focused_light.hpp"
#include "shading/glass_shadows.hpp"
#include "shading/light_source.hpp"
#include "shading/pixel_origins.hpp"
#include "shading/pixel_places.hpp"
#include "shading/reflected_nodes.hpp"
#include "shading/sampled_environment.hpp"

namespace nicol {

/// Points of surfaces, in the axes of lights and rays; at most kLanes.
struct LitPoints {
    std::span<const glm::vec3> positions;
    std::span<const glm::vec3> normals;  ///< unit shading normals
    /// Directions of growing texture coordinate u, unit or 0, for anisotropic materials. Empty: no material
    /// is anisotropic.
    std::span<const glm::vec3> tangents;
    /// Unit geometric normals. Light from below them is hidden by the surface itself, even if a perturbed
    /// normal faces the light. Empty: no texture perturbs normals.
    std::span<const glm::vec3> facets = {};
    /// Unit normals without perturbation, for terminator_shadowing(). Empty: nothing is dimmed by it.
    std::span<const glm::vec3> unperturbed = {};
    /// Start points of shadow rays, see LocalLighting::needs_origins(). Empty: no rays begin.
    std::span<const glm::vec3> origins;
    /// Mirrored surroundings of the points' pixels, see needs_pixels(). Null: points cover nothing.
    const MirroredPixels* mirrored = nullptr;
    /// Parts of those pixels. Empty: what the pixels mirror changes evenly.
    std::span<const MirroredParts> parts = {};
    /// Start points of shadow rays in the points' pixels. Null: points cover nothing.
    PixelOrigins* places = nullptr;
    /// Light that other surfaces reflect to the points, for sampled terms. Null: none.
    const BouncedLight* bounced = nullptr;
    std::span<const std::uint32_t> seeds;
    /// Factors from the points' squared noise to that of their pixels. Empty: 1.
    std::span<const float> noise_factors = {};
    bool shadowed;  ///< whether light may be occluded; false: no ray is traced, but for glass
    /// Whether rays show what glass sends to sampled lobes, so that any glass hides the environment from
    /// them.
    bool rays_pass_glass = false;
    bool receives_shadows = true;  ///< InstanceRoles::receives_shadows; false: glass dims nothing, either
};

/// The material's layers, and one weight per layer if the material is textured.
struct LitMaterial {
    std::span<const Material* const> layers;
    std::span<const LayerWeights> weights;  ///< empty: the weight is 1
};

/// Rays of light samples, and the noise that the samples leave in s0.
struct LightingTally {
    std::uint64_t rays = 0;
    std::uint64_t rays_spared = 0;  ///< rays to lights that add next to nothing
    // Sums over points and channels, times LitPoints::noise_factors.
    double values = 0;
    double power = 0;  ///< of s0^2
    double noise = 0;  ///< of the expected squared errors of s0

    LightingTally& operator+=(const LightingTally& other) {
        rays += other.rays;
        rays_spared += other.rays_spared;
        values += other.values;
        power += other.power;
        noise += other.noise;
        return *this;
    }
};

/// Local lights, the environment of sampled terms, and shadows. Immutable; threads share it.
class LocalLighting {
public:
    struct Lights {
        std::vector<LightSourcePtr> local;
        std::vector<LightSourcePtr> extracted;          ///< lights of the environment
        std::optional<SampledEnvironment> environment;  ///< distant light of sampled terms
        /// Surfaces that hide light from mirrors, and from the lobes of LitPoints::rays_pass_glass; null:
        /// those that cast shadows.
        std::shared_ptr<const RayScene> before_mirrors;
        /// Glass that light of local lights, and of the environment's samples, passes; null: none.
        std::shared_ptr<const GlassShadows> glass, glass_of_environment;
        /// Light of `local` and of `extracted` that smooth surfaces send to others; null: none is known.
        std::shared_ptr<const FocusedLight> focused, focused_extracted;
        std::uint32_t first_index = 0;  ///< index of the first light, by which lights are sampled

        [[nodiscard]] bool any_source() const noexcept { return !local.empty() || !extracted.empty(); }
    };
    /// rays: surfaces that cast shadows, null for none; must outlive this object. samples: number of light
    /// samples for wide lights; narrower lights get fewer. negligible: share of a point's light that the
    /// dimmest lights may add without shadow rays; 0: all lights cast shadows.
    LocalLighting(Lights lights, const RayScene* rays, int samples, double negligible = 0);

    /// Returns lighting of the same surfaces by another light, which takes the samples of the local light
    /// `index` of this lighting.
    [[nodiscard]] LocalLighting with_light(LightSourcePtr source, std::size_t index) const;

    /// Returns whether lights are extracted from the environment.
    [[nodiscard]] bool any_extracted() const noexcept { return !lights_.extracted.empty(); }
    /// Returns whether there is a local or an extracted light.
    [[nodiscard]] bool any_source() const noexcept { return lights_.any_source(); }
    /// Returns whether light that smooth surfaces send to others is known.
    [[nodiscard]] bool any_focused() const noexcept {
        return lights_.focused != nullptr || lights_.focused_extracted != nullptr;
    }
    /// Returns the local and the extracted lights.
    [[nodiscard]] std::vector<const LightSource*> sources() const;
    /// Returns the bits of `points` that a light sample reaches, and dims the light that passes glass.
    /// positions, origins: of the points and of the rays that leave them. Adds the rays to the count.
    [[nodiscard]] std::uint32_t reached(LaneLight& light, std::uint32_t points, const LaneVectors& positions,
                                        const LaneVectors& origins, std::uint64_t& rays) const;
    /// Returns the terms that reflect samples of the environment.
    [[nodiscard]] SampledTerms sampled() const noexcept {
        return lights_.environment ? lights_.environment->sampled() : SampledTerms::none;
    }

    /// Returns whether the material reflects differently from place to place within a pixel, so that
    /// LitPoints::mirrored has an effect.
    [[nodiscard]] bool needs_pixels(const Material& material) const;

    /// Returns whether rays may begin at points. shadowed: LitPoints::shadowed.
    [[nodiscard]] bool needs_origins(bool shadowed) const noexcept {
        return (rays_ != nullptr && (shadowed || lights_.glass != nullptr)) ||
               lights_.before_mirrors != nullptr || lights_.any_source();
    }

    /// Adds to out[c][i] channel c's Stokes vector of point i towards the viewpoint, in the camera's frame
    /// field. `out` holds the light that the points reflect without. The noise is estimated from the
    /// difference of both halves of each light's samples.
    LightingTally add(const Views& views, const LitPoints& points, const LitMaterial& material,
                      std::span<const std::span<glm::vec4>> out) const {
        return add(views, points, material, lights_.environment ? &*lights_.environment : nullptr, samples_,
                   out);
    }
    /// Adds the reflection of local and of extracted lights by all terms, and nothing of the rest of the
    /// environment. samples: number of light samples for wide lights, in place of the object's; 0: only
    /// focused light.
    LightingTally add_lights(const Views& views, const LitPoints& points, const LitMaterial& material,
                             std::uint32_t samples, std::span<const std::span<glm::vec4>> out) const {
        return add(views, points, material, nullptr, samples, out);
    }

private:
    LightingTally add(const Views& views, const LitPoints& points, const LitMaterial& material,
                      const SampledEnvironment* environment, std::uint32_t samples,
                      std::span<const std::span<glm::vec4>> out) const;

    Lights lights_;
    const RayScene* rays_;
    std::uint32_t samples_;
    float negligible_;
};

}  // namespace nicol
