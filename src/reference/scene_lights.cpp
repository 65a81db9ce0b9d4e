// SPDX-License-Identifier: MIT
#include "reference/scene_lights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "geometry/beyond_hit.hpp"
#include "reference/light_arrival.hpp"

namespace nicol {
namespace {

constexpr double kSky = std::numeric_limits<double>::infinity();

// Streams of the points at a vertex. One more stream follows for each disc and each area light's sample.
constexpr std::uint32_t kEnvironmentStream = 0;
constexpr std::uint32_t kDiscStream = 1;

}  // namespace

SceneLights::SceneLights(const Scene& scene, const TracedScene& surfaces, Strategy strategy, bool shadows)
    : surfaces_(surfaces),
      environment_(scene.distant_light().get()),
      emitters_hidden_(scene.emitters_hidden()),
      light_to_world_(scene.light_rotation()),
      light_scale_(scene.light_scale()),
      strategy_(strategy),
      shadows_(shadows),
      lights_(scene.lights().begin(), scene.lights().end()),
      area_light_sampler_(surfaces.surfaces()) {
    if (environment_ != nullptr) {
        check_brightness(environment_->project(0), light_scale_);
        light_sampler_ = std::make_unique<LightSampler>(*environment_);
        table_ = environment_->tabulated();
        if (table_) environment_ = table_.get();
    }
    for (LocalLight& light : lights_) {
        light.to_world = surfaces.from_world() * light.to_world;
        if (without_size(light))
            without_size_.push_back(&light);
        else
            discs_.emplace_back(light);
    }
}

std::uint32_t SceneLights::streams() const noexcept {
    return kDiscStream + static_cast<std::uint32_t>(discs_.size() + area_light_sampler_.samples());
}

bool SceneLights::along() const noexcept {
    return strategy_ != Strategy::light &&
           (environment_ != nullptr || !discs_.empty() || area_light_sampler_.samples() > 0);
}

void SceneLights::add_background(const glm::dvec3& direction, const Frame& received, PathWorkspace& workspace,
                                 std::span<Stokes> sum) const {
    if (!emitters_hidden_) add_sky(direction, received, workspace, sum);
}

void SceneLights::add_emitted(const RayHit& hit, const Frame& received, PathWorkspace& workspace,
                              std::span<Stokes> sum) const {
    if (!emitters_hidden_) add_emission(hit, received, workspace, sum);
}

void SceneLights::add_sky(const glm::dvec3& direction, const Frame& received, PathWorkspace& workspace,
                          std::span<Stokes> sum) const {
    if (environment_ == nullptr) return;
    set_incident(glm::normalize(direction * light_to_world_), received, workspace);
    workspace.absorb(workspace.body, kSky);
    add_incident(workspace, sum);
}

void SceneLights::add_emission(const RayHit& hit, const Frame& received, PathWorkspace& workspace,
                               std::span<Stokes> sum) const {
    if (!surfaces_.surfaces()[hit.surface].emitted(hit, received, workspace.incident)) return;
    workspace.absorb(workspace.body, hit.distance);
    add_incident(workspace, sum);
}

void SceneLights::add_incident(const PathWorkspace& workspace, std::span<Stokes> sum) {
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += workspace.throughput[c] * workspace.incident[c];
}

void SceneLights::add_sampled(const PathVertex& vertex, const LowDiscrepancy& points, std::uint32_t index,
                              std::uint32_t stream, std::span<Stokes> sum) const {
    const Reflection at{.vertex = vertex, .workspace = vertex.workspace(), .sum = sum};
    for (const LocalLight* const light : without_size_) add_without_size(at, *light);
    if (strategy_ == Strategy::surface) return;
    if (environment_ != nullptr && !light_sampler_->dark())
        add_sampled_environment(at, points.point(index, stream + kEnvironmentStream));
    stream += kDiscStream;
    for (const SkyDisc& disc : discs_) add_sampled_disc(at, disc, points.point(index, stream++));
    for (std::size_t i = 0; i < area_light_sampler_.samples(); ++i)
        add_sampled_area_light(at, area_light_sampler_.sample(i, points.point(index, stream++)));
}

template <class Visit>
bool SceneLights::visit_surfaces(Ray ray, Hiding hiding, PathWorkspace& workspace,
                                 std::optional<RayHit>& first, const Visit& visit) const {
    if (shadows_) ++workspace.shadow_rays;
    const bool seen = hiding == Hiding::visible;
    const RayScene& rays = seen ? surfaces_.visible() : surfaces_.rays();
    while (const std::optional<RayHit> found = rays.intersect(ray)) {
        const TracedSurface& surface = surfaces_.surfaces()[found->surface];
        const bool hides = seen || (hiding == Hiding::blockers && surface.blocks());
        if (!first && (hides || !shadows_)) first = found;
        visit(*found);
        if (shadows_ && hides) return false;
        ray.nearest = beyond(*found, surface.ray_offset(*found));
    }
    return true;
}

std::optional<RayHit> SceneLights::add_along(const PathVertex& vertex, const glm::dvec3& towards_light,
                                             std::span<Stokes> sum) const {
    const Reflection at{.vertex = vertex, .workspace = vertex.workspace(), .sum = sum};
    std::optional<RayHit> first;
    const Hiding hiding = vertex.hit().receives_shadows ? Hiding::blockers : Hiding::none;
    const auto visit = [&](const RayHit& found) {
        if (along()) add_area_light(at, towards_light, found);
    };
    const bool sky = visit_surfaces(vertex.ray(towards_light), hiding, at.workspace, first, visit);
    if (hiding == Hiding::none) first.reset();
    if (!sky || !along()) return first;
    if (environment_ != nullptr) add_environment(at, towards_light);
    for (const SkyDisc& disc : discs_) add_disc(at, disc, towards_light);
    return first;
}

std::optional<RayHit> SceneLights::add_arriving(const Ray& ray, const Frame& received, bool seen,
                                                PathWorkspace& workspace, std::span<Stokes> sum) const {
    std::optional<RayHit> first;
    const auto visit = [&](const RayHit& found) { add_emission(found, received, workspace, sum); };
    const bool sky = visit_surfaces(ray, seen ? Hiding::visible : Hiding::blockers, workspace, first, visit);
    if (!sky) return first;
    add_sky(ray.direction, received, workspace, sum);
    for (const SkyDisc& disc : discs_) {
        if (disc.pdf(ray.direction) == 0) continue;
        set_incident(disc, received, workspace);
        workspace.absorb(workspace.body, kSky);
        add_incident(workspace, sum);
    }
    return first;
}

double SceneLights::pdf(const Reflection& at, const glm::dvec3& towards_light, double of_light) const {
    double sum = strategy_ != Strategy::surface ? of_light : 0;
    if (strategy_ != Strategy::light) sum += at.vertex.pdf(towards_light);
    return sum;
}

void SceneLights::add_sampled_environment(const Reflection& at, const glm::dvec2& point) const {
    const LightSample light = light_sampler_->sample(point);
    const glm::dvec3 towards_light = (light_to_world_ * light.towards_light) * at.vertex.hit().frame;
    if (at.vertex.lit_from(towards_light) && !hidden(at, towards_light, kSky))
        add_environment(at, towards_light);
}

void SceneLights::add_sampled_disc(const Reflection& at, const SkyDisc& disc, const glm::dvec2& point) const {
    const glm::dvec3 towards_light = disc.sample(point) * at.vertex.hit().frame;
    if (at.vertex.lit_from(towards_light) && !hidden(at, towards_light, kSky))
        add_disc(at, disc, towards_light);
}

void SceneLights::add_sampled_area_light(const Reflection& at, const RayHit& place) const {
    const TracedSurface& area_light = surfaces_.surfaces()[place.surface];
    const glm::dvec3 way = area_light.position(place) - at.vertex.hit().position;
    const double distance = glm::length(way);
    const double cosine = std::abs(glm::dot(area_light.geometric_normal(place), way)) / distance;
    if (!(cosine > 0)) return;
    const glm::dvec3 towards_light = way / distance * at.vertex.hit().frame;
    if (!at.vertex.lit_from(towards_light)) return;
    if (!area_light.emitted(place, at.vertex.incident_frame(towards_light), at.workspace.incident)) return;
    // The ray starts off the surface, so it meets the area light's plane earlier by this offset, or by more
    // at a slant.
    const double offset = std::max(at.vertex.hit().ray_offset, area_light.ray_offset(place));
    if (hidden(at, towards_light, distance - 2 * offset / cosine)) return;
    at.vertex.absorb(towards_light, distance);
    at.vertex.add_reflected(towards_light, pdf(at, towards_light, area_light_pdf(at, place)), true, at.sum);
}

void SceneLights::add_without_size(const Reflection& at, const LocalLight& light) const {
    const auto arrival = light_arrival(light, at.vertex.hit().position, at.workspace.irradiance);
    if (!arrival) return;
    const glm::dvec3 towards_light = arrival->towards_light * at.vertex.hit().frame;
    if (!at.vertex.lit_from(towards_light)) return;
    if (hidden(at, towards_light, arrival->distance - 2 * at.vertex.hit().ray_offset)) return;
    const Stokes state = stokes_in(at.vertex.incident_frame(towards_light), light.state,
                                   axis_in_world(light.to_world, light.state));
    for (std::size_t c = 0; c < at.sum.size(); ++c)
        at.workspace.incident[c] = at.workspace.irradiance[c] * state;
    at.vertex.absorb(towards_light, arrival->distance);
    at.vertex.add_reflected(towards_light, 1, false, at.sum);
}

void SceneLights::add_environment(const Reflection& at, const glm::dvec3& towards_light) const {
    const glm::dvec3 in_light = glm::normalize(at.vertex.in_world(towards_light) * light_to_world_);
    set_incident(in_light, at.vertex.incident_frame(towards_light), at.workspace);
    at.vertex.absorb(towards_light, kSky);
    const double of_light =
        light_sampler_->pdf(glm::normalize(at.vertex.hit().frame * towards_light * light_to_world_));
    at.vertex.add_reflected(towards_light, pdf(at, towards_light, of_light), true, at.sum);
}

void SceneLights::add_disc(const Reflection& at, const SkyDisc& disc, const glm::dvec3& towards_light) const {
    const double of_light = disc.pdf(at.vertex.in_world(towards_light));
    if (of_light == 0) return;
    set_incident(disc, at.vertex.incident_frame(towards_light), at.workspace);
    at.vertex.absorb(towards_light, kSky);
    at.vertex.add_reflected(towards_light, pdf(at, towards_light, of_light), true, at.sum);
}

void SceneLights::set_incident(const glm::dvec3& in_light, const Frame& frame,
                               PathWorkspace& workspace) const {
    const double angle =
        environment_->polarized() ? angle_between(light_to_world_ * theta_phi_frame(-in_light), frame) : 0;
    for (std::size_t c = 0; c < workspace.incident.size(); ++c)
        workspace.incident[c] = rotated(radiance(static_cast<int>(c), in_light), angle);
}

void SceneLights::set_incident(const SkyDisc& disc, const Frame& frame, PathWorkspace& workspace) const {
    const LocalLight& light = disc.light();
    const Stokes state = stokes_in(frame, light.state, axis_in_world(light.to_world, light.state));
    for (std::size_t c = 0; c < workspace.incident.size(); ++c)
        workspace.incident[c] = disc.radiance(static_cast<int>(c)) * state;
}

void SceneLights::add_area_light(const Reflection& at, const glm::dvec3& towards_light,
                                 const RayHit& place) const {
    const TracedSurface& area_light = surfaces_.surfaces()[place.surface];
    if (!area_light.emitted(place, at.vertex.incident_frame(towards_light), at.workspace.incident)) return;
    at.vertex.absorb(towards_light, place.distance);
    at.vertex.add_reflected(towards_light, pdf(at, towards_light, area_light_pdf(at, place)), true, at.sum);
}

bool SceneLights::hidden(const Reflection& at, const glm::dvec3& towards_light, double distance) const {
    if (!shadows_ || !at.vertex.hit().receives_shadows) return false;
    ++at.workspace.shadow_rays;
    Ray ray = at.vertex.ray(towards_light);
    ray.farthest = std::max(0.0, distance);
    return surfaces_.blockers().occluded(ray);
}

// Returns the density, per steradian, of the area lights' samples at a place.
double SceneLights::area_light_pdf(const Reflection& at, const RayHit& place) const {
    const TracedSurface& area_light = surfaces_.surfaces()[place.surface];
    const glm::dvec3 way = area_light.position(place) - at.vertex.hit().position;
    const double distance = glm::length(way);
    return area_light_sampler_.density(place.surface) * distance * distance * distance /
           std::abs(glm::dot(area_light.geometric_normal(place), way));
}

Stokes SceneLights::radiance(int channel, const glm::dvec3& towards_light) const {
    return light_scale_ * environment_->radiance(environment_->channels() == 1 ? 0 : channel, towards_light);
}

}  // namespace nicol
