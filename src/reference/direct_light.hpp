// SPDX-License-Identifier: MIT
// Light that reaches the camera along a ray, through polarization elements: from the environment, from
// emissive surfaces, and by one reflection.
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

/// Directions from which the reflection of lights with a size is estimated. Each strategy alone is unbiased;
/// both together, weighted by the balance heuristic, have the least noise. Lights without a size have one
/// direction.
enum class Strategy { both, light, surface };

/// Scene prepared for rays. Immutable; the scene must not change during the object's lifetime.
class DirectLight {
public:
    /// Throws the errors of RayScene.
    DirectLight(const Scene& scene, Strategy strategy, bool shadows);

    /// Returns the origin, in the world, of the coordinates of rays and positions below. The coordinates are
    /// parallel to the world's.
    [[nodiscard]] const glm::dvec3& origin() const noexcept { return origin_; }

    /// Work space of one thread for one reflection, and the thread's count of rays.
    struct Workspace {
        std::vector<Mueller> terms;
        std::vector<glm::vec3> weights;  ///< weights of the layers of the surface's material
        std::vector<double> shares;      ///< probability of each layer to be sampled
        std::vector<Stokes> incident;    ///< incident radiance of each channel
        std::vector<double> irradiance;  ///< irradiance of each channel
        std::vector<Stokes> behind;      ///< light behind the elements
        std::uint64_t shadow_rays = 0;
    };

    [[nodiscard]] int channels() const noexcept { return channels_; }
    [[nodiscard]] std::uint64_t triangles() const noexcept { return triangles_; }

    /// Point where a ray first meets a surface.
    struct Surfel {
        std::uint32_t instance;  ///< id of the instance
        glm::dvec3 position;
        /// Unit shading normal, perturbed by textures; on the viewer's side for a two-sided material.
        glm::dvec3 normal;
    };
    [[nodiscard]] std::optional<Surfel> first_surface(const Ray& ray) const;

    /// First stream of the points that add() takes; add() uses later streams, too.
    static constexpr std::uint32_t kFirstStream = 1;
    /// Adds, for each channel, an estimate of the Stokes vector of the light that travels against the ray, in
    /// the frame `received`, whose z is -ray.direction. The points of this index choose the directions
    /// towards the light. Returns whether the ray meets a surface.
    bool add(const Ray& ray, const Frame& received, const LowDiscrepancy& points, std::uint32_t index,
             std::span<Stokes> sum, Workspace& workspace) const;

private:
    struct Reflection;

    // Adds light like add(), but without elements. found: the place where the ray meets a surface.
    void add_behind_elements(const Ray& ray, const std::optional<RayHit>& found, const Frame& received,
                             const LowDiscrepancy& points, std::uint32_t index, std::span<Stokes> sum,
                             Workspace& workspace) const;
    /// Returns the material of one side of a surface, with samplers of its layers.
    [[nodiscard]] TracedMaterial traced(const Material& material);
    void weigh_layers(const SurfaceHit& hit, Workspace& workspace) const;
    [[nodiscard]] glm::dvec3 sample(const SurfaceHit& hit, const glm::dvec2& point,
                                    const Workspace& workspace) const;
    /// Returns the strategy's density per steradian. of_light: the density of sampling the light.
    [[nodiscard]] double pdf(const Reflection& at, const glm::dvec3& towards_light, double of_light) const;
    void add_background(const glm::dvec3& direction, const Frame& received, std::span<Stokes> sum) const;
    void add_emitted(const RayHit& hit, const Frame& received, std::span<Stokes> sum,
                     Workspace& workspace) const;

    // Each function adds the surface's reflection of a light, unless the light is hidden.
    void add_sampled_environment(Reflection& at, const glm::dvec2& point) const;
    void add_sampled_disc(Reflection& at, const SkyDisc& disc, const glm::dvec2& point) const;
    void add_sampled_area_light(Reflection& at, const RayHit& place) const;
    void add_without_size(Reflection& at, const LocalLight& light) const;
    void add_sampled_surface(Reflection& at, const glm::dvec2& point) const;

    // Each function adds the surface's reflection of a light in a direction. Nothing hides the light.
    void add_environment(Reflection& at, const glm::dvec3& towards_light) const;
    void add_disc(Reflection& at, const SkyDisc& disc, const glm::dvec3& towards_light) const;
    [[nodiscard]] bool add_area_lights(Reflection& at, const glm::dvec3& towards_light) const;
    /// Adds the reflection of light. sized: whether the light has a size; smooth terms do not reflect other
    /// lights.
    void add_reflected(Reflection& at, const glm::dvec3& towards_light, double pdf, bool sized = true) const;

    [[nodiscard]] bool hidden(Reflection& at, const glm::dvec3& towards_light, double distance) const;
    [[nodiscard]] double area_light_pdf(const Reflection& at, const RayHit& place) const;
    [[nodiscard]] Stokes radiance(int channel, const glm::dvec3& towards_light) const;

    glm::dvec3 origin_{0.0};
    const Environment* environment_;
    bool emitters_hidden_;
    /// Environment that environment_ points to, if it had to be made.
    std::unique_ptr<const Environment> table_;
    glm::dmat3 light_to_world_;
    double light_scale_;
    Strategy strategy_;
    bool shadows_;
    int channels_;
    std::uint64_t triangles_ = 0;
    std::vector<TracedSurface> surfaces_;
    std::vector<std::uint32_t> ids_;  // ids of the surfaces' instances
    std::map<const Material*, SurfaceSampler> samplers_;
    std::unique_ptr<LightSampler> light_sampler_;
    std::vector<LocalLight> lights_;  // in the coordinates of rays
    std::vector<const LocalLight*> without_size_;
    std::vector<SkyDisc> discs_;
    std::unique_ptr<AreaLightSampler> area_light_sampler_;
    ElementsOnRay elements_;
    std::unique_ptr<RayScene> rays_;
};

}  // namespace nicol
