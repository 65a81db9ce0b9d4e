// SPDX-License-Identifier: MIT
// Scene prepared for rays: its surfaces and its polarization elements.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "reference/surface_sampler.hpp"
#include "reference/traced_surface.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// Polarization elements along rays. Immutable; threads share it.
class ElementsOnRay {
public:
    ElementsOnRay() = default;
    /// elements: polarization elements in the world. from_world: transform to the rays' coordinates.
    explicit ElementsOnRay(std::span<const SceneElement> elements,
                           const glm::dmat4& from_world = glm::dmat4(1.0));

    [[nodiscard]] bool empty() const noexcept { return elements_.empty(); }
    /// Returns whether the matrices differ between colour channels.
    [[nodiscard]] bool colored() const noexcept { return colored_; }

    /// Returns the product of the Mueller matrices of the elements between ray.nearest and ray.farthest, the
    /// nearest to the ray's origin acting last, for light in the frame `received`, whose z is -ray.direction.
    /// None if there are no elements.
    [[nodiscard]] std::optional<Mueller> mueller(const Ray& ray, const Frame& received, int channel) const;

private:
    struct Element {
        PlacedElement placed;
        ElementTextures textures;
        [[nodiscard]] Mueller mueller(const Frame& received, const glm::dvec2& place, int channel) const;
    };
    std::vector<Element> elements_;
    bool colored_ = false;
};

/// Surfaces of a scene. Immutable; threads share it. The scene must not change during the object's lifetime.
class TracedScene {
public:
    /// Throws the errors of RayScene.
    explicit TracedScene(const Scene& scene);
    TracedScene(const TracedScene&) = delete;
    TracedScene& operator=(const TracedScene&) = delete;

    /// Returns the origin, in the world, of the coordinates of rays and positions. The coordinates are
    /// parallel to the world's.
    [[nodiscard]] const glm::dvec3& origin() const noexcept { return origin_; }
    /// Returns the transform from the world to the coordinates of rays.
    [[nodiscard]] const glm::dmat4& from_world() const noexcept { return from_world_; }
    [[nodiscard]] int channels() const noexcept { return channels_; }
    [[nodiscard]] std::uint64_t triangles() const noexcept { return triangles_; }
    /// Returns the surfaces, one per instance, by the index in RayHit.
    [[nodiscard]] std::span<const TracedSurface> surfaces() const noexcept { return surfaces_; }
    /// Returns all surfaces.
    [[nodiscard]] const RayScene& rays() const noexcept { return *rays_; }
    /// Returns the surfaces that the camera sees, directly, in mirrors and through glass. RayHit::surface is
    /// that of surfaces().
    [[nodiscard]] const RayScene& visible() const noexcept { return *visible_; }
    /// Returns the surfaces that hide lights.
    [[nodiscard]] const RayScene& blockers() const noexcept { return *blockers_; }
    [[nodiscard]] const ElementsOnRay& elements() const noexcept { return elements_; }

    /// Returns the point where a ray along `direction` has met a surface.
    [[nodiscard]] SurfaceHit surface_at(const RayHit& found, const glm::dvec3& direction) const {
        return surface_hit(surfaces_[found.surface], found, -direction);
    }

    /// Point where a ray first meets a surface.
    struct Surfel {
        std::uint32_t instance;  ///< id of the instance
        glm::dvec3 position;
        /// Unit shading normal, perturbed by textures; on the viewer's side for a two-sided material.
        glm::dvec3 normal;
    };
    [[nodiscard]] std::optional<Surfel> first_surface(const Ray& ray) const;

private:
    /// Returns the material of one side of a surface, with samplers of its layers.
    [[nodiscard]] TracedMaterial traced(const Material& material);

    glm::dvec3 origin_{0.0};
    glm::dmat4 from_world_{1.0};
    int channels_;
    std::uint64_t triangles_ = 0;
    std::vector<TracedSurface> surfaces_;
    std::vector<std::uint32_t> ids_;  // ids of the surfaces' instances
    std::map<const Material*, SurfaceSampler> samplers_;
    ElementsOnRay elements_;
    std::shared_ptr<const RayScene> rays_, visible_, blockers_;
};

}  // namespace nicol
