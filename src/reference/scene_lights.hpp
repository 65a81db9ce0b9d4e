// SPDX-License-Identifier: MIT
// Lights of a scene, and the light of them that the vertices of a path reflect.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "reference/light_samplers.hpp"
#include "reference/low_discrepancy.hpp"
#include "reference/path_vertex.hpp"
#include "reference/traced_scene.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// Directions from which the reflection of lights with a size is estimated. Each strategy alone is unbiased;
/// both together, weighted by the balance heuristic, have the least noise. Lights without a size have one
/// direction.
enum class Strategy { both, light, surface };

/// The environment, local lights and emissive surfaces. Immutable; threads share it.
class SceneLights {
public:
    /// Keeps references to both arguments. shadows: whether surfaces hide light.
    SceneLights(const Scene& scene, const TracedScene& surfaces, Strategy strategy, bool shadows);

    /// Returns the number of streams of points that add_sampled() takes.
    [[nodiscard]] std::uint32_t streams() const noexcept;
    /// Returns whether add_along() can add light.
    [[nodiscard]] bool along() const noexcept;

    // Each function adds to `sum`, for each channel, light that the camera sees through the throughput of a
    // path. For these two functions, `received` is the frame at the path's end.

    /// Adds the environment in a direction of the world, unless the camera does not see emitters.
    void add_background(const glm::dvec3& direction, const Frame& received, PathWorkspace& workspace,
                        std::span<Stokes> sum) const;
    /// Adds the emission of a surface, unless the camera does not see emitters.
    void add_emitted(const RayHit& hit, const Frame& received, PathWorkspace& workspace,
                     std::span<Stokes> sum) const;

    /// Adds the vertex's reflection of lights without a size, and of a sample of each other light. The
    /// points of this index in the streams from `stream` on choose the directions.
    void add_sampled(const PathVertex& vertex, const LowDiscrepancy& points, std::uint32_t index,
                     std::uint32_t stream, std::span<Stokes> sum) const;
    /// Adds the vertex's reflection of the lights with a size in a direction that PathVertex::sample() has
    /// chosen. Returns the first surface in this direction whose light reaches the vertex.
    std::optional<RayHit> add_along(const PathVertex& vertex, const glm::dvec3& towards_light,
                                    std::span<Stokes> sum) const;
    /// Adds the light of the lights with a size that arrives against a ray, in the frame `received` at the
    /// path's end, as a smooth boundary shows it. seen: whether the camera sees the boundary, so that visible
    /// surfaces hide light; otherwise those that cast shadows do. Returns the first of them on the ray.
    std::optional<RayHit> add_arriving(const Ray& ray, const Frame& received, bool seen,
                                       PathWorkspace& workspace, std::span<Stokes> sum) const;

private:
    /// Light that add functions add to, at a vertex.
    struct Reflection {
        const PathVertex& vertex;
        PathWorkspace& workspace;
        std::span<Stokes> sum;
    };

    /// Returns the density, per steradian, of all directions that the strategy chooses. of_light: density of
    /// sampling the light.
    [[nodiscard]] double pdf(const Reflection& at, const glm::dvec3& towards_light, double of_light) const;
    [[nodiscard]] double area_light_pdf(const Reflection& at, const RayHit& place) const;
    [[nodiscard]] bool hidden(const Reflection& at, const glm::dvec3& towards_light, double distance) const;
    [[nodiscard]] Stokes radiance(int channel, const glm::dvec3& towards_light) const;
    /// Surfaces that hide what is behind them.
    enum class Hiding { none, blockers, visible };
    /// Calls visit(hit) for the surfaces on a ray up to the first one that hides light, or for all of them.
    /// Sets `first` to that one, or to the first of all if nothing casts shadows. Returns whether light of
    /// the sky arrives.
    template <class Visit>
    bool visit_surfaces(Ray ray, Hiding hiding, PathWorkspace& workspace, std::optional<RayHit>& first,
                        const Visit& visit) const;

    // Each function adds, as the public functions, but also if the camera does not see emitters.
    void add_sky(const glm::dvec3& direction, const Frame& received, PathWorkspace& workspace,
                 std::span<Stokes> sum) const;
    void add_emission(const RayHit& hit, const Frame& received, PathWorkspace& workspace,
                      std::span<Stokes> sum) const;

    // Each function adds the reflection of a light, unless the light is hidden.
    void add_sampled_environment(const Reflection& at, const glm::dvec2& point) const;
    void add_sampled_disc(const Reflection& at, const SkyDisc& disc, const glm::dvec2& point) const;
    void add_sampled_area_light(const Reflection& at, const RayHit& place) const;
    void add_without_size(const Reflection& at, const LocalLight& light) const;

    /// Adds the incident radiance through the path's throughput.
    static void add_incident(const PathWorkspace& workspace, std::span<Stokes> sum);

    // Each function sets the incident radiance, in a frame of the world: to that of the environment from a
    // direction in its own axes, or of a disc.
    void set_incident(const glm::dvec3& in_light, const Frame& frame, PathWorkspace& workspace) const;
    void set_incident(const SkyDisc& disc, const Frame& frame, PathWorkspace& workspace) const;

    // Each function adds the reflection of a light in a direction. Nothing hides the light.
    void add_environment(const Reflection& at, const glm::dvec3& towards_light) const;
    void add_disc(const Reflection& at, const SkyDisc& disc, const glm::dvec3& towards_light) const;
    void add_area_light(const Reflection& at, const glm::dvec3& towards_light, const RayHit& place) const;

    const TracedScene& surfaces_;
    const Environment* environment_;
    bool emitters_hidden_;
    /// Environment that environment_ points to, if it had to be made.
    std::unique_ptr<const Environment> table_;
    glm::dmat3 light_to_world_;
    double light_scale_;
    Strategy strategy_;
    bool shadows_;
    std::unique_ptr<LightSampler> light_sampler_;
    std::vector<LocalLight> lights_;  // in the coordinates of rays
    std::vector<const LocalLight*> without_size_;
    std::vector<SkyDisc> discs_;
    AreaLightSampler area_light_sampler_;
};

}  // namespace nicol
