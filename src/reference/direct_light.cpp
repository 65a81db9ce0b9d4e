// SPDX-License-Identifier: MIT
#include "reference/direct_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "material/spatial_variation.hpp"
#include "shading/normal_variation.hpp"

namespace nicol {
namespace {

template <class Value>
std::array<Value, 3> corners_of(const std::vector<Value>& values, const glm::uvec3& corners) {
    return {values[corners.x], values[corners.y], values[corners.z]};
}

TexturePoint texture_point(const Mesh& mesh, std::uint32_t triangle, const glm::vec3& weights) {
    std::array<glm::vec2, 3> texcoords;
    std::array<glm::vec3, 3> colors;
    if (!mesh.texcoords.empty()) texcoords = corners_of(mesh.texcoords, mesh.texcoord_triangles[triangle]);
    if (!mesh.colors.empty()) colors = corners_of(mesh.colors, mesh.triangles[triangle]);
    return nicol::texture_point(weights, mesh.texcoords.empty() ? nullptr : &texcoords,
                                mesh.colors.empty() ? nullptr : &colors);
}

TextureAxes texture_axes(const Mesh& mesh, std::uint32_t triangle) {
    if (mesh.texcoords.empty()) return {};
    return nicol::texture_axes(corners_of(mesh.positions, mesh.triangles[triangle]),
                               corners_of(mesh.texcoords, mesh.texcoord_triangles[triangle]));
}

}  // namespace

struct DirectLight::Hit {
    const Surface& surface;
    glm::dvec3 position;
    glm::dvec3 geometric_normal;
    glm::dvec3 unturned;        ///< the interpolated normal, on the side of the shading normal
    Frame frame;                ///< z = the shading normal, of a two-sided material on the viewer's side
    glm::dvec3 towards_viewer;  ///< in that frame
    TexturePoint point;
};

DirectLight::DirectLight(const Scene& scene, Strategy strategy, bool shadows)
    : environment_(scene.environment().get()),
      light_to_world_(scene.light_rotation()),
      light_scale_(scene.light_scale()),
      strategy_(strategy),
      shadows_(shadows) {
    if (environment_ != nullptr) {
        check_brightness(environment_->project(0), light_scale_);
        channels_ = environment_->channels();
        light_sampler_ = std::make_unique<LightSampler>(*environment_);
        table_ = environment_->tabulated();
        if (table_) environment_ = table_.get();
    }
    std::vector<RaySurface> triangles;
    surfaces_.reserve(scene.instances().size());
    ids_ = scene.ids();
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        const Instance& instance = scene.instances()[i];
        const Material& material = *instance.material;
        channels_ = std::max(channels_, material.channels());
        Surface& surface = surfaces_.emplace_back(Surface{
            .mesh = placed(*instance.mesh, instance.to_world, ids_[i]), .material = &material, .layers = {}});
        const auto add_layer = [&](const Material& layer) {
            const SurfaceSampler& sampler = samplers_.try_emplace(&layer, layer).first->second;
            surface.layers.push_back({.material = &layer, .sampler = &sampler});
        };
        if (const SpatialVariation* const variation = material.variation()) {
            for (const MaterialLayer& layer : variation->layers) add_layer(*layer.material);
        } else {
            add_layer(material);
        }
        triangles.push_back({.positions = surface.mesh.positions,
                             .triangles = surface.mesh.triangles,
                             .present = presence_of(surface)});
        triangles_ += surfaces_.back().mesh.triangles.size();
    }
    rays_ = std::make_unique<RayScene>(triangles);
}

Presence DirectLight::presence_of(const Surface& surface) const {
    const SpatialVariation* const variation = surface.material->variation();
    if (variation == nullptr || variation->opacity == nullptr) return {};
    return [&mesh = surface.mesh, variation](std::uint32_t triangle, float b1, float b2) {
        return variation->present(texture_point(mesh, triangle, {1 - b1 - b2, b1, b2}));
    };
}

