// SPDX-License-Identifier: MIT
#include "reference/direct_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <utility>

#include "geometry/graded_mesh.hpp"
#include "material/spatial_variation.hpp"
#include "reference/light_arrival.hpp"
#include "scene/middle.hpp"
#include "shading/normal_variation.hpp"

namespace nicol {
namespace {

constexpr double kSky = std::numeric_limits<double>::infinity();

// Streams of the points. One more stream follows for each disc and each area light's sample.
constexpr std::uint32_t kEnvironmentStream = DirectLight::kFirstStream;
constexpr std::uint32_t kSurfaceStream = kEnvironmentStream + 1;
constexpr std::uint32_t kDiscStream = kSurfaceStream + 1;

glm::dvec3 axis_in_world(const glm::dmat4& to_world, const PolarizationState& state) {
    return glm::normalize(glm::dmat3(to_world) * state.axis);
}

// Returns the meshes of a scene's instances in the coordinates of rays, with triangles divided that are far
// larger than an object beside them.
std::vector<Mesh> placed_meshes(const Scene& scene, const glm::dmat4& from_world) {
    std::vector<Mesh> meshes;
    std::vector<MeshExtent> extents;
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const Instance& instance = scene.instances()[i];
        meshes.push_back(placed(*instance.mesh, from_world * instance.to_world, scene.ids()[i]));
        extents.push_back(extent_of(meshes.back()));
    }
    const Details details(extents);
    for (std::size_t i = 0; i < meshes.size(); ++i)
        if (const auto divided = graded(meshes[i], details.beside(extents[i]))) meshes[i] = *divided;
    return meshes;
}

}  // namespace

/// Reflection at a point of a surface. Directions towards the light are in the surface's frame.
struct DirectLight::Reflection {
    const SurfaceHit& hit;
    const Frame& received;
    std::span<Stokes> sum;
    Workspace& workspace;

    [[nodiscard]] glm::dvec3 in_world(const glm::dvec3& towards_light) const {
        return glm::normalize(hit.frame * towards_light);
    }
    /// Returns the frame, in the world, of the light from a direction.
    [[nodiscard]] Frame incident_frame(const glm::dvec3& towards_light) const {
        return hit.frame * theta_phi_frame(-towards_light);
    }
    /// Returns the ray from the point towards the light.
    [[nodiscard]] Ray ray(const glm::dvec3& towards_light) const {
        return leaving(hit.position, hit.geometric_normal, in_world(towards_light), hit.ray_offset);
    }
    /// Returns the factor of light from a direction, for a perturbed normal.
    [[nodiscard]] double dimming(const glm::dvec3& towards_light) const {
        if (!hit.dimmed) return 1;
        return static_cast<double>(
            terminator_shadowing(static_cast<float>(glm::dot(hit.unturned, hit.frame[2])),
                                 static_cast<float>(glm::dot(hit.unturned, in_world(towards_light)))));
    }
    /// Returns whether light from a direction can reach the surface. A perturbed normal may face light from
    /// below the surface, which the surface hides.
    [[nodiscard]] bool lit_from(const glm::dvec3& towards_light) const {
        return towards_light.z > 0 && glm::dot(in_world(towards_light), hit.unturned) > 0;
    }
};

