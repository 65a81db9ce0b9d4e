// SPDX-License-Identifier: MIT
#include "reference/path_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "material/dielectric.hpp"
#include "material/reflectance.hpp"
#include "reference/path_vertex.hpp"
#include "reference/traced_surface.hpp"
#include "scene/path_depth.hpp"
#include "shading/boundary_split.hpp"

namespace nicol {
namespace {

/// Direction in which a path goes on beyond a smooth boundary.
struct BoundaryEvent {
    Ray ray;                     ///< ray from the boundary towards the light
    Frame incident;              ///< frame of the light that arrives against the ray
    double radiance_scale;       ///< see BoundaryPart
    const SmoothBoundary* body;  ///< body that the ray travels through; null: none
};

/// Chooses reflection or transmission in proportion to their shares of unpolarized light, and moves the
/// path's end from the light that leaves `hit`, in the frame `received`, to the light that arrives. point: in
/// [0, 1). Returns nothing if the boundary absorbs all light.
std::optional<BoundaryEvent> sample_boundary(const SmoothBoundary& boundary, const SurfaceHit& hit,
                                             const Frame& received, double point, PathWorkspace& workspace) {
    const BoundarySplit split = split_at(boundary, hit.geometric_normal, hit.frame[2], received);
    const double reflected = mean_factor(boundary.reflectance) * split.reflected.share;
    const double transmitted = mean_factor(boundary.transmittance) * split.transmitted.share;
    if (!(reflected + transmitted > 0)) return std::nullopt;
    const bool reflects = point * (reflected + transmitted) < reflected;
    const double probability = (reflects ? reflected : transmitted) / (reflected + transmitted);

    const BoundaryPart& part = reflects ? split.reflected : split.transmitted;
    const bool coated = boundary.film != nullptr;
    Mueller event = 1 / probability * part.mueller;
    const std::vector<double>& factors = reflects ? boundary.reflectance : boundary.transmittance;
    for (std::size_t c = 0; c < workspace.throughput.size(); ++c) {
        const int channel = static_cast<int>(c);
        if (coated) event = 1 / probability * mueller_of(boundary, split, part, channel);
        workspace.throughput[c] = workspace.throughput[c] * (of_channel(factors, channel) * event);
    }
    return BoundaryEvent{
        .ray = leaving(hit.position, hit.geometric_normal, part.towards_light, hit.ray_offset),
        .incident = part.incident,
        .radiance_scale = part.radiance_scale,
        .body = body_before(boundary, split, part, workspace.body)};
}

// Number of segments from which on Russian roulette ends paths; Mitsuba's default.
constexpr int kRouletteDepth = 5;
// Largest probability that a path goes on, so that paths end even where surfaces absorb nothing.
constexpr double kSurvival = 0.95;

/// Returns the largest s0 that light with s0 = 1 can have after a path: that of its best polarization.
double largest_share(std::span<const Mueller> throughput) {
    double largest = 0;
    for (const Mueller& m : throughput)
        largest = std::max(largest, m(0, 0) + std::hypot(m(0, 1), m(0, 2), m(0, 3)));
    return largest;
}

/// Russian roulette: returns whether a path goes on, whose throughput then makes up for those that end.
/// radiance_scale: factor of refractions, which absorb nothing. point: in [0, 1).
bool survives(std::span<Mueller> throughput, double radiance_scale, double point) {
    const double probability = std::min(kSurvival, largest_share(throughput) / radiance_scale);
    if (!(point < probability)) return false;
    for (Mueller& m : throughput) m *= 1 / probability;
    return true;
}

/// Multiplies a path's throughput by what the body at its end transmits over a distance.
void absorb(double distance, PathWorkspace& workspace) {
    if (workspace.body == nullptr) return;
    for (std::size_t c = 0; c < workspace.throughput.size(); ++c)
        workspace.throughput[c] *= transmitted_by(workspace.body, static_cast<int>(c), distance);
}

/// Returns whether light leaves the point of a surface against a ray. A perturbed normal may face a viewer
/// who is behind the surface.
bool seen(const SurfaceHit& hit, const glm::dvec3& ray_direction) {
    if (hit.side.material->smooth_boundary() != nullptr)
        return hit.towards_viewer.z * glm::dot(hit.unturned, ray_direction) < 0;
    return hit.towards_viewer.z > 0 && glm::dot(hit.unturned, ray_direction) < 0;
}

}  // namespace

PathTracer::PathTracer(const TracedScene& scene, const SceneLights& lights, int max_depth)
    : scene_(scene), lights_(lights), max_depth_(max_depth) {}

bool PathTracer::add(const Ray& ray, const Frame& received, const LowDiscrepancy& points, std::uint32_t index,
                     std::span<Stokes> sum, PathWorkspace& workspace) const {
    const std::optional<RayHit> found = scene_.visible().intersect(ray);
    Ray seen_along = ray;
    if (found) seen_along.farthest = found->distance;
    begin(seen_along, received, sum.size(), workspace);
    if (!found) {
        lights_.add_background(ray.direction, received, workspace, sum);
        return false;
    }
    lights_.add_emitted(*found, received, workspace, sum);
    follow({.found = *found, .direction = ray.direction, .received = received}, points, index, sum,
           workspace);
    return true;
}

// Begins a path with the polarization elements that the camera sees through along a ray.
void PathTracer::begin(const Ray& ray, const Frame& received, std::size_t channels,
                       PathWorkspace& workspace) const {
    const ElementsOnRay& elements = scene_.elements();
    const auto of_channel = [&](int channel) {
        if (elements.empty()) return frame_rotation(0);
        return elements.mueller(ray, received, channel).value_or(frame_rotation(0));
    };
    workspace.throughput.assign(channels, of_channel(0));
    if (elements.colored())
        for (std::size_t c = 1; c < channels; ++c) workspace.throughput[c] = of_channel(static_cast<int>(c));
    workspace.scattering.resize(channels);
    workspace.incident.resize(channels);
    workspace.irradiance.resize(channels);
    workspace.body = nullptr;
}

void PathTracer::follow(Path path, const LowDiscrepancy& points, std::uint32_t index, std::span<Stokes> sum,
                        PathWorkspace& workspace) const {
    // Each vertex has streams for its lights, for the direction of the next segment and for the roulette.
    VertexPoints vertex_points{.points = points, .index = index, .first_stream = kFirstStream};
    const std::uint32_t roulette = lights_.streams() + 1;
    for (int depth = kDirectLightDepth; depth <= max_depth_; ++depth) {
        const SurfaceHit hit = scene_.surface_at(path.found, path.direction);
        const bool last = depth == max_depth_;
        const SmoothBoundary* const boundary = hit.side.material->smooth_boundary();
        const bool goes_on = boundary != nullptr && !boundary->rough()
                                 ? pass(path, *boundary, hit, vertex_points, sum, workspace)
                                 : scatter(path, hit, vertex_points, last, sum, workspace);
        if (!goes_on || last) return;
        if (depth >= kRouletteDepth &&
            !survives(workspace.throughput, path.radiance_scale, vertex_points.at(roulette).x))
            return;
        vertex_points.first_stream += roulette + 1;
    }
}

bool PathTracer::scatter(Path& path, const SurfaceHit& hit, const VertexPoints& points, bool last,
                         std::span<Stokes> sum, PathWorkspace& workspace) const {
    if (!seen(hit, path.direction)) return false;
    const PathVertex vertex(hit, path.received, workspace);
    if (vertex.mirrors()) return mirror(path, vertex, sum);
    lights_.add_sampled(vertex, points.points, points.index, points.first_stream, sum);
    if (last && !lights_.along()) return false;
    const glm::dvec3 towards_light = vertex.sample(points.at(lights_.streams()));
    if (!vertex.lit_from(towards_light)) return false;
    const std::optional<RayHit> next = lights_.add_along(vertex, towards_light, sum);
    if (!next || last) return false;
    path.radiance_scale *= vertex.extend(towards_light, vertex.pdf(towards_light));
    absorb(next->distance, workspace);
    path.found = *next;
    path.direction = vertex.in_world(towards_light);
    path.seen = false;
    path.received = vertex.incident_frame(towards_light);
    return true;
}

bool PathTracer::mirror(Path& path, const PathVertex& vertex, std::span<Stokes> sum) const {
    const glm::dvec3 towards_light = vertex.mirrored();
    if (!vertex.lit_from(towards_light)) return false;
    vertex.extend_mirrored();
    const Ray ray = vertex.ray(towards_light);
    const Frame incident = vertex.incident_frame(towards_light);
    const std::optional<RayHit> next =
        lights_.add_arriving(ray, incident, path.seen, vertex.workspace(), sum);
    if (!next) return false;
    absorb(next->distance, vertex.workspace());
    path.found = *next;
    path.direction = ray.direction;
    path.received = incident;
    return true;
}

bool PathTracer::pass(Path& path, const SmoothBoundary& boundary, const SurfaceHit& hit,
                      const VertexPoints& points, std::span<Stokes> sum, PathWorkspace& workspace) const {
    const auto event =
        sample_boundary(boundary, hit, path.received, points.at(lights_.streams()).x, workspace);
    if (!event) return false;
    workspace.body = event->body;
    const bool seen = path.seen;
    const std::optional<RayHit> next =
        lights_.add_arriving(event->ray, event->incident, seen, workspace, sum);
    if (!next) return false;
    absorb(next->distance, workspace);
    path = {.found = *next,
            .direction = event->ray.direction,
            .received = event->incident,
            .radiance_scale = path.radiance_scale * event->radiance_scale,
            .seen = seen};
    return true;
}

}  // namespace nicol
