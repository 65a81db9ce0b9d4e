// SPDX-License-Identifier: MIT
// OpenGL executor: relight, shade and specular as compute shaders. The methods' data are copied to the
// device, and the results stay there. Threads compute local lights.
#pragma once

#include <memory>
#include <optional>

#include "devices/device.hpp"
#include "devices/gl/device_dense.hpp"
#include "devices/gl/device_factored.hpp"
#include "devices/gl/device_high_orders.hpp"
#include "devices/gl/device_pixels.hpp"
#include "devices/gl/device_shade.hpp"
#include "devices/gl/device_textures.hpp"
#include "methods/executor.hpp"

namespace nicol {

extern const Device kGlDevice;

class GlExecutor final : public RenderExecutor {
public:
    /// Puts the Stokes vectors of vertices into `buffers`, which must outlive the object.
    GlExecutor(std::shared_ptr<gl::Context> context, VertexBuffers& buffers);

    [[nodiscard]] bool can_choose() const noexcept override { return false; }
    [[nodiscard]] bool samples_pixels() const noexcept override { return false; }
    [[nodiscard]] bool reads_hits_on_host() const noexcept override { return false; }
    [[nodiscard]] bool adds_background() const noexcept override { return false; }
    [[nodiscard]] bool follows_rays() const noexcept override { return false; }
    std::uint64_t relight(const FactoredMethod& method, const TransferInput& input,
                          std::span<const std::uint8_t> current, RenderRun& run) override;
    std::uint64_t relight(const DenseMethod& method, const TransferInput& input,
                          std::span<const std::uint8_t> current, RenderRun& run) override;
    void shade(const FactoredMethod& method, const ShadeInput& input, RenderRun& run) override;
    void shade(const DenseMethod& method, const ShadeInput& input, RenderRun& run) override;
    void specular(const HighOrderTransfer& high_orders, const ShadeInput& input, RenderRun& run) override;
    void shade_pixels(const FactoredMethod& method, const PixelInput& input, RenderRun& run) override;
    void shade_pixels(const DenseMethod& method, const PixelInput& input, RenderRun& run) override;
    void scale(const ShadeInput& input) override;
    void make_physical(const ShadeInput& input) override;
    void illuminate(const LocalLights& lights, const ShadeInput& input, RenderRun& run) override;
    std::uint64_t finish() override;
    void store(VertexBuffers& /*buffers*/) const override {}
    void store(PixelImage& image) const override { image_.copy_to(image); }
    void count(Statistics& /*statistics*/) const override {}

private:
    /// Makes buffers of the input's size. Returns false if the input has no vertices.
    bool prepare(const TransferInput& input);
    DeviceShade& shade_for(const Viewpoint& view);
    [[nodiscard]] DevicePoints vertices(const ShadeInput& input, bool fractions);
    template <class Method, class Device>
    void shade_pixels_by(const Method& method, Device& device, const PixelInput& input, RenderRun& run);
    /// Multiplies the Stokes vectors of points first <= i < last. first: as in make_physical().
    void scale(const DevicePoints& points, std::size_t first, std::size_t last,
               const ChannelFactors& factors);
    /// Moves the Stokes vectors of points first <= i < last into the physically realizable range. first: a
    /// multiple of gl::kGroupOfVertices. Adds the number of moved vectors to `counter`, which it makes.
    void make_physical(const DevicePoints& points, std::size_t first, std::size_t last, float noise,
                       std::optional<gl::Buffer>& counter);

    /// Adds `more` to the vertices' Stokes vectors of a channel.
    void add(const std::vector<glm::vec4>& more, int channel);

    std::shared_ptr<gl::Context> context_;
    VertexBuffers& buffers_;
    DevicePixelImage image_;
    DeviceTextures textures_;
    std::optional<DeviceShade> shade_;
    DeviceFactored factored_;
    DeviceDense dense_;
    DeviceHighOrders high_orders_;
    std::optional<DevicePixels> pixels_;
    // Number of vectors that make_physical() moved at vertices, ever; it is never cleared, since that would
    // take more calls than to know what it was.
    std::optional<gl::Buffer> moved_;
    std::uint32_t moved_before_ = 0;       // at the last finish()
    bool counted_ = false;                 // whether make_physical() ran since then
    std::optional<gl::Buffer> uncounted_;  // the same at pixels, which nobody asks for
    std::optional<gl::Program> scale_;
    std::optional<gl::Program> physical_;
    std::optional<gl::Program> add_;
};

}  // namespace nicol
