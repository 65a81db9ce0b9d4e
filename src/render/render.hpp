// SPDX-License-Identifier: MIT
// Options of a render, and what it reports.
#pragma once

#include <cstdint>
#include <functional>
#include <tuple>

namespace nicol {

/// Highest order a render accepts.
inline constexpr int kMaxRenderOrder = 32;
/// For RenderOptions::split_lights.
inline constexpr int kSplitAutomatic = -1;
inline constexpr int kMaxSplitLights = 64;
inline constexpr int kMaxLightSamples = 1024;

/// How light becomes reflected light.
enum class Method {
    factored,   ///< light in each vertex's frame times response tables
    dense,      ///< a transfer matrix a vertex, as the paper has it: the baseline of comparisons
    reference,  ///< rays, without harmonics: what errors are measured against
};

/// How orders of light above order_low become reflected light: filtered beforehand, looked up at the mirrored
/// view direction.
enum class HighOrders {
    split,        ///< lobes that all materials share, times 4 x 4 factors of the outgoing zenith angle
    convolution,  ///< a kernel a material, as the paper has it (Eq. 68, supplement E.6)
    none,         ///< left out
};

/// Where light becomes a Stokes vector.
enum class ShadeAt {
    automatic,  ///< pixels where interpolation is predicted to miss the tolerance, pixels cost less, there
                ///< are small lights, or a material varies over a surface
    vertices,   ///< Stokes vectors are interpolated: the fastest, right where triangles cover few pixels; not
                ///< for materials that vary
    pixels,     ///< incident light and visible fractions of lobes are interpolated; normal, view and material
                ///< are those of the pixel
};

/// Where relight and shade run; the results agree.
enum class Executor {
    automatic,  ///< compute, unless the processor rasterises or the driver cannot
    cpu,        ///< threads
    compute,    ///< compute shaders; for small lights threads beside them
};

/// What a render leaves out where it is not needed; the image stays the same.
enum Skip : std::uint32_t {
    skip_unchanged = 1,         ///< everything, where nothing changed
    skip_light_components = 2,  ///< Stokes components that the light lacks
    skip_channels = 4,          ///< colour channels of light that equal another
    skip_orders = 8,            ///< orders that the light lacks
    skip_response_rows = 16,    ///< Stokes components that a material cannot make
    skip_hidden = 32,           ///< shading vertices that face away or lie outside the view
    skip_unoccluded = 64,       ///< shadows of vertices with nothing above their horizon
    skip_all = 127,
};

/// The reference method uses shadows, aovs, samples, seed and progress alone, and it alone makes
/// aov_variance.
struct RenderOptions {
    Method method = Method::factored;
    Executor executor = Executor::automatic;
    bool shadows = true;         ///< surfaces hide the environment from each other
    int bake_directions = 2048;  ///< that shadows are traced in from every vertex, 256..65536
    /// The bake splits triangles where shadows change faster than the mesh is fine, until interpolation errs
    /// by no more than this part of the unshadowed irradiance. 0 to 1; 0: no triangle is split.
    double refine_tolerance = 0.02;
    /// That splitting may lead to, in all; 0: 65536 or four times as many as there were, whichever is more.
    /// A memory limit lowers it.
    std::uint64_t max_vertices = 0;
    int order_low = 4;   ///< 0..kMaxRenderOrder: light up to here with its full angular detail
    int order_high = 9;  ///< order_low..64: light up to here at all
    HighOrders high_orders = HighOrders::split;  ///< orders order_low + 1 .. order_high
    ShadeAt shade_at = ShadeAt::vertices;        ///< high orders too
    bool high_order_shadows = true;              ///< with shadows: times the visible fraction of the lobe
    /// order_low and order_high are chosen for the tolerance instead, where it is above 0 and the error is
    /// predicted: with Method::factored and HighOrders::split or none.
    bool choose_orders = false;
    /// The largest relative RMSE of s0, s1 and s2 (over the RMS of s0) that the orders left out may be
    /// predicted to cause.
    double tolerance = 0.03;
    /// Against ringing: all components of the light's order l times 1 / (1 + dering (l (l + 1))^2), the
    /// window that trades the least smoothing for the least curvature (Sloan 2017). 0 and up; 0: off. 1e-4 to
    /// 1e-2 are of use.
    double dering = 0;
    /// Moves Stokes vectors into the physical range (Eq. 70): s0 >= 0, no more polarized than s0, where
    /// light is shaded. Where orders are chosen, light that is as weak as what the others are predicted to
    /// cause becomes less polarized, see make_physical().
    bool physical = false;
    /// Lamps of the environment that are taken out of it as small lights, at most; kSplitAutomatic: those
    /// that the orders below would miss. With Method::factored.
    int split_lights = kSplitAutomatic;
    /// Of each small light with a size: places of it that light a point, at most, 1..kMaxLightSamples. All of
    /// them where it is seen 0.2 radians or more from its middle to its edge; else as many fewer, but 4.
    int light_samples = 16;
    /// Stokes components that the image has: 1 (s0), 3 (s0, s1, s2) or 4; the others are 0.
    int components = 4;
    /// Of the real-time methods: samples of a pixel, 1 to kMostDrawnSamples. Surfaces and the environment
    /// behind them are averaged by the number of samples that show them. 4 and 8 are shaded together, as
    /// ShadeAt says; other numbers one by one: the image is the mean of as many, whose camera is jittered.
    int pixel_samples = 1;
    /// AOVs to make beside the image, bits of AovBit (image/aovs.hpp).
    std::uint32_t aovs = 0;
    /// Optimisations to disable, to measure what they save.
    std::uint32_t disabled_optimisations = 0;
    /// Of the reference method: camera rays a pixel, 1 to 2^20. Powers of two are stratified best.
    int samples = 256;
    /// Of the reference method, and of the places of small lights: the same seed gives the same image
    /// whatever the number of threads.
    std::uint64_t seed = 0;
    /// Called about ten times a second on the calling thread with the verb at work and the fraction done;
    /// false stops the render with Error(cancelled).
    std::function<bool(const char* verb, double fraction)> progress;

