// SPDX-License-Identifier: MIT
// Options of a render.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "image/reconstruction_filter.hpp"
#include "scene/path_depth.hpp"

namespace nicol {

/// Highest order that a render accepts.
inline constexpr int kMaxRenderOrder = 32;
/// Value of RenderOptions::split_lights for an automatic choice.
inline constexpr int kSplitAutomatic = -1;
inline constexpr int kMaxSplitLights = 64;
inline constexpr int kMaxLightSamples = 1024;
inline constexpr int kMaxBsdfSamples = 1024;

/// Method that computes reflected light from incident light.
enum class Method {
    factored,   ///< light in each vertex's frame times response tables
    dense,      ///< one transfer matrix per vertex, as in the paper: the baseline of comparisons
    reference,  ///< rays, without harmonics: the reference for errors
};

/// Form of the reflection of light in orders above order_low. The light is filtered in advance and looked up
/// at the mirrored view direction.
enum class HighOrders {
    split,        ///< lobes that all materials share, times 4 x 4 factors of the outgoing zenith angle
    convolution,  ///< one kernel per material, as in the paper (Eq. 68, supplement E.6)
    none,         ///< no light above order_low
};

/// Place where Stokes vectors are computed.
enum class ShadeAt {
    /// Pixels if interpolation is predicted to miss the tolerance, pixels cost less, there are local lights,
    /// or a material is textured; otherwise vertices.
    automatic,
    /// Stokes vectors are interpolated between vertices: fastest, and accurate if triangles cover few pixels;
    /// not for textured materials.
    vertices,
    /// Incident light and visible fractions of lobes are interpolated; normal, view and material are those of
    /// the pixel.
    pixels,
};

/// Processor for relight and shade; the results agree.
enum class Executor {
    automatic,  ///< compute, unless the CPU rasterises or the driver lacks features
    cpu,        ///< threads
    compute,    ///< compute shaders; threads compute local lights
};

/// Work that a render skips if it is not needed; the image stays the same.
enum Skip : std::uint32_t {
    skip_unchanged = 1,         ///< everything, if nothing changed
    skip_light_components = 2,  ///< Stokes components that the light lacks
    skip_channels = 4,          ///< colour channels of light, if all are multiples of one
    skip_orders = 8,            ///< orders that the light lacks
    skip_response_rows = 16,    ///< Stokes components that a material cannot make
    skip_hidden = 32,           ///< shading vertices that face away or lie outside the view
    skip_unoccluded = 64,       ///< shadows of vertices with nothing above their horizon
    skip_rays = 128,            ///< rays of the bake whose result is known without or not needed
    skip_dim_lights = 256,      ///< shadow rays to lights that add less than a hundredth of the tolerance
    skip_all = 511,
};

/// Callback for the progress of a render. Options that differ only in the callback make the same image and
/// are equal.
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

/// Options of a render. The reference method uses only shadows, filter, aovs, samples, max_depth, seed and
/// progress, and only this method makes aov_variance.
struct RenderOptions {
    Method method = Method::factored;
    Executor executor = Executor::automatic;
    bool shadows = true;         ///< whether surfaces hide the environment from each other
    int bake_directions = 2048;  ///< number of directions of shadow rays from every vertex, 256..65536
    /// Largest interpolation error of shadows, as a fraction of the unshadowed irradiance. The bake splits
    /// triangles until their error is no larger. 0 to 1; 0: no triangle is split.
    double refine_tolerance = 0.02;
    /// Largest total number of vertices after splitting; 0: 65536 or four times the number before splitting,
    /// whichever is more. A memory limit lowers the number.
    std::uint64_t max_vertices = 0;
    /// Time of bake and relight in a render, in milliseconds; 0: as long as it takes. Above 0, shadows that
    /// are not done use former visibility (ProgressiveBake), and the next renders go on.
    double bake_budget_ms = 0;
    int order_low = 4;   ///< highest order of light with its full angular detail, 0..kMaxRenderOrder
    int order_high = 9;  ///< highest order of light at all, order_low..64
    HighOrders high_orders = HighOrders::split;  ///< form of the orders order_low + 1 .. order_high
    ShadeAt shade_at = ShadeAt::vertices;        ///< applies to high orders, too
    /// Whether high orders are multiplied by the visible fraction of the lobe, if there are shadows.
    bool high_order_shadows = true;
    /// Whether order_low and order_high are chosen for the tolerance instead. Requires a tolerance above 0
    /// and a predicted error: Method::factored with HighOrders::split or none.
    bool choose_orders = false;
    /// Largest predicted relative RMSE of s0, s1 and s2 (over the RMS of s0) that the omitted orders and
    /// shadows between baked vertices may cause.
    double tolerance = 0.03;
    /// Factor of the tolerance for the choice of orders, 1 or more. A time budget raises the factor in order
    /// to lower the orders; other uses of the tolerance stay.
    double order_slack = 1;
    /// Strength of a window against ringing, the factor 1 / (1 + dering (l (l + 1))^2) of all components of
    /// the light's order l. The window trades the least smoothing for the least curvature (Sloan 2017). 0 and
    /// up; 0: off; 1e-4 to 1e-2 are useful.
    double dering = 0;
    /// Whether shading moves Stokes vectors into the physically realizable range (Eq. 70): s0 >= 0, and no
    /// more polarized than s0. If orders are chosen, light as weak as the predicted error of the omitted
    /// orders becomes less polarized, see make_physical().
    bool physical = false;
    /// Largest number of extracted lights that are taken out of the environment as local lights,
    /// 0..kMaxSplitLights; kSplitAutomatic: those that harmonics would miss. Applies to Method::factored.
    int split_lights = kSplitAutomatic;
    /// Largest number of light samples per lit point for each local light with a size, 1..kMaxLightSamples. A
    /// light with an angular radius of 0.2 radians or more gets all samples; a smaller light gets
    /// proportionally fewer, but at least 4.
    int light_samples = 16;
    /// Largest number of samples, per lit point and lobe, of the environment's reflection by anisotropic and
    /// by narrow lobes, 0..kMaxBsdfSamples; lobes of GGX take up to half as many again. 0: all lobes reflect
    /// harmonics, anisotropic ones as round ones. Applies to Method::factored with HighOrders::split or none.
    int bsdf_samples = 32;
    /// Time of a frame of a real-time method, in milliseconds; 0: as long as it takes. Above 0, frames give
    /// up what TimeBudget says.
    double time_budget_ms = 0;
    /// Stokes components of the image: 1 (s0), 3 (s0, s1, s2) or 4; the others are 0.
    int components = 4;
    /// Samples per pixel of the real-time methods, 1 to kMostDrawnSamples. Surfaces and the environment
    /// behind them are averaged by the number of samples that show them. 4 and 8 samples are shaded together,
    /// as ShadeAt says. Other numbers are shaded one by one: the image is the mean of that many images with a
    /// jittered camera.
    int pixel_samples = 1;
    /// Weights of the samples in the pixels around them, of all methods; AOVs of surfaces are not filtered.
    /// With any filter but the box, the real-time methods shade all numbers of samples one by one.
    ReconstructionFilter filter;
    /// AOVs to make beside the image, bits of AovBit (image/aovs.hpp).
    std::uint32_t aovs = 0;
    /// Optimisations to disable (bits of Skip), in order to measure what they save.
    std::uint32_t disabled_optimisations = 0;
    /// Camera rays per pixel of the reference method, 1 to 2^20. Powers of two are stratified best.
    int samples = 256;
    /// Largest depth of paths of light (scene/path_depth.hpp), 1..kUnlimitedDepth. The dense method computes
    /// direct light only; bounced light of Method::factored has kBounceOrder, under local lights alone
    /// kLocalBounceOrder, and needs shadows.
    int max_depth = kDirectLightDepth;
    /// Seed of the reference method and of light samples. Equal seeds give equal images for any number of
    /// threads.
    std::uint64_t seed = 0;
    /// Callback, called about ten times a second on the calling thread with the current verb and the fraction
    /// done. If it returns false, the render stops with Error(cancelled).
    ProgressCallback progress;

    bool operator==(const RenderOptions&) const = default;
};

}  // namespace nicol