DirectLight::DirectLight(const Scene& scene, Strategy strategy, bool shadows)
    : environment_(scene.environment().get()),
      emitters_hidden_(scene.emitters_hidden()),
      light_to_world_(scene.light_rotation()),
      light_scale_(scene.light_scale()),
      strategy_(strategy),
      shadows_(shadows),
      channels_(scene.channels()) {
    if (!scene.instances().empty()) origin_ = middle_of(scene.instances()[largest_instance(scene)]);
    const glm::dmat4 from_world = from_middle(origin_);
    elements_ = ElementsOnRay(scene.elements(), from_world);
    if (environment_ != nullptr) {
        check_brightness(environment_->project(0), light_scale_);
        light_sampler_ = std::make_unique<LightSampler>(*environment_);
        table_ = environment_->tabulated();
        if (table_) environment_ = table_.get();
    }
    lights_.assign(scene.lights().begin(), scene.lights().end());
    for (LocalLight& light : lights_) {
        light.to_world = from_world * light.to_world;
        if (without_size(light))
            without_size_.push_back(&light);
        else
            discs_.emplace_back(light);
    }
    std::vector<RaySurface> triangles;
    surfaces_.reserve(scene.instances().size());
    ids_ = scene.ids();
    std::vector<Mesh> meshes = placed_meshes(scene, from_world);
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        const Instance& instance = scene.instances()[i];
        const MaterialPtr behind = instance.material->behind();
        TracedSurface& surface =
            surfaces_.emplace_back(TracedSurface{.mesh = std::move(meshes[i]),
                                                 .front = traced(*instance.material),
                                                 .back = traced(behind ? *behind : *instance.material),
                                                 .emission = instance.emission.get()});
        if (surface.emission != nullptr)
            surface.emission_axis = axis_in_world(instance.to_world, surface.emission->state);
        triangles.push_back({.positions = surface.mesh.positions,
                             .triangles = surface.mesh.triangles,
                             .present = surface.presence()});
        triangles_ += surface.mesh.triangles.size();
    }
    area_light_sampler_ = std::make_unique<AreaLightSampler>(surfaces_);
    rays_ = std::make_unique<RayScene>(triangles);
}

TracedMaterial DirectLight::traced(const Material& material) {
    TracedMaterial out{.material = &material, .layers = {}};
    const auto add_layer = [&](const Material& layer) {
        const SurfaceSampler& sampler = samplers_.try_emplace(&layer, layer).first->second;
        out.layers.push_back({.material = &layer, .sampler = &sampler});
    };
    if (const SpatialVariation* const variation = material.variation()) {
        for (const MaterialLayer& layer : variation->layers) add_layer(*layer.material);
    } else {
        add_layer(material);
    }
    return out;
}

std::optional<DirectLight::Surfel> DirectLight::first_surface(const Ray& ray) const {
    const std::optional<RayHit> found = rays_->intersect(ray);
    if (!found) return std::nullopt;
    const SurfaceHit hit = surface_hit(surfaces_[found->surface], *found, -ray.direction);
    return Surfel{.instance = ids_[found->surface], .position = hit.position, .normal = hit.frame[2]};
}

bool DirectLight::add(const Ray& ray, const Frame& received, const LowDiscrepancy& points,
                      std::uint32_t index, std::span<Stokes> sum, Workspace& workspace) const {
    workspace.incident.resize(sum.size());
    workspace.irradiance.resize(sum.size());
    const std::optional<RayHit> found = rays_->intersect(ray);
    std::optional<Mueller> elements;
    if (!elements_.empty()) {
        Ray before = ray;
        if (found) before.farthest = found->distance;
        elements = elements_.mueller(before, received);
    }
    if (!elements) {
        add_behind_elements(ray, found, received, points, index, sum, workspace);
        return found.has_value();
    }
    workspace.behind.assign(sum.size(), Stokes(0.0));
    add_behind_elements(ray, found, received, points, index, workspace.behind, workspace);
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += *elements * workspace.behind[c];
    return found.has_value();
}

