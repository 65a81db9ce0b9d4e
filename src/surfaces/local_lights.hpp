// SPDX-License-Identifier: MIT
// A scene's local lights, for shading.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "light/extracted_light.hpp"
#include "scene/scene.hpp"
#include "shading/local_lighting.hpp"
#include "stage/options.hpp"
#include "stage/workers.hpp"
#include "surfaces/refined_surfaces.hpp"
#include "surfaces/smooth_surfaces.hpp"
#include "surfaces/surface_rays.hpp"
#include "versioned.hpp"

namespace nicol {

/// Local lights, emissive surfaces and the environment of sampled terms, in the axes of the surfaces as
/// drawn, and the ray hierarchy for their shadow rays.
class LocalLights {
public:
    /// The scene's environment.
    struct DistantLight {
        const std::vector<std::shared_ptr<const ExtractedLight>>& extracted_lights;
        const EnvironmentPtr& whole;
        const EnvironmentPtr& rest;  ///< without the extracted lights
        SampledTerms sampled;        ///< terms that reflect samples of the rest
        const glm::dmat3& rotation;  ///< from the environment's axes to the surfaces' axes
    };
    /// Surfaces that rays follow.
    struct Followed {
        const SmoothSurfaces* smooth;  ///< null: none
        /// Largest number of reflections and refractions of light on its way from a local light to another
        /// surface; 0: glass dims the light of local lights, and bends none.
        int events;
    };
    /// Takes over changes of the scene and the surfaces. rays: of the surfaces before their refinement.
    /// Throws Error(cancelled).
    void update(const Scene& scene, const DistantLight& distant, const RefinedSurfaces& surfaces,
                SurfaceRays& rays, const Followed& followed, const RenderOptions& options, RenderRun& run);

    /// Finds the start points of shadow rays beside vertices, if they are to be lit. any() must be true.
    void find_vertex_origins(const RefinedSurfaces& surfaces);

    /// Returns a version that changes whenever the lighting changes.
    [[nodiscard]] Version version() const noexcept { return lighting_.version(); }
    [[nodiscard]] bool any() const { return lighting_->has_value(); }
    /// Returns the lighting. any() must be true.
    [[nodiscard]] const LocalLighting& lighting() const { return **lighting_; }

    /// Returns the start points of shadow rays beside each vertex, as of the last find_vertex_origins().
    [[nodiscard]] std::span<const glm::vec3> vertex_origins() const { return vertex_origins_; }
    /// Returns the direction of growing texture coordinate u at each vertex. Empty: no material is
    /// anisotropic.
    [[nodiscard]] std::span<const glm::vec3> vertex_tangents() const { return vertex_tangents_; }

    /// Returns the axis of the polarization of an instance's emission.
    [[nodiscard]] const glm::dvec3& axis_of(std::uint32_t instance) const { return axes_.at(instance); }

private:
    [[nodiscard]] LocalLighting::Lights make_lights(const Scene& scene, const DistantLight& distant,
                                                    const glm::dmat4& to_world);
    // Finds the light that smooth surfaces send to others.
    void focus(const Scene& scene, const DistantLight& distant, const RefinedSurfaces& surfaces,
               const Followed& followed, LocalLighting::Lights& lights, RenderRun& run);
    // Gives up the light that smooth surfaces send to others.
    void forget_focused();
    // Adds the bytes of what is kept.
    void count(Statistics& statistics) const;

    Stage<Version, bool> tracing_;  // vertices and triangles, whether anything casts shadows
    Versioned<std::shared_ptr<const RayScene>> rays_;
    Stage<Version, Version> starting_;  // vertices and triangles, rays
    std::vector<glm::vec3> vertex_origins_;
    Stage<Version, Version, SampledTerms> materials_;  // vertices and triangles, materials
    std::vector<glm::vec3> vertex_tangents_;
    bool mirrors_ = false;  // whether a material has smooth terms
    bool finds_ = false;    // whether a material has sampled terms that find extracted lights
    bool apart_ = false;    // whether a material has other sampled terms
    Stage<EnvironmentPtr, EnvironmentPtr> filtering_;
    struct Filtered {
        std::shared_ptr<const LightPyramid> whole, rest;  // null: no term needs it
    };
    Versioned<Filtered> filtered_;
    Stage<int> placing_;  // samples of lobes
    Versioned<std::shared_ptr<const NodeGrids>> grids_;
    // Inputs: lights, emission, placements of instances, the axes, smooth surfaces, events.
    Stage<Version, Version, Version, glm::dmat4, Version, int> focusing_;
    // Inputs: extracted lights, their axes and scale, smooth surfaces, events.
    Stage<std::vector<std::shared_ptr<const ExtractedLight>>, glm::dmat3, double, Version, int>
        focusing_extracted_;
    std::shared_ptr<const FocusedLight> focused_, focused_extracted_;  // light of `local`, of `extracted`
    // Inputs: lights, emission, placements of instances, the axes, rays, mirrors, samples of lights, grids
    // of lobes; sampled terms, their light; extracted lights, their axes and scale; rays before mirrors,
    // smooth surfaces, events; share of light that is negligible.
    Stage<Version, Version, Version, glm::dmat4, Version, bool, int, Version, SampledTerms, Version,
          std::vector<std::shared_ptr<const ExtractedLight>>, glm::dmat3, double,
          std::shared_ptr<const RayScene>, Version, int, double>
        making_;
    Versioned<std::optional<LocalLighting>> lighting_;
    std::map<std::uint32_t, glm::dvec3> axes_;  // by id of the emissive instance
    std::uint64_t lights_ = 0;
};

}  // namespace nicol
