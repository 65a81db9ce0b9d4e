// SPDX-License-Identifier: MIT
// Options of a render.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

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
                ///< are local lights, or a material varies over a surface
    vertices,   ///< Stokes vectors are interpolated: the fastest, right where triangles cover few pixels; not
                ///< for materials that vary
    pixels,     ///< incident light and visible fractions of lobes are interpolated; normal, view and material
                ///< are those of the pixel
};

/// Where relight and shade run; the results agree.
enum class Executor {
    automatic,  ///< compute, unless the processor rasterises or the driver cannot
    cpu,        ///< threads
    compute,    ///< compute shaders; for local lights threads beside them
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

/// Says how far a render is. Options that differ in it alone make the same image and are equal.
class ProgressCallback {
public:
    using Function = std::function<bool(const char* verb, double fraction)>;

    ProgressCallback() = default;
    // NOLINTBEGIN(google-explicit-constructor): it stands for the function
    template <class Callback>
    ProgressCallback(Callback callback) : function_(std::move(callback)) {}
    operator const Function&() const { return function_; }
    // NOLINTEND(google-explicit-constructor)
    bool operator==(const ProgressCallback&) const { return true; }

private:
    Function function_;
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
    /// Moves Stokes vectors into the physically realizable range (Eq. 70): s0 >= 0, no more polarized than
    /// s0, where light is shaded. Where orders are chosen, light that is as weak as what the others are
    /// predicted to cause becomes less polarized, see make_physical().
    bool physical = false;
    /// Extracted lights of the environment that are taken out of it as local lights, at most;
    /// kSplitAutomatic: those that the orders below would miss. With Method::factored.
    int split_lights = kSplitAutomatic;
    /// Of each local light with a size: places of it that light a point, at most, 1..kMaxLightSamples. All of
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
    /// Of the reference method, and of the samples of local lights: the same seed gives the same image
    /// whatever the number of threads.
    std::uint64_t seed = 0;
    /// Called about ten times a second on the calling thread with the verb at work and the fraction done;
    /// false stops the render with Error(cancelled).
    ProgressCallback progress;

    bool operator==(const RenderOptions&) const = default;
};

}  // namespace nicol