void DirectLight::add_behind_elements(const Ray& ray, const std::optional<RayHit>& found,
                                      const Frame& received, const LowDiscrepancy& points,
                                      std::uint32_t index, std::span<Stokes> sum,
                                      Workspace& workspace) const {
    if (!found) {
        if (environment_ != nullptr && !emitters_hidden_) add_background(ray.direction, received, sum);
        return;
    }
    if (!emitters_hidden_) add_emitted(*found, received, sum, workspace);
    const SurfaceHit hit = surface_hit(surfaces_[found->surface], *found, -ray.direction);
    // A perturbed normal may face a viewer who is behind the surface.
    if (!(hit.towards_viewer.z > 0 && glm::dot(hit.unturned, ray.direction) < 0)) return;
    weigh_layers(hit, workspace);

    Reflection at{.hit = hit, .received = received, .sum = sum, .workspace = workspace};
    const std::size_t area_lights = area_light_sampler_->samples();
    if (strategy_ != Strategy::surface) {
        if (environment_ != nullptr && !light_sampler_->dark())
            add_sampled_environment(at, points.point(index, kEnvironmentStream));
        std::uint32_t stream = kDiscStream;
        for (const SkyDisc& disc : discs_) add_sampled_disc(at, disc, points.point(index, stream++));
        for (std::size_t i = 0; i < area_lights; ++i)
            add_sampled_area_light(at, area_light_sampler_->sample(i, points.point(index, stream++)));
    }
    const bool anything_with_size = environment_ != nullptr || !discs_.empty() || area_lights > 0;
    if (strategy_ != Strategy::light && anything_with_size)
        add_sampled_surface(at, points.point(index, kSurfaceStream));
    for (const LocalLight* const light : without_size_) add_without_size(at, *light);
}

void DirectLight::weigh_layers(const SurfaceHit& hit, Workspace& workspace) const {
    const std::size_t layers = hit.side.layers.size();
    workspace.weights.assign(layers, glm::vec3(1));
    workspace.shares.assign(layers, 1);
    const SpatialVariation* const variation = hit.side.material->variation();
    if (variation == nullptr) return;
    variation->weights(hit.point, workspace.weights);
    double sum = 0;
    for (std::size_t l = 0; l < layers; ++l) {
        const glm::vec3& weight = workspace.weights[l];
        workspace.shares[l] =
            static_cast<double>(std::abs(weight.x) + std::abs(weight.y) + std::abs(weight.z));
        sum += workspace.shares[l];
    }
    for (double& share : workspace.shares) share = sum > 0 ? share / sum : 1 / static_cast<double>(layers);
}

// Samples a direction. The first coordinate chooses the layer, and its remainder samples the layer.
glm::dvec3 DirectLight::sample(const SurfaceHit& hit, const glm::dvec2& point,
                               const Workspace& workspace) const {
    double x = point.x;
    std::size_t chosen = 0;
    while (chosen + 1 < workspace.shares.size() && x >= workspace.shares[chosen])
        x -= workspace.shares[chosen++];
    // A remainder from rounding may reach a layer that has no share.
    while (chosen > 0 && workspace.shares[chosen] == 0) --chosen;
    const double within = std::min(x / workspace.shares[chosen], 1 - 1e-16);
    return hit.side.layers[chosen].sampler->sample(hit.towards_viewer, {within, point.y});
}

double DirectLight::pdf(const Reflection& at, const glm::dvec3& towards_light, double of_light) const {
    double sum = strategy_ != Strategy::surface ? of_light : 0;
    if (strategy_ != Strategy::light) {
        const std::vector<double>& shares = at.workspace.shares;
        for (std::size_t l = 0; l < shares.size(); ++l)
            if (shares[l] > 0)
                sum += shares[l] * at.hit.side.layers[l].sampler->pdf(at.hit.towards_viewer, towards_light);
    }
    return sum;
}

void DirectLight::add_background(const glm::dvec3& direction, const Frame& received,
                                 std::span<Stokes> sum) const {
    const glm::dvec3 towards_light = glm::normalize(direction * light_to_world_);
    const double angle = angle_between(light_to_world_ * theta_phi_frame(-towards_light), received);
    for (int c = 0; c < channels_; ++c)
        sum[static_cast<std::size_t>(c)] += rotated(radiance(c, towards_light), angle);
}

void DirectLight::add_emitted(const RayHit& hit, const Frame& received, std::span<Stokes> sum,
                              Workspace& workspace) const {
    if (!surfaces_[hit.surface].emitted(hit, received, workspace.incident)) return;
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += workspace.incident[c];
}

