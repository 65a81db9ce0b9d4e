// SPDX-License-Identifier: MIT
// Where the work of a frame runs: relight, shade and specular.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>

#include "methods/transfer_input.hpp"
#include "polarization/viewpoint.hpp"
#include "stage/statistics.hpp"
#include "stage/workers.hpp"
#include "versioned.hpp"

namespace nicol {

class Background;
class DenseMethod;
class FactoredMethod;
class HighOrderTransfer;
class VisibilityBuffer;
class PixelImage;
class LocalLights;
class VertexBuffers;
struct Projection;

/// What shade and specular start from.
struct ShadeInput : TransferInput {
    const Viewpoint& view;                 ///< in the geometry's axes
    std::span<const std::uint8_t> chosen;  ///< 1 for each vertex to be shaded
    glm::dmat3 light_to_geometry;          ///< rotates the distant light's axes into the geometry's
    float noise;                           ///< of s0: what the orders left out are predicted to cause, or 0
};

/// What shading at pixels starts from; chosen are vertices of triangles in view.
struct PixelInput : ShadeInput {
    const Projection& projection;          ///< of the geometry's axes
    const VisibilityBuffer& hits;          ///< where there are local lights, on the host in any case
    const HighOrderTransfer* high_orders;  ///< null: none
    bool physical;                         ///< Stokes vectors are moved into the physically realizable range
    const LocalLights* local_lights;       ///< null: none
    std::uint32_t seed;                    ///< of samples of local lights
    const Background* background;          ///< what is behind the surfaces; null: nothing, or it is drawn
    double light_scale;                    ///< times the background
};

/// Computes light and Stokes vectors of vertices and keeps them. Its callers decide what is computed and
/// when. All executors give the same results.
class RenderExecutor {
public:
    virtual ~RenderExecutor() = default;

    /// Identifies the object and with it the results it keeps.
    [[nodiscard]] Version version() const noexcept { return version_; }
    /// Whether shade() and specular() leave out vertices that are not chosen.
    [[nodiscard]] virtual bool can_choose() const noexcept = 0;
    /// Whether several samples of a pixel cost less where pixels are shaded than drawing vertices as often.
    [[nodiscard]] virtual bool samples_pixels() const noexcept = 0;
    /// Whether shade_pixels() reads hits on the host; otherwise on the device.
    [[nodiscard]] virtual bool reads_hits_on_host() const noexcept = 0;
    /// Whether shade_pixels() adds the background; otherwise it is drawn around what shade_pixels() leaves.
    [[nodiscard]] virtual bool adds_background() const noexcept = 0;

    /// relight: the light of at least the vertices with current[v] == 0, in their own frames, times their
    /// visibility; for pixels in the geometry's axes. Returns the number of those vertices.
    virtual std::uint64_t relight(const FactoredMethod& method, const TransferInput& input,
                                  std::span<const std::uint8_t> current, RenderRun& run) = 0;
    /// The same after reflection.
    virtual std::uint64_t relight(const DenseMethod& method, const TransferInput& input,
                                  std::span<const std::uint8_t> current, RenderRun& run) = 0;

    /// shade: Stokes vectors in the camera's frame field.
    virtual void shade(const FactoredMethod& method, const ShadeInput& input, RenderRun& run) = 0;
    virtual void shade(const DenseMethod& method, const ShadeInput& input, RenderRun& run) = 0;

    /// specular: adds the high orders to what shade() left.
    virtual void specular(const HighOrderTransfer& high_orders, const ShadeInput& input, RenderRun& run) = 0;

    /// Stokes vectors of the pixels that show a surface, high orders included, from what relight() leaves for
    /// pixels.
    virtual void shade_pixels(const FactoredMethod& method, const PixelInput& input, RenderRun& run) = 0;
    virtual void shade_pixels(const DenseMethod& method, const PixelInput& input, RenderRun& run) = 0;

    /// Moves Stokes vectors into the physically realizable range. Returns how many it moved.
    virtual std::uint64_t make_physical(const ShadeInput& input) = 0;

    /// Adds what the chosen vertices reflect of local lights, and what they emit.
    virtual void illuminate(const LocalLights& lights, const ShadeInput& input, RenderRun& run) = 0;

    /// Waits until all of the above is done.
    virtual void finish() = 0;
    /// Puts Stokes vectors into the buffers that are drawn. Inside run() of the context.
    virtual void store(VertexBuffers& buffers) const = 0;
    /// Puts the Stokes vectors of pixels, and where the background is to be drawn their coverage, into an
    /// image of all channels; components that were not asked for are 0. Inside run() of the context.
    virtual void store(PixelImage& image) const = 0;
    /// Adds the memory it keeps outside the context to the statistics.
    virtual void count(Statistics& statistics) const = 0;

private:
    Version version_ = new_version();
};

}  // namespace nicol
