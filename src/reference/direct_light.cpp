// SPDX-License-Identifier: MIT
#include "reference/direct_light.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace nicol {

struct DirectLight::Hit {
    const Surface& surface;
    glm::dvec3 position;
    glm::dvec3 geometric_normal;
    Frame frame;                ///< z = the shading normal, of a two-sided material on the viewer's side
    glm::dvec3 towards_viewer;  ///< in that frame
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
        const SurfaceSampler& sampler = samplers_.try_emplace(&material, material).first->second;
        surfaces_.push_back({placed(*instance.mesh, instance.to_world, ids_[i]), &material, &sampler});
        triangles.push_back({surfaces_.back().mesh.positions, surfaces_.back().mesh.triangles});
        triangles_ += surfaces_.back().mesh.triangles.size();
    }
    rays_ = std::make_unique<RayScene>(triangles);
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

    if (strategy_ != Strategy::surface && !light_sampler_->dark()) {
        const LightSample light = light_sampler_->sample(light_point);
        const glm::dvec3 towards_light = (light_to_world_ * light.towards_light) * hit.frame;
        add_reflected(hit, towards_light, pdf(hit, towards_light), received, sum, workspace);
    }
    if (strategy_ != Strategy::light) {
        const glm::dvec3 towards_light = hit.surface.sampler->sample(hit.towards_viewer, surface_point);
        add_reflected(hit, towards_light, pdf(hit, towards_light), received, sum, workspace);
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
    const Frame frame =
        theta_phi_frame(behind && surface.material->twosided() ? -shading_normal : shading_normal);
    return {.surface = surface,
            .position = positions * weights,
            .geometric_normal = normal,
            .frame = frame,
            .towards_viewer = glm::normalize(towards_viewer * frame)};
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
    if (shadows_) {
        ++workspace.shadow_rays;
        if (rays_->occluded(hit.position, hit.geometric_normal, in_world)) return;
    }

    const Material& material = *hit.surface.material;
    const int terms = material.terms();
    workspace.terms.resize(static_cast<std::size_t>(terms));
    material.evaluate_terms(towards_light, hit.towards_viewer, workspace.terms);
    const glm::dvec3 in_light = glm::normalize(in_world * light_to_world_);
    const double rotate_in = environment_->polarized()
                                 ? angle_between(light_to_world_ * theta_phi_frame(-in_light),
                                                 hit.frame * theta_phi_frame(-towards_light))
                                 : 0;
    const double rotate_out = angle_between(hit.frame * theta_phi_frame(hit.towards_viewer), received);
    for (int c = 0; c < channels_; ++c) {
        const Stokes incident = rotated(radiance(c, in_light), rotate_in);
        Stokes reflected(0.0);
        for (int t = 0; t < terms; ++t) {
            const double weight = material.weight(t, material.channels() == 1 ? 0 : c);
            reflected += weight * (workspace.terms[static_cast<std::size_t>(t)] * incident);
        }
        sum[static_cast<std::size_t>(c)] += rotated(towards_light.z / pdf * reflected, rotate_out);
    }
}

double DirectLight::pdf(const Hit& hit, const glm::dvec3& towards_light) const {
    double sum = 0;
    if (strategy_ != Strategy::surface)
        sum += light_sampler_->pdf(glm::normalize((hit.frame * towards_light) * light_to_world_));
    if (strategy_ != Strategy::light) sum += hit.surface.sampler->pdf(hit.towards_viewer, towards_light);
    return sum;
}

Stokes DirectLight::radiance(int channel, const glm::dvec3& towards_light) const {
    return light_scale_ * environment_->radiance(environment_->channels() == 1 ? 0 : channel, towards_light);
}

}  // namespace nicol