void DirectLight::add_sampled_environment(Reflection& at, const glm::dvec2& point) const {
    const LightSample light = light_sampler_->sample(point);
    const glm::dvec3 towards_light = (light_to_world_ * light.towards_light) * at.hit.frame;
    if (at.lit_from(towards_light) && !hidden(at, towards_light, kSky)) add_environment(at, towards_light);
}

void DirectLight::add_sampled_disc(Reflection& at, const SkyDisc& disc, const glm::dvec2& point) const {
    const glm::dvec3 towards_light = disc.sample(point) * at.hit.frame;
    if (at.lit_from(towards_light) && !hidden(at, towards_light, kSky)) add_disc(at, disc, towards_light);
}

void DirectLight::add_sampled_area_light(Reflection& at, const RayHit& place) const {
    const TracedSurface& area_light = surfaces_[place.surface];
    const glm::dvec3 way = area_light.position(place) - at.hit.position;
    const double distance = glm::length(way);
    const double cosine = std::abs(glm::dot(area_light.geometric_normal(place), way)) / distance;
    if (!(cosine > 0)) return;
    const glm::dvec3 towards_light = way / distance * at.hit.frame;
    if (!at.lit_from(towards_light)) return;
    if (!area_light.emitted(place, at.incident_frame(towards_light), at.workspace.incident)) return;
    // The ray starts off the surface, so it meets the area light's plane earlier by this offset, or by more
    // at a slant.
    const double offset = std::max(at.hit.ray_offset, area_light.ray_offset(place));
    if (hidden(at, towards_light, distance - 2 * offset / cosine)) return;
    add_reflected(at, towards_light, pdf(at, towards_light, area_light_pdf(at, place)));
}

void DirectLight::add_without_size(Reflection& at, const LocalLight& light) const {
    const auto arrival = light_arrival(light, at.hit.position, at.workspace.irradiance);
    if (!arrival) return;
    const glm::dvec3 towards_light = arrival->towards_light * at.hit.frame;
    if (!at.lit_from(towards_light)) return;
    if (hidden(at, towards_light, arrival->distance - 2 * at.hit.ray_offset)) return;
    const Stokes state =
        stokes_in(at.incident_frame(towards_light), light.state, axis_in_world(light.to_world, light.state));
    for (std::size_t c = 0; c < at.sum.size(); ++c)
        at.workspace.incident[c] = at.workspace.irradiance[c] * state;
    add_reflected(at, towards_light, 1, false);
}

void DirectLight::add_sampled_surface(Reflection& at, const glm::dvec2& point) const {
    const glm::dvec3 towards_light = sample(at.hit, point, at.workspace);
    if (!at.lit_from(towards_light)) return;
    const bool beyond_area_lights = area_light_sampler_->samples() > 0;
    if (beyond_area_lights ? add_area_lights(at, towards_light) : hidden(at, towards_light, kSky)) return;
    if (environment_ != nullptr) add_environment(at, towards_light);
    for (const SkyDisc& disc : discs_) add_disc(at, disc, towards_light);
}

void DirectLight::add_environment(Reflection& at, const glm::dvec3& towards_light) const {
    const glm::dvec3 in_light = glm::normalize(at.in_world(towards_light) * light_to_world_);
    const double rotate_in =
        environment_->polarized()
            ? angle_between(light_to_world_ * theta_phi_frame(-in_light), at.incident_frame(towards_light))
            : 0;
    for (int c = 0; c < channels_; ++c)
        at.workspace.incident[static_cast<std::size_t>(c)] = rotated(radiance(c, in_light), rotate_in);
    const double of_light =
        light_sampler_->pdf(glm::normalize(at.hit.frame * towards_light * light_to_world_));
    add_reflected(at, towards_light, pdf(at, towards_light, of_light));
}

