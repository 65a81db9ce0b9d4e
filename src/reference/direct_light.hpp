// SPDX-License-Identifier: MIT
// The light that reaches the camera along a ray: the environment's, directly or after one reflection.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "reference/light_sampler.hpp"
#include "reference/surface_sampler.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// Which directions a reflection is estimated from. Each alone is unbiased; together (weighted by the balance
/// heuristic) they are the least noisy.
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

    /// Adds, for each channel, an estimate of the Stokes vector of the light that travels against the ray, in
    /// `received`, whose z is -ray.direction. The points in [0, 1)^2 choose the directions towards the light.
    /// Returns whether the ray meets a surface.
    bool add(const Ray& ray, const Frame& received, const glm::dvec2& light_point,
             const glm::dvec2& surface_point, std::span<Stokes> sum, Workspace& workspace) const;

private:
    struct Layer {
        const Material* material;
        const SurfaceSampler* sampler;
    };
    struct Surface {
        Mesh mesh;  ///< in the world
        const Material* material;
        std::vector<Layer> layers;  ///< of a material that varies; else itself
    };
    struct Hit;

    [[nodiscard]] Presence presence_of(const Surface& surface) const;
    [[nodiscard]] Hit hit_at(const RayHit& hit, const glm::dvec3& towards_viewer) const;
    void weigh_layers(const Hit& hit, Workspace& workspace) const;
    [[nodiscard]] glm::dvec3 sample(const Hit& hit, const glm::dvec2& point,
                                    const Workspace& workspace) const;
    void add_background(const glm::dvec3& direction, const Frame& received, std::span<Stokes> sum) const;
    void add_reflected(const Hit& hit, const glm::dvec3& towards_light, double pdf, const Frame& received,
                       std::span<Stokes> sum, Workspace& workspace) const;
    [[nodiscard]] double pdf(const Hit& hit, const glm::dvec3& towards_light,
                             const Workspace& workspace) const;
    [[nodiscard]] Stokes radiance(int channel, const glm::dvec3& towards_light) const;

    const Environment* environment_;
    std::unique_ptr<const Environment> table_;  ///< what environment_ points to, where it had to be made
    glm::dmat3 light_to_world_;
    double light_scale_;
    Strategy strategy_;
    bool shadows_;
    int channels_ = 1;
    std::uint64_t triangles_ = 0;
    std::vector<Surface> surfaces_;
    std::vector<std::uint32_t> ids_;  // of their instances
    std::map<const Material*, SurfaceSampler> samplers_;
    std::unique_ptr<LightSampler> light_sampler_;
    std::unique_ptr<RayScene> rays_;
};

}  // namespace nicol
