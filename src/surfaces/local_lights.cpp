// SPDX-License-Identifier: MIT
#include "surfaces/local_lights.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "shading/extracted_source.hpp"
#include "surfaces/photon_paths.hpp"
#include "surfaces/rigid_motion.hpp"
#include "surfaces/tangents.hpp"
#include "visibility/bake_origins.hpp"

namespace nicol {
namespace {

// Share of the tolerance that lights without shadow rays may add.
constexpr double kNegligible = 0.01;

EmissiveSurface emissive_surface(const Instance& instance, std::uint32_t id, const glm::dmat4& from_world) {
    const glm::dmat4 to_axes = from_world * instance.to_world;
    const Mesh mesh = placed(*instance.mesh, to_axes, id);
    EmissiveSurface out{.emission = *instance.emission,
                        .axis = glm::dmat3(to_axes) * instance.emission->state.axis,
                        .triangles = {},
                        .texcoords = {},
                        .colors = {}};
    for (const glm::uvec3& t : mesh.triangles)
        out.triangles.push_back({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    const Texture* const texture = instance.emission->texture.get();
    if (texture == nullptr) return out;
    if (texture->needs_texcoords())
        for (const glm::uvec3& t : mesh.texcoord_triangles)
            out.texcoords.push_back({mesh.texcoords[t.x], mesh.texcoords[t.y], mesh.texcoords[t.z]});
    if (texture->needs_colors(ColorsOf::vertices))
        for (const glm::uvec3& t : mesh.triangles)
            out.colors.push_back({mesh.colors[t.x], mesh.colors[t.y], mesh.colors[t.z]});
    if (texture->needs_colors(ColorsOf::faces))
        for (const glm::vec3& color : mesh.face_colors) out.colors.push_back({color, color, color});
    return out;
}

}  // namespace

void LocalLights::update(const Scene& scene, const DistantLight& distant, const RefinedSurfaces& surfaces,
                         SurfaceRays& rays, const Followed& followed, const RenderOptions& options,
                         RenderRun& run) {
    materials_.run(surfaces.version(), surfaces.material_version(), distant.sampled, [&] {
        vertex_tangents_ = nicol::vertex_tangents(surfaces.geometry());
        const auto any = [&](const auto& is) {
            return std::ranges::any_of(surfaces.geometry().ranges, [&](const VertexRange& range) {
                return any_term(*range.material, is);
            });
        };
        const SampledTerms sampled = distant.sampled;
        mirrors_ = any([](const Material& material, int term) { return material.smooth(term); });
        finds_ =
            any([=](const Material& material, int term) { return finds_lights(material, term, sampled); });
        apart_ = any([=](const Material& material, int term) {
            return is_sampled(material, term, sampled) && !finds_lights(material, term, sampled);
        });
    });
    const EnvironmentPtr whole = finds_ ? distant.whole : nullptr, rest = apart_ ? distant.rest : nullptr;
    filtering_.run(whole, rest, [&] {
        Filtered& filtered = filtered_.change();
        filtered.whole = whole ? std::make_shared<const LightPyramid>(*whole) : nullptr;
        filtered.rest = rest == whole ? filtered.whole
                        : rest        ? std::make_shared<const LightPyramid>(*rest)
                                      : nullptr;
    });
    const bool sampled = whole != nullptr || rest != nullptr;
    if (sampled) {
        placing_.run(options.bsdf_samples, [&] {
            grids_.change() =
                std::make_shared<const NodeGrids>(static_cast<std::size_t>(options.bsdf_samples));
        });
    }
    const SmoothSurfaces* const smooth = followed.smooth;
    const auto before_mirrors = smooth != nullptr ? smooth->before_mirrors() : nullptr;
    const bool lit = scene.has_local_lights() || !distant.extracted_lights.empty() || sampled;
    const bool shadows = options.shadows && lit;
    const bool all_cast = (options.disabled_optimisations & skip_dim_lights) != 0;
    const double negligible = all_cast ? 0 : kNegligible * options.tolerance;
    tracing_.run(surfaces.version(), shadows, [&] { rays_.change() = shadows ? rays.get() : nullptr; });
    making_.run(
        scene.local_light_version(), scene.emission_version(), scene.geometry_version(), surfaces.to_world(),
        rays_.version(), mirrors_, options.light_samples, grids_.version(), distant.sampled,
        filtered_.version(), distant.extracted_lights, distant.rotation, scene.light_scale(), before_mirrors,
        smooth != nullptr ? smooth->version() : 0, followed.events, negligible, [&] {
            if (!lit && !any()) return;  // the lighting of vertices stays as it is
            LocalLighting::Lights lights = make_lights(scene, distant, surfaces.to_world());
            lights_ = lights.local.size() + lights.extracted.size();
            std::optional<LocalLighting>& lighting = lighting_.change();
            lighting.reset();
            if (!lit || smooth == nullptr) forget_focused();
            if (!lit) return;
            if (sampled)
                lights.environment.emplace(filtered_->whole, filtered_->rest, glm::mat3(distant.rotation),
                                           static_cast<float>(scene.light_scale()), distant.sampled, *grids_);
            lights.before_mirrors = before_mirrors;
            if (smooth != nullptr) focus(scene, distant, surfaces, followed, lights, run);
            lighting.emplace(std::move(lights), rays_->get(), options.light_samples, negligible);
        });
    count(run.statistics);
}

void LocalLights::count(Statistics& statistics) const {
    statistics.local_lights = lights_;
    const auto& [whole, rest] = *filtered_;
    if (whole) statistics.response_bytes += whole->bytes();
    if (rest && rest != whole) statistics.response_bytes += rest->bytes();
    for (const auto& focused : {focused_, focused_extracted_})
        if (focused) statistics.transfer_bytes += focused->bytes();
}

void LocalLights::focus(const Scene& scene, const DistantLight& distant, const RefinedSurfaces& surfaces,
                        const Followed& followed, LocalLighting::Lights& lights, RenderRun& run) {
    const SmoothSurfaces& smooth = *followed.smooth;
    lights.glass = lights.glass_of_environment = smooth.glass();
    if (followed.events == 0 || !smooth.any()) {
        forget_focused();
        return;
    }
    lights.glass = smooth.unbent_glass();
    const Stopwatch watch;
    const PhotonScene photons{.geometry = surfaces.geometry(),
                              .smooth = smooth,
                              .events = followed.events,
                              .channels = static_cast<std::size_t>(scene.channels())};
    focusing_.run(scene.local_light_version(), scene.emission_version(), scene.geometry_version(),
                  surfaces.to_world(), smooth.version(), followed.events,
                  [&] { focused_ = focused_light(photons, lights.local, run); });
    focusing_extracted_.run(distant.extracted_lights, distant.rotation, scene.light_scale(), smooth.version(),
                            followed.events,
                            [&] { focused_extracted_ = focused_light(photons, lights.extracted, run); });
    lights.focused = focused_;
    lights.focused_extracted = focused_extracted_;
    const double milliseconds = watch.milliseconds();
    run.statistics.focus_ms += milliseconds;
    run.statistics.light_ms += milliseconds;
    run.statistics.shade_ms += milliseconds;
}

void LocalLights::forget_focused() {
    focused_.reset();
    focused_extracted_.reset();
    focusing_.reset();
    focusing_extracted_.reset();
}

void LocalLights::find_vertex_origins(const RefinedSurfaces& surfaces) {
    starting_.run(surfaces.version(), rays_.version(), [&] {
        vertex_origins_.clear();
        if (*rays_ == nullptr) return;
        const WorldGeometry& geometry = surfaces.geometry();
        vertex_origins_ = bake_origins(
            {.positions = geometry.positions, .normals = geometry.normals, .triangles = geometry.triangles},
            geometry.normals);
    });
}

LocalLighting::Lights LocalLights::make_lights(const Scene& scene, const DistantLight& distant,
                                               const glm::dmat4& to_world) {
    const glm::dmat4 from_world = inverse_motion(to_world);
    LocalLighting::Lights out;
    axes_.clear();
    const auto add = [&](LightSourcePtr source) {
        if (source) out.local.push_back(std::move(source));
    };
    for (const LocalLight& light : scene.lights()) add(light_source(light, from_world));
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const Instance& instance = scene.instances()[i];
        if (!instance.emission) continue;
        EmissiveSurface surface = emissive_surface(instance, scene.ids()[i], from_world);
        surface.mirrored = mirrors_;
        axes_.emplace(scene.ids()[i], surface.axis);
        add(light_source(surface));
    }
    for (const std::shared_ptr<const ExtractedLight>& extracted_light : distant.extracted_lights)
        out.extracted.push_back(
            std::make_unique<const ExtractedSource>(extracted_light, distant.rotation, scene.light_scale()));
    return out;
}

}  // namespace nicol