void DirectLight::add_disc(Reflection& at, const SkyDisc& disc, const glm::dvec3& towards_light) const {
    const double of_light = disc.pdf(at.in_world(towards_light));
    if (of_light == 0) return;
    const LocalLight& light = disc.light();
    const Stokes state =
        stokes_in(at.incident_frame(towards_light), light.state, axis_in_world(light.to_world, light.state));
    for (int c = 0; c < channels_; ++c)
        at.workspace.incident[static_cast<std::size_t>(c)] = disc.radiance(c) * state;
    add_reflected(at, towards_light, pdf(at, towards_light, of_light));
}

// Adds the reflection of emissive surfaces. With shadows, only the first surface of all counts. Returns
// whether a surface hides the light beyond.
bool DirectLight::add_area_lights(Reflection& at, const glm::dvec3& towards_light) const {
    if (shadows_) ++at.workspace.shadow_rays;
    Ray ray = at.ray(towards_light);
    while (const std::optional<RayHit> found = rays_->intersect(ray)) {
        const TracedSurface& area_light = surfaces_[found->surface];
        if (area_light.emitted(*found, at.incident_frame(towards_light), at.workspace.incident))
            add_reflected(at, towards_light, pdf(at, towards_light, area_light_pdf(at, *found)));
        if (shadows_) return true;
        ray.nearest = found->distance + area_light.ray_offset(*found);
    }
    return false;
}

bool DirectLight::hidden(Reflection& at, const glm::dvec3& towards_light, double distance) const {
    if (!shadows_) return false;
    ++at.workspace.shadow_rays;
    Ray ray = at.ray(towards_light);
    ray.farthest = std::max(0.0, distance);
    return rays_->occluded(ray);
}

// Returns the density, per steradian, of the area lights' samples at a place.
double DirectLight::area_light_pdf(const Reflection& at, const RayHit& place) const {
    const TracedSurface& area_light = surfaces_[place.surface];
    const glm::dvec3 way = area_light.position(place) - at.hit.position;
    const double distance = glm::length(way);
    return area_light_sampler_->density(place.surface) * distance * distance * distance /
           std::abs(glm::dot(area_light.geometric_normal(place), way));
}

void DirectLight::add_reflected(Reflection& at, const glm::dvec3& towards_light, double pdf,
                                bool sized) const {
    if (!(pdf > 0)) return;
    const SurfaceHit& hit = at.hit;
    Workspace& workspace = at.workspace;
    const double rotate_out = angle_between(hit.frame * theta_phi_frame(hit.towards_viewer), at.received);
    const double factor = at.dimming(towards_light) * towards_light.z / pdf;
    for (std::size_t l = 0; l < hit.side.layers.size(); ++l) {
        if (workspace.shares[l] == 0) continue;
        const Material& material = *hit.side.layers[l].material;
        const int terms = material.terms();
        workspace.terms.resize(static_cast<std::size_t>(terms));
        material.evaluate_terms(towards_light, hit.towards_viewer, workspace.terms);
        for (int c = 0; c < channels_; ++c) {
            const auto channel = static_cast<std::size_t>(c);
            Stokes reflected(0.0);
            for (int t = 0; t < terms; ++t) {
                if (!sized && material.smooth(t)) continue;
                const double weight = material.weight(t, material.channels() == 1 ? 0 : c);
                reflected +=
                    weight * (workspace.terms[static_cast<std::size_t>(t)] * workspace.incident[channel]);
            }
            // Colour textures require three channels. With other numbers of channels all three weights are
            // equal.
            const double weight = workspace.weights[l][channels_ == 3 ? c : 0];
            at.sum[channel] += rotated(weight * factor * reflected, rotate_out);
        }
    }
}

Stokes DirectLight::radiance(int channel, const glm::dvec3& towards_light) const {
    return light_scale_ * environment_->radiance(environment_->channels() == 1 ? 0 : channel, towards_light);
}

}  // namespace nicol