    /// All but the callback.
    bool operator==(const RenderOptions& o) const {
        const auto values = [](const RenderOptions& a) {
            return std::tie(a.method, a.executor, a.shadows, a.bake_directions, a.refine_tolerance,
                            a.max_vertices, a.order_low, a.order_high, a.high_orders, a.shade_at,
                            a.high_order_shadows, a.choose_orders, a.tolerance, a.dering, a.physical,
                            a.split_lights, a.light_samples, a.components, a.pixel_samples, a.aovs, a.samples,
                            a.seed, a.disabled_optimisations);
        };
        return values(*this) == values(o);
    }
};

/// Milliseconds are 0 for verbs that did not have to run.
struct Statistics {
    int order_low = 0;           ///< of the light that was rendered
    int order = 0;               ///< the highest of it
    double predicted_error = 0;  ///< where orders were chosen
    bool compute = false;        ///< compute shaders made it
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t vertices_added = 0;  ///< of these vertices, by refinement
    double project_ms = 0;
    double bake_ms = 0;
    double relight_ms = 0;
    double shade_ms = 0;
    double draw_ms = 0;
    double observe_ms = 0;
    std::uint64_t vertices_skipped = 0;       ///< of no triangle that faces the camera inside the view
    std::uint64_t vertices_unoccluded = 0;    ///< nothing hides the environment from them
    std::uint64_t vertices_unphysical = 0;    ///< moved into the physical range, times channels; not pixels
    std::uint64_t light_columns_skipped = 0;  ///< Stokes components that the light lacks, times its channels
    std::uint64_t response_rows_skipped =
        0;                              ///< Stokes components that a material cannot make, times channels
    std::uint64_t channels_shared = 0;  ///< colour channels of light that equal another
    std::uint64_t small_lights = 0;     ///< the scene's, each surface that shines as one, and those split off
    std::uint64_t lights_split = 0;     ///< of them, lamps of the environment
    std::uint64_t light_rays = 0;       ///< from shading points to small lights
    double light_ms = 0;                ///< of shade_ms, small lights and their shadows
    std::uint64_t response_bytes = 0;
    std::uint64_t bake_rays = 0;
    double bake_trace_ms = 0;  ///< of bake_ms, the rays alone
    std::uint64_t visibility_bytes = 0;
    std::uint64_t transfer_bytes = 0;
    std::uint64_t buffer_bytes = 0;
    std::uint64_t texture_bytes = 0;
    std::uint64_t camera_rays = 0;  ///< of the reference method
    std::uint64_t shadow_rays = 0;  ///< likewise
    double trace_ms = 0;            ///< likewise
    // What was made again; 0 where all could be kept.
    std::uint64_t lights_projected = 0;  ///< environments to coefficients
    std::uint64_t materials_projected =
        0;  ///< tables, matrices and sets of lobes of materials, also from a cache
    std::uint64_t vertices_traced = 0;  ///< from which the bake traced rays
    std::uint64_t matrices_baked = 0;   ///< dense: of vertices
    std::uint64_t vertices_relit = 0;   ///< into whose frames light was brought
    std::uint64_t vertices_shaded = 0;  ///< whose Stokes vectors were computed
    std::uint64_t pixels_shaded = 0;    ///< likewise

    /// Adds times and counts of what was made of another render of the scene; the rest becomes its.
    void add(const Statistics& other) {
        Statistics sum = other;
        for (double Statistics::*const ms :
             {&Statistics::project_ms, &Statistics::bake_ms, &Statistics::bake_trace_ms,
              &Statistics::relight_ms, &Statistics::shade_ms, &Statistics::light_ms, &Statistics::draw_ms,
              &Statistics::observe_ms})
            sum.*ms += this->*ms;
        for (std::uint64_t Statistics::*const count :
             {&Statistics::bake_rays, &Statistics::light_rays, &Statistics::lights_projected,
              &Statistics::materials_projected, &Statistics::vertices_traced, &Statistics::matrices_baked,
              &Statistics::vertices_relit, &Statistics::vertices_shaded, &Statistics::pixels_shaded})
            sum.*count += this->*count;
        *this = sum;
    }

    /// Sets times and counts of what was made to 0, for a render that could keep all.
    void nothing_ran() {
        project_ms = bake_ms = bake_trace_ms = relight_ms = shade_ms = draw_ms = observe_ms = trace_ms = 0;
        bake_rays = lights_projected = materials_projected = vertices_traced = 0;
        matrices_baked = vertices_relit = vertices_shaded = pixels_shaded = camera_rays = shadow_rays = 0;
    }
};

}  // namespace nicol
