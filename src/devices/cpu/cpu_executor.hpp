// SPDX-License-Identifier: MIT
// CPU executor: relight, shade and specular on threads.
#pragma once

#include <glm/vec2.hpp>
#include <utility>
#include <vector>

#include "devices/cpu/pixel_shading.hpp"
#include "devices/device.hpp"
#include "image/stokes_image.hpp"
#include "methods/executor.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

extern const Device kCpuDevice;

class CpuExecutor final : public RenderExecutor {
public:
    [[nodiscard]] bool can_choose() const noexcept override { return true; }
    [[nodiscard]] bool samples_pixels() const noexcept override { return true; }
    [[nodiscard]] bool reads_hits_on_host() const noexcept override { return true; }
    [[nodiscard]] bool adds_background() const noexcept override { return true; }
    [[nodiscard]] bool follows_rays() const noexcept override { return true; }
    [[nodiscard]] bool keeps_both_lights() const noexcept override { return true; }
    void forget_light(bool at_pixels) override { light(at_pixels) = {}; }
    std::uint64_t relight(const FactoredMethod& method, const TransferInput& input,
                          std::span<const std::uint8_t> current, RenderRun& run) override;
    bool renumber(std::span<const std::uint32_t> former, bool at_pixels, RenderRun& run) override;
    std::uint64_t relight(const DenseMethod& method, const TransferInput& input,
                          std::span<const std::uint8_t> current, RenderRun& run) override;
    void shade(const FactoredMethod& method, const ShadeInput& input, RenderRun& run) override;
    void shade(const DenseMethod& method, const ShadeInput& input, RenderRun& run) override;
    void specular(const HighOrderTransfer& high_orders, const ShadeInput& input, RenderRun& run) override;
    void shade_pixels(const FactoredMethod& method, const PixelInput& input, RenderRun& run) override;
    void shade_pixels(const DenseMethod& method, const PixelInput& input, RenderRun& run) override;
    [[nodiscard]] bool interpolates() const noexcept override { return true; }
    void interpolate(const PixelInput& input, RenderRun& run) override;
    void scale(const ShadeInput& input) override;
    void make_physical(const ShadeInput& input) override;
    void illuminate(const LocalLights& lights, const ShadeInput& input, RenderRun& run) override;
    std::uint64_t finish() override { return std::exchange(moved_, 0); }
    void store(VertexBuffers& buffers) const override;
    void store(PixelImage& image) const override;
    [[nodiscard]] StokesImage* image() override { return &image_; }
    void count(Statistics& statistics) const override;

    /// Returns the results of the last shade(), specular() and make_physical().
    [[nodiscard]] const VertexStokes& stokes() const noexcept { return stokes_; }

private:
    /// Allocates Stokes vectors; vertices that are not shaded keep their values.
    void resize(const ShadeInput& input);
    void compute_fractions(const HighOrderTransfer& high_orders, const ShadeInput& input, RenderRun& run);
    /// Calls run(begin, end, channels) on threads for the pixels of an image, which it writes.
    template <class Run>
    void make_image(const PixelInput& input, const char* verb, RenderRun& run, const Run& make);
    void run_pixels(const PixelInput& input, std::span<PointSurface> surfaces, RenderRun& run);

    [[nodiscard]] VertexLight& light(bool at_pixels) { return at_pixels ? light_of_pixels_ : light_; }

    // Light for the factored method, in the vertices' frames and as rows in the geometry's axes.
    VertexLight light_, light_of_pixels_;
    std::vector<VertexLight> outgoing_;  // reflected light of the dense method, one per run
    VertexStokes stokes_;
    std::uint64_t moved_ = 0;  // vectors that make_physical() moved since finish()
    StokesImage image_;        // last image that was made on threads
    /// Visible fractions of the lobe about the mirror direction and of the hemisphere, by vertex; empty if
    /// nothing casts shadows.
    std::vector<glm::vec2> fractions_;
};

}  // namespace nicol
