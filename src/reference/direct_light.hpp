// SPDX-License-Identifier: MIT
// The light that reaches the camera along a ray: of the environment and of emissive surfaces, and what a
// surface reflects once, all of it through the elements before.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "reference/elements_on_ray.hpp"
#include "reference/light_samplers.hpp"
#include "reference/low_discrepancy.hpp"
#include "reference/surface_sampler.hpp"
#include "reference/traced_surface.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// Which directions the reflection of lights with a size is estimated from. Each alone is unbiased; together
/// (weighted by the balance heuristic) they are the least noisy. Lights without a size have one direction.
enum class Strategy { both, light, surface };

/// A scene made ready for rays. Immutable; its scene must not change meanwhile.
class DirectLight {
public:
    /// Throws what RayScene throws.
    DirectLight(const Scene& scene, Strategy strategy, bool shadows);

    /// What one thread needs: room for one reflection, and its count.
    struct Workspace {
        std::vector<Mueller> terms;
        std::vector<glm::vec3> weights;  ///< of the layers of the surface's material
        std::vector<double> shares;      ///< the chance of each to be sampled
        std::vector<Stokes> incident;    ///< radiance of each channel
        std::vector<double> irradiance;  ///< likewise
        std::vector<Stokes> behind;      ///< elements
        std::uint64_t shadow_rays = 0;
    };

    [[nodiscard]] int channels() const noexcept { return channels_; }
    [[nodiscard]] std::uint64_t triangles() const noexcept { return triangles_; }

    /// The point where a ray first meets a surface.
    struct Surfel {
        std::uint32_t instance;  ///< id
        glm::dvec3 position;
        glm::dvec3
            normal;  ///< shading, unit, by its texture too; of a two-sided material on the viewer's side
    };
    [[nodiscard]] std::optional<Surfel> first_surface(const Ray& ray) const;

    /// add() takes points of this stream and of those that follow.
    static constexpr std::uint32_t kFirstStream = 1;
    /// Adds, for each channel, an estimate of the Stokes vector of the light that travels against the ray, in
    /// `received`, whose z is -ray.direction. The points of this index choose the directions towards the
    /// light. Returns whether the ray meets a surface.
    bool add(const Ray& ray, const Frame& received, const LowDiscrepancy& points, std::uint32_t index,
             std::span<Stokes> sum, Workspace& workspace) const;

private:
    struct Reflection;

    // As add(), without elements; `found`: where the ray meets a surface.
    void add_behind_elements(const Ray& ray, const std::optional<RayHit>& found, const Frame& received,
                             const LowDiscrepancy& points, std::uint32_t index, std::span<Stokes> sum,
                             Workspace& workspace) const;
    void weigh_layers(const SurfaceHit& hit, Workspace& workspace) const;
    [[nodiscard]] glm::dvec3 sample(const SurfaceHit& hit, const glm::dvec2& point,
                                    const Workspace& workspace) const;
    /// Of the strategy, where sampling the light has `of_light`; per steradian.
    [[nodiscard]] double pdf(const Reflection& at, const glm::dvec3& towards_light, double of_light) const;
    void add_background(const glm::dvec3& direction, const Frame& received, std::span<Stokes> sum) const;
    void add_emitted(const RayHit& hit, const Frame& received, std::span<Stokes> sum,
                     Workspace& workspace) const;

    // Each adds what the surface reflects of a light, unless that is hidden.
    void add_sampled_environment(Reflection& at, const glm::dvec2& point) const;
    void add_sampled_disc(Reflection& at, const SkyDisc& disc, const glm::dvec2& point) const;
    void add_sampled_area_light(Reflection& at, const RayHit& place) const;
    void add_without_size(Reflection& at, const LocalLight& light) const;
    void add_sampled_surface(Reflection& at, const glm::dvec2& point) const;

    // Each adds what the surface reflects of a light in a direction, which nothing hides.
    void add_environment(Reflection& at, const glm::dvec3& towards_light) const;
    void add_disc(Reflection& at, const SkyDisc& disc, const glm::dvec3& towards_light) const;
    [[nodiscard]] bool add_area_lights(Reflection& at, const glm::dvec3& towards_light) const;
    /// `sized`: of a light with a size; of others smooth terms reflect nothing.
    void add_reflected(Reflection& at, const glm::dvec3& towards_light, double pdf, bool sized = true) const;

    [[nodiscard]] bool hidden(Reflection& at, const glm::dvec3& towards_light, double distance) const;
    [[nodiscard]] double area_light_pdf(const Reflection& at, const RayHit& place) const;
    [[nodiscard]] Stokes radiance(int channel, const glm::dvec3& towards_light) const;

    const Environment* environment_;
    bool emitters_hidden_;
    std::unique_ptr<const Environment> table_;  ///< what environment_ points to, where it had to be made
    glm::dmat3 light_to_world_;
    double light_scale_;
    Strategy strategy_;
    bool shadows_;
    int channels_;
    std::uint64_t triangles_ = 0;
    std::vector<TracedSurface> surfaces_;
    std::vector<std::uint32_t> ids_;  // of their instances
    std::map<const Material*, SurfaceSampler> samplers_;
    std::unique_ptr<LightSampler> light_sampler_;
    std::vector<const LocalLight*> without_size_;
    std::vector<SkyDisc> discs_;
    std::unique_ptr<AreaLightSampler> area_light_sampler_;
    ElementsOnRay elements_;
    std::unique_ptr<RayScene> rays_;
};

}  // namespace nicol
