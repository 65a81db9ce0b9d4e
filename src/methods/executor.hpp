// SPDX-License-Identifier: MIT
// Interface of the executors, which run relight, shade and specular.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>

#include "light/channel_factors.hpp"
#include "methods/transfer_input.hpp"
#include "polarization/viewpoint.hpp"
#include "stage/statistics.hpp"
#include "stage/workers.hpp"
#include "versioned.hpp"

namespace nicol {

class Background;
class Bounces;
class DenseMethod;
class FactoredMethod;
class HighOrderTransfer;
class VisibilityBuffer;
class PixelImage;
class LightPyramid;
class LocalLights;
class SmoothSurfaces;
struct StokesImage;
class VertexBuffers;
struct Projection;

/// Input of shade and specular.
struct ShadeInput : TransferInput {
    const Viewpoint& view;                 ///< viewpoint in the geometry's axes
    std::span<const std::uint8_t> chosen;  ///< 1 for each vertex to be shaded, else 0
    glm::dmat3 light_to_geometry;          ///< rotation from the distant light's axes to the geometry's
    ChannelFactors light_factors;          ///< factors that the distant light's coefficients do not have
    float noise;                           ///< predicted error of s0 from omitted orders, or 0
};

/// Input of shading at pixels. The vertices of all triangles in view must be chosen.
struct PixelInput : ShadeInput {
    const Projection& projection;                    ///< projection of the geometry's axes
    const VisibilityBuffer& hits;                    ///< hits, also on the host if there are local lights
    const HighOrderTransfer* high_orders = nullptr;  ///< null: no high orders
    /// Whether Stokes vectors are moved into the physically realizable range.
    bool physical = false;
    const LocalLights* local_lights = nullptr;  ///< null: no local lights
    std::uint32_t seed = 0;                     ///< seed of light samples
    /// Background behind the surfaces; null: none, or it is drawn.
    const Background* background = nullptr;
    double light_scale = 1;  ///< factor of the background, which light_factors have as well
    /// Surfaces whose pixels show what rays meet; null: none. Only executors that follow_rays() take them.
    const SmoothSurfaces* smooth = nullptr;
    int smooth_events = 0;              ///< largest number of reflections and refractions of a ray
    const LightPyramid* sky = nullptr;  ///< environment that rays meet; null: none
    const Bounces* bounced = nullptr;   ///< bounced light, for sampled terms; null: none
};

/// Executor, which computes and keeps the light and Stokes vectors of vertices. Callers decide what is
/// computed and when. All executors give the same results.
class RenderExecutor {
public:
    virtual ~RenderExecutor() = default;

    /// Returns a version that identifies the object and the results that it keeps.
    [[nodiscard]] Version version() const noexcept { return version_; }
    /// Returns whether shade() and specular() skip vertices that are not chosen.
    [[nodiscard]] virtual bool can_choose() const noexcept = 0;
    /// Returns whether several samples of a pixel cost less by shading pixels than by drawing the vertices
    /// once per sample.
    [[nodiscard]] virtual bool samples_pixels() const noexcept = 0;
    /// Returns whether shade_pixels() reads hits on the host; otherwise it reads them on the device.
    [[nodiscard]] virtual bool reads_hits_on_host() const noexcept = 0;
    /// Returns whether shade_pixels() adds the background; otherwise the background is drawn around the
    /// shaded pixels.
    [[nodiscard]] virtual bool adds_background() const noexcept = 0;

    /// Returns whether shade_pixels() follows rays from smooth surfaces.
    [[nodiscard]] virtual bool follows_rays() const noexcept = 0;

    /// Returns whether relight() keeps the light in the vertices' frames beside that in the geometry's axes.
    /// Otherwise each replaces the other.
    [[nodiscard]] virtual bool keeps_both_lights() const noexcept { return false; }
    /// Frees the light that relight() keeps for pixels, or for vertices.
    virtual void forget_light(bool /*at_pixels*/) {}
    /// Relights at least the vertices with current[v] == 0: computes their light times their visibility, in
    /// their own frames, or in the geometry's axes for pixels. Returns the number of relit vertices.
    virtual std::uint64_t relight(const FactoredMethod& method, const TransferInput& input,
                                  std::span<const std::uint8_t> current, RenderRun& run) = 0;
    /// Moves the light that relight() has kept to other vertices: that of vertex former[v] to v, unless
    /// former[v] is kNoVertex. Returns false if the executor cannot; the kept light is then lost.
    virtual bool renumber(std::span<const std::uint32_t> /*former*/, bool /*at_pixels*/, RenderRun& /*run*/) {
        return false;
    }
    /// Relights at least the vertices with current[v] == 0: computes their light after reflection. Returns
    /// the number of relit vertices.
    virtual std::uint64_t relight(const DenseMethod& method, const TransferInput& input,
                                  std::span<const std::uint8_t> current, RenderRun& run) = 0;

    /// Shades the chosen vertices: computes their Stokes vectors in the camera's frame field.
    virtual void shade(const FactoredMethod& method, const ShadeInput& input, RenderRun& run) = 0;
    virtual void shade(const DenseMethod& method, const ShadeInput& input, RenderRun& run) = 0;

    /// Adds the high orders (specular) to the Stokes vectors of shade().
    virtual void specular(const HighOrderTransfer& high_orders, const ShadeInput& input, RenderRun& run) = 0;

    /// Multiplies the chosen vertices' Stokes vectors by light_factors.
    virtual void scale(const ShadeInput& input) = 0;

    /// Shades the pixels that show a surface: computes their Stokes vectors, high orders and light_factors
    /// included, from the light that relight() computes for pixels.
    virtual void shade_pixels(const FactoredMethod& method, const PixelInput& input, RenderRun& run) = 0;
    virtual void shade_pixels(const DenseMethod& method, const PixelInput& input, RenderRun& run) = 0;

    /// Returns whether interpolate() makes images; otherwise the device draws the vertices that it gets from
    /// store().
    [[nodiscard]] virtual bool interpolates() const noexcept { return false; }
    /// Makes an image of the vertices' Stokes vectors, the background included, as store() of pixels copies
    /// it. The input's hits must be on the host, and the vertices of all triangles in view shaded.
    virtual void interpolate(const PixelInput& /*input*/, RenderRun& /*run*/) {}

    /// Moves Stokes vectors into the physically realizable range.
    virtual void make_physical(const ShadeInput& input) = 0;

    /// Adds the chosen vertices' reflection of local lights and their emission.
    virtual void illuminate(const LocalLights& lights, const ShadeInput& input, RenderRun& run) = 0;

    /// Waits until all computations are done. Returns the number of vectors that make_physical() has moved
    /// since the last call.
    virtual std::uint64_t finish() = 0;
    /// Copies the Stokes vectors of vertices into the buffers that are drawn. Must be called inside run() of
    /// the context.
    virtual void store(VertexBuffers& buffers) const = 0;
    /// Copies the Stokes vectors of pixels into an image of all channels, and their coverage if the
    /// background is to be drawn. Components that were not requested are 0. Must be called inside run() of
    /// the context.
    virtual void store(PixelImage& image) const = 0;
    /// Returns the image in the executor's memory, without components that were not requested and with the
    /// background if adds_background(), which the caller may exchange for another one; null: it is elsewhere.
    [[nodiscard]] virtual StokesImage* image() { return nullptr; }
    /// Adds the memory that the executor keeps outside the context to the statistics.
    virtual void count(Statistics& statistics) const = 0;

private:
    Version version_ = new_version();
};

}  // namespace nicol
