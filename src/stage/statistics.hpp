// SPDX-License-Identifier: MIT
// What a render did, and what its image is made of.
#pragma once

#include <array>
#include <cstdint>

namespace nicol {

/// Times and counts of what a render computed; 0 where all could be kept.
struct RenderWork {
    double project_ms = 0;
    double bake_ms = 0;
    double bake_trace_ms = 0;  ///< of bake_ms, the rays alone
    double relight_ms = 0;
    double shade_ms = 0;
    double light_ms = 0;  ///< of shade_ms, local lights and their shadows
    double draw_ms = 0;
    double observe_ms = 0;
    double trace_ms = 0;                    ///< of the reference method
    std::uint64_t camera_rays = 0;          ///< of the reference method
    std::uint64_t shadow_rays = 0;          ///< of the reference method
    std::uint64_t bake_rays = 0;            ///< from vertices, for the visibility of the environment
    std::uint64_t light_rays = 0;           ///< from shading points to local lights
    std::uint64_t lights_projected = 0;     ///< environments to coefficients
    std::uint64_t materials_projected = 0;  ///< their tables, matrices and sets of lobes, also from a cache
    std::uint64_t vertices_traced = 0;      ///< from which the bake traced rays
    std::uint64_t matrices_baked = 0;       ///< dense: of vertices
    std::uint64_t vertices_relit = 0;       ///< into whose frames light was brought
    std::uint64_t vertices_shaded = 0;      ///< whose Stokes vectors were computed
    std::uint64_t pixels_shaded = 0;        ///< whose Stokes vectors were computed

    RenderWork& operator+=(const RenderWork& other);
    bool operator==(const RenderWork&) const = default;
};

struct Statistics : RenderWork {
    int order_low = 0;           ///< of the light that was rendered
    int order = 0;               ///< the highest of it
    double predicted_error = 0;  ///< where orders were chosen
    bool compute = false;        ///< compute shaders made it
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t vertices_added = 0;       ///< of these vertices, by refinement
    std::uint64_t vertices_skipped = 0;     ///< of no triangle that faces the camera inside the view
    std::uint64_t vertices_unoccluded = 0;  ///< nothing hides the environment from them
    std::uint64_t vertices_unphysical =
        0;  ///< moved into the physically realizable range, times channels; not pixels
    std::uint64_t light_columns_skipped = 0;  ///< Stokes components that the light lacks, times its channels
    std::uint64_t response_rows_skipped = 0;  ///< Stokes components that no material makes, times channels
    std::uint64_t channels_shared = 0;        ///< colour channels of light that equal another
    std::uint64_t local_lights = 0;  ///< the scene's, each emissive surface as one, and those split off
    std::uint64_t lights_split = 0;  ///< of them, extracted lights of the environment
    std::uint64_t response_bytes = 0;
    std::uint64_t visibility_bytes = 0;
    std::uint64_t transfer_bytes = 0;
    std::uint64_t buffer_bytes = 0;
    std::uint64_t texture_bytes = 0;

    /// For a render that could keep all.
    void nothing_ran() { static_cast<RenderWork&>(*this) = {}; }
    /// Adds the work for another render of the scene; the rest becomes that one's.
    void add(const Statistics& other) {
        RenderWork sum = *this;
        sum += other;
        *this = other;
        static_cast<RenderWork&>(*this) = sum;
    }
};

inline RenderWork& RenderWork::operator+=(const RenderWork& other) {
    constexpr std::array times{&RenderWork::project_ms, &RenderWork::bake_ms,    &RenderWork::bake_trace_ms,
                               &RenderWork::relight_ms, &RenderWork::shade_ms,   &RenderWork::light_ms,
                               &RenderWork::draw_ms,    &RenderWork::observe_ms, &RenderWork::trace_ms};
    constexpr std::array counts{
        &RenderWork::camera_rays,     &RenderWork::shadow_rays,      &RenderWork::bake_rays,
        &RenderWork::light_rays,      &RenderWork::lights_projected, &RenderWork::materials_projected,
        &RenderWork::vertices_traced, &RenderWork::matrices_baked,   &RenderWork::vertices_relit,
        &RenderWork::vertices_shaded, &RenderWork::pixels_shaded};
    static_assert(sizeof(RenderWork) == 8 * (times.size() + counts.size()), "every member is added");
    for (const auto time : times) this->*time += other.*time;
    for (const auto count : counts) this->*count += other.*count;
    return *this;
}

}  // namespace nicol
