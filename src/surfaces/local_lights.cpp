// SPDX-License-Identifier: MIT
#include "surfaces/local_lights.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "shading/extracted_source.hpp"
#include "surfaces/rigid_motion.hpp"
#include "surfaces/tangents.hpp"
#include "visibility/bake_origins.hpp"

namespace nicol {
namespace {

EmissiveSurface emissive_surface(const Instance& instance, std::uint32_t id, const glm::dmat4& from_world) {
    const glm::dmat4 to_axes = from_world * instance.to_world;
    const Mesh mesh = placed(*instance.mesh, to_axes, id);
    EmissiveSurface out{.emission = *instance.emission,
                        .axis = glm::dmat3(to_axes) * instance.emission->state.axis,
                        .triangles = {},
                        .texcoords = {}};
    for (const glm::uvec3& t : mesh.triangles)
        out.triangles.push_back({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    if (instance.emission->texture == nullptr || mesh.texcoords.empty()) return out;
    for (const glm::uvec3& t : mesh.texcoord_triangles)
        out.texcoords.push_back({mesh.texcoords[t.x], mesh.texcoords[t.y], mesh.texcoords[t.z]});
    return out;
}

}  // namespace

void LocalLights::update(const Scene& scene, const ExtractedLights& split, const RefinedSurfaces& surfaces,
                         SurfaceRays& rays, const RenderOptions& options, Statistics& statistics) {
    const bool lit = scene.has_local_lights() || !split.extracted_lights.empty();
    const bool shadows = options.shadows && lit;
    tracing_.run(surfaces.version(), shadows, [&] {
        rays_.change() = shadows ? rays.get() : nullptr;
        vertex_origins_.clear();
        if (!shadows) return;
        const WorldGeometry& geometry = surfaces.geometry();
        vertex_origins_ = bake_origins(
            {.positions = geometry.positions, .normals = geometry.normals, .triangles = geometry.triangles},
            geometry.normals);
    });
    materials_.run(surfaces.version(), surfaces.material_version(), [&] {
        vertex_tangents_ = nicol::vertex_tangents(surfaces.geometry());
        mirrors_ = std::ranges::any_of(surfaces.geometry().ranges, [](const VertexRange& range) {
            return has_terms(*range.material, true);
        });
    });
    making_.run(scene.local_light_version(), scene.emission_version(), scene.geometry_version(),
                surfaces.to_world(), rays_.version(), mirrors_, options.light_samples, split.extracted_lights,
                split.rotation, scene.light_scale(), [&] {
                    if (!lit && !any()) return;  // the lighting of vertices stays as it is
                    std::vector<LightSourcePtr> sources = make_sources(scene, split, surfaces.to_world());
                    lights_ = sources.size();
                    std::optional<LocalLighting>& lighting = lighting_.change();
                    lighting.reset();
                    if (!lit) return;
                    lighting.emplace(std::move(sources), rays_->get(), options.light_samples);
                });
    statistics.local_lights = lights_;
}

std::vector<LightSourcePtr> LocalLights::make_sources(const Scene& scene, const ExtractedLights& split,
                                                      const glm::dmat4& to_world) {
    const glm::dmat4 from_world = inverse_motion(to_world);
    std::vector<LightSourcePtr> sources;
    axes_.clear();
    for (const LocalLight& light : scene.lights()) sources.push_back(light_source(light, from_world));
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const Instance& instance = scene.instances()[i];
        if (!instance.emission) continue;
        EmissiveSurface surface = emissive_surface(instance, scene.ids()[i], from_world);
        surface.mirrored = mirrors_;
        axes_.emplace(scene.ids()[i], surface.axis);
        if (LightSourcePtr source = light_source(surface)) sources.push_back(std::move(source));
    }
    for (const std::shared_ptr<const ExtractedLight>& extracted_light : split.extracted_lights)
        sources.push_back(
            std::make_unique<const ExtractedSource>(extracted_light, split.rotation, scene.light_scale()));
    return sources;
}

}  // namespace nicol
