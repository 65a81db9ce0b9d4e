// SPDX-License-Identifier: MIT
// Statistics of a render: its work, and the contents of its image.
#pragma once

#include <array>
#include <cstdint>

namespace nicol {

/// Times and counts of a render's computations; 0 if all results could be kept.
struct RenderWork {
    double project_ms = 0;
    double bake_ms = 0;
    double bake_trace_ms = 0;  ///< part of bake_ms: tracing rays
    double relight_ms = 0;
    double shade_ms = 0;
    double light_ms = 0;   ///< part of shade_ms: local lights and their shadows
    double focus_ms = 0;   ///< part of light_ms: light that smooth surfaces focus
    double bounce_ms = 0;  ///< part of relight_ms: light that surfaces reflect to each other
    double draw_ms = 0;
    double observe_ms = 0;
    double trace_ms = 0;  ///< time of the reference method
    /// Camera rays of the reference method, and those that found the surfaces at pixels; 0: drawn.
    std::uint64_t camera_rays = 0;
    std::uint64_t shadow_rays = 0;        ///< shadow rays of the reference method
    std::uint64_t bake_rays = 0;          ///< rays from vertices, for the visibility of the environment
    std::uint64_t bake_rays_skipped = 0;  ///< rays of baked points whose result was known without
    /// Rays from shading points to local lights, and of light that smooth surfaces focus.
    std::uint64_t light_rays = 0;
    std::uint64_t light_rays_skipped = 0;  ///< rays to lights that add next to nothing
    std::uint64_t smooth_rays = 0;         ///< rays of pixels that show smooth surfaces
    std::uint64_t lights_projected = 0;    ///< environments projected to coefficients
    /// Materials whose tables, matrices and sets of lobes were computed or read from a cache.
    std::uint64_t materials_projected = 0;
    std::uint64_t vertices_traced = 0;  ///< vertices whose visibility the bake found
    std::uint64_t matrices_baked = 0;   ///< matrices of vertices, by the dense method
    std::uint64_t vertices_relit = 0;   ///< vertices into whose frames light was rotated
    std::uint64_t vertices_shaded = 0;  ///< vertices whose Stokes vectors were computed
    std::uint64_t pixels_shaded = 0;    ///< pixels whose Stokes vectors were computed

    RenderWork& operator+=(const RenderWork& other);
    bool operator==(const RenderWork&) const = default;
};

struct Statistics : RenderWork {
    int order_low = 0;               ///< order_low of the rendered light
    int order = 0;                   ///< highest order of the rendered light
    double predicted_error = 0;      ///< predicted error of the chosen orders, of interpolation between
                                     ///< vertices, of light samples and of bounced light
    double order_error = 0;          ///< that of the chosen orders alone
    double interpolation_error = 0;  ///< that of interpolation alone; 0 if pixels were shaded
    double shadow_error = 0;         ///< that of shadows between baked vertices alone
    double bounce_error = 0;         ///< that of bounced light alone
    bool compute = false;            ///< whether compute shaders made the image
    int given_up = 0;                ///< TimeBudget::steps() of the image
    int pixel_samples = 0;           ///< samples per pixel of the real-time methods
    int light_samples = 0;           ///< RenderOptions::light_samples of the image
    int bsdf_samples = 0;            ///< RenderOptions::bsdf_samples of the image
    double order_tolerance = 0;      ///< tolerance for which orders were chosen; 0 if they were not
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t vertices_added = 0;       ///< part of `vertices`: added by refinement
    std::uint64_t vertices_skipped = 0;     ///< vertices of no triangle that faces the camera inside the view
    std::uint64_t vertices_unbaked = 0;     ///< vertices not baked since a change: no image needs them
    std::uint64_t vertices_pending = 0;     ///< vertices whose visibility is not final (bake_budget_ms)
    std::uint64_t vertices_unoccluded = 0;  ///< vertices from which nothing hides the environment
    /// Vertices moved into the physically realizable range, times channels; pixels are not counted.
    std::uint64_t vertices_unphysical = 0;
    std::uint64_t light_columns_skipped = 0;  ///< Stokes components that the light lacks, times its channels
    std::uint64_t response_rows_skipped = 0;  ///< Stokes components that no material makes, times channels
    std::uint64_t channels_shared = 0;        ///< colour channels of light that are multiples of one
    /// Local lights of the scene, each emissive surface counted as one, and extracted lights.
    std::uint64_t local_lights = 0;
    std::uint64_t lights_split = 0;   ///< part of local_lights: extracted lights of the environment
    std::uint64_t bounce_links = 0;   ///< links from vertices to surfaces that bounced light travels
    std::uint64_t bounce_rounds = 0;  ///< bounces that were computed
    double bounced_light = 0;  ///< share of bounced light in the light at vertices, as RMS over vertices
    double bounced_left = 0;   ///< estimated share of the bounces that were left out
    std::uint64_t response_bytes = 0;
    std::uint64_t visibility_bytes = 0;
    std::uint64_t transfer_bytes = 0;
    std::uint64_t buffer_bytes = 0;
    std::uint64_t texture_bytes = 0;

    /// Sets the work to 0, for a render that could keep all results.
    void nothing_ran() { static_cast<RenderWork&>(*this) = {}; }
    /// Adds the work of another render of the scene, and takes over its other values.
    void add(const Statistics& other) {
        RenderWork sum = *this;
        sum += other;
        *this = other;
        static_cast<RenderWork&>(*this) = sum;
    }
};

inline RenderWork& RenderWork::operator+=(const RenderWork& other) {
    constexpr std::array times{&RenderWork::project_ms, &RenderWork::bake_ms,   &RenderWork::bake_trace_ms,
                               &RenderWork::relight_ms, &RenderWork::shade_ms,  &RenderWork::light_ms,
                               &RenderWork::focus_ms,   &RenderWork::bounce_ms, &RenderWork::draw_ms,
                               &RenderWork::observe_ms, &RenderWork::trace_ms};
    constexpr std::array counts{
        &RenderWork::camera_rays,       &RenderWork::shadow_rays,      &RenderWork::bake_rays,
        &RenderWork::bake_rays_skipped, &RenderWork::light_rays,       &RenderWork::light_rays_skipped,
        &RenderWork::smooth_rays,       &RenderWork::lights_projected, &RenderWork::materials_projected,
        &RenderWork::vertices_traced,   &RenderWork::matrices_baked,   &RenderWork::vertices_relit,
        &RenderWork::vertices_shaded,   &RenderWork::pixels_shaded};
    static_assert(sizeof(RenderWork) == 8 * (times.size() + counts.size()), "every member is added");
    for (const auto time : times) this->*time += other.*time;
    for (const auto count : counts) this->*count += other.*count;
    return *this;
}

}  // namespace nicol