std::optional<DirectLight::Surfel> DirectLight::first_surface(const Ray& ray) const {
    const std::optional<RayHit> found = rays_->intersect(ray);
    if (!found) return std::nullopt;
    const Hit hit = hit_at(*found, -ray.direction);
    return Surfel{.instance = ids_[found->surface], .position = hit.position, .normal = hit.frame[2]};
}

bool DirectLight::add(const Ray& ray, const Frame& received, const glm::dvec2& light_point,
                      const glm::dvec2& surface_point, std::span<Stokes> sum, Workspace& workspace) const {
    const std::optional<RayHit> found = rays_->intersect(ray);
    if (environment_ == nullptr) return found.has_value();
    if (!found) {
        add_background(ray.direction, received, sum);
        return false;
    }
    const Hit hit = hit_at(*found, -ray.direction);
    if (!(hit.towards_viewer.z > 0)) return true;
    weigh_layers(hit, workspace);

    if (strategy_ != Strategy::surface && !light_sampler_->dark()) {
        const LightSample light = light_sampler_->sample(light_point);
        const glm::dvec3 towards_light = (light_to_world_ * light.towards_light) * hit.frame;
        add_reflected(hit, towards_light, pdf(hit, towards_light, workspace), received, sum, workspace);
    }
    if (strategy_ != Strategy::light) {
        const glm::dvec3 towards_light = sample(hit, surface_point, workspace);
        add_reflected(hit, towards_light, pdf(hit, towards_light, workspace), received, sum, workspace);
    }
    return true;
}

DirectLight::Hit DirectLight::hit_at(const RayHit& hit, const glm::dvec3& towards_viewer) const {
    const Surface& surface = surfaces_[hit.surface];
    const glm::uvec3& corners = surface.mesh.triangles[hit.triangle];
    const glm::dvec3 weights(1 - hit.b1 - hit.b2, hit.b1, hit.b2);
    // From the corners rather than along the ray, which is known to single precision only.
    glm::dmat3 positions;
    glm::dvec3 shading_normal(0.0);
    for (int i = 0; i < 3; ++i) {
        positions[i] = surface.mesh.positions[corners[i]];
        shading_normal += weights[i] * glm::dvec3(surface.mesh.normals[corners[i]]);
    }
    const glm::dvec3 normal =
        glm::normalize(glm::cross(positions[1] - positions[0], positions[2] - positions[0]));
    const double length = glm::length(shading_normal);
    if (length > 0) {
        shading_normal /= length;
    } else {
        shading_normal = normal;
    }
    const bool behind = glm::dot(shading_normal, towards_viewer) < 0;
    const bool back = behind && surface.material->twosided();
    if (back) shading_normal = -shading_normal;
    Hit out{.surface = surface,
            .position = positions * weights,
            .geometric_normal = normal,
            .unturned = shading_normal,
            .frame = {},
            .towards_viewer = {},
            .point = {}};
    if (const SpatialVariation* const variation = surface.material->variation()) {
        out.point = texture_point(surface.mesh, hit.triangle, glm::vec3(weights));
        if (variation->normal.kind != NormalVariation::Kind::none) {
            const glm::vec3 normal_of_mesh(shading_normal);
            const glm::vec3 turned = turned_normal(
                variation->normal, out.point, texture_axes(surface.mesh, hit.triangle), normal_of_mesh, back);
            shading_normal =
                glm::normalize(glm::dvec3(facing(turned, normal_of_mesh, glm::vec3(towards_viewer))));
        }
    }
    out.frame = theta_phi_frame(shading_normal);
    out.towards_viewer = glm::normalize(towards_viewer * out.frame);
    return out;
}

void DirectLight::weigh_layers(const Hit& hit, Workspace& workspace) const {
    const std::size_t layers = hit.surface.layers.size();
    workspace.weights.assign(layers, glm::vec3(1));
    workspace.shares.assign(layers, 1);
    const SpatialVariation* const variation = hit.surface.material->variation();
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

// The first coordinate chooses the layer, and what is left of it samples.
glm::dvec3 DirectLight::sample(const Hit& hit, const glm::dvec2& point, const Workspace& workspace) const {
    double x = point.x;
    std::size_t chosen = 0;
    while (chosen + 1 < workspace.shares.size() && x >= workspace.shares[chosen])
        x -= workspace.shares[chosen++];
    // What rounding leaves may reach a layer that has no share.
    while (chosen > 0 && workspace.shares[chosen] == 0) --chosen;
    const double within = std::min(x / workspace.shares[chosen], 1 - 1e-16);
    return hit.surface.layers[chosen].sampler->sample(hit.towards_viewer, {within, point.y});
}

void DirectLight::add_background(const glm::dvec3& direction, const Frame& received,
                                 std::span<Stokes> sum) const {
    const glm::dvec3 towards_light = glm::normalize(direction * light_to_world_);
    const double angle = angle_between(light_to_world_ * theta_phi_frame(-towards_light), received);
    for (int c = 0; c < channels_; ++c)
        sum[static_cast<std::size_t>(c)] += rotated(radiance(c, towards_light), angle);
}

void DirectLight::add_reflected(const Hit& hit, const glm::dvec3& towards_light, double pdf,
                                const Frame& received, std::span<Stokes> sum, Workspace& workspace) const {
    if (!(towards_light.z > 0) || !(pdf > 0)) return;
    const glm::dvec3 in_world = glm::normalize(hit.frame * towards_light);
    // A turned normal sees light from below the surface, which hides it.
    if (!(glm::dot(in_world, hit.unturned) > 0)) return;
    if (shadows_) {
        ++workspace.shadow_rays;
        if (rays_->occluded(hit.position, hit.geometric_normal, in_world)) return;
    }

    const glm::dvec3 in_light = glm::normalize(in_world * light_to_world_);
    const double rotate_in = environment_->polarized()
                                 ? angle_between(light_to_world_ * theta_phi_frame(-in_light),
                                                 hit.frame * theta_phi_frame(-towards_light))
                                 : 0;
    const double rotate_out = angle_between(hit.frame * theta_phi_frame(hit.towards_viewer), received);
    for (std::size_t l = 0; l < hit.surface.layers.size(); ++l) {
        if (workspace.shares[l] == 0) continue;
        const Material& material = *hit.surface.layers[l].material;
        const int terms = material.terms();
        workspace.terms.resize(static_cast<std::size_t>(terms));
        material.evaluate_terms(towards_light, hit.towards_viewer, workspace.terms);
        for (int c = 0; c < channels_; ++c) {
            const Stokes incident = rotated(radiance(c, in_light), rotate_in);
            Stokes reflected(0.0);
            for (int t = 0; t < terms; ++t) {
                const double weight = material.weight(t, material.channels() == 1 ? 0 : c);
                reflected += weight * (workspace.terms[static_cast<std::size_t>(t)] * incident);
            }
            // Textures of colours are for three channels; of others all three weights are equal.
            const double weight = workspace.weights[l][channels_ == 3 ? c : 0];
            sum[static_cast<std::size_t>(c)] +=
                rotated(weight * towards_light.z / pdf * reflected, rotate_out);
        }
    }
}

double DirectLight::pdf(const Hit& hit, const glm::dvec3& towards_light, const Workspace& workspace) const {
    double sum = 0;
    if (strategy_ != Strategy::surface)
        sum += light_sampler_->pdf(glm::normalize((hit.frame * towards_light) * light_to_world_));
    if (strategy_ != Strategy::light) {
        for (std::size_t l = 0; l < hit.surface.layers.size(); ++l)
            if (workspace.shares[l] > 0)
                sum += workspace.shares[l] *
                       hit.surface.layers[l].sampler->pdf(hit.towards_viewer, towards_light);
    }
    return sum;
}

Stokes DirectLight::radiance(int channel, const glm::dvec3& towards_light) const {
    return light_scale_ * environment_->radiance(environment_->channels() == 1 ? 0 : channel, towards_light);
}

}  // namespace nicol
