// SPDX-License-Identifier: MIT
// Executor that runs the steps of a picture backwards: from a gradient of the picture to gradients of the
// light that it is linear in.
#pragma once

#include <utility>
#include <vector>

#include "harmonics/psh.hpp"
#include "image/stokes_image.hpp"
#include "methods/executor.hpp"
#include "polarization/stokes.hpp"
#include "shading/light_source.hpp"
#include "texture/texture.hpp"

namespace nicol {

struct GradientSums;

/// A local light of which gradients are wanted.
struct AdjointLight {
    LightSourcePtr source;       ///< unit_sources() of the light
    std::vector<Stokes> stokes;  ///< Stokes vectors that the light has, by channel
};

/// Gradients of a picture's light. A picture P(x) is linear in the light x: the gradient of f(P) by x is the
/// transpose of P times the gradient of f by the picture.
struct LightGradients {
    /// Gradient by the distant light's coefficients up to the order that is shaded, in its own axes, for a
    /// scale of 1.
    PshVector distant;
    /// Gradient by the local lights' Stokes vectors in the frames of unit_sources(),
    /// [light][channel][component].
    std::vector<double> lights;
    /// Gradient by a factor of what a range of the geometry reflects, [range][channel].
    std::vector<double> reflection;
    /// Gradient by the texels of a texture, [row][column][channel]; empty: none is wanted.
    std::vector<double> texels;
};

/// Pipeline::run() with this executor computes the gradients by shading at pixels, on threads. Rows of
/// materials and the products of light and visibility are those that shading takes. The frames' rotations
/// are orthogonal and the products symmetric, so that they are their own transposes. Throws
/// Error(unsupported) for what is not transposed: the dense method, shading at vertices, and light that is
/// not shaded from the vertices' light alone.
class AdjointExecutor final : public RenderExecutor {
public:
    /// picture: the gradient by the pixels' Stokes vectors; must outlive the executor and have the scene's
    /// channels and the size of the hits. lights: all local lights of the scene, which are not dark, or none.
    /// texture: the texture of an image, or null.
    AdjointExecutor(const StokesImage& picture, std::vector<AdjointLight> lights, TexturePtr texture)
        : picture_(picture), lights_(std::move(lights)), texture_(std::move(texture)) {}

    [[nodiscard]] bool can_choose() const noexcept override { return true; }
    [[nodiscard]] bool samples_pixels() const noexcept override { return true; }
    [[nodiscard]] bool reads_hits_on_host() const noexcept override { return true; }
    [[nodiscard]] bool adds_background() const noexcept override { return false; }
    [[nodiscard]] bool follows_rays() const noexcept override { return true; }
    std::uint64_t relight(const FactoredMethod& method, const TransferInput& input,
                          std::span<const std::uint8_t> current, RenderRun& run) override;
    std::uint64_t relight(const DenseMethod& method, const TransferInput& input,
                          std::span<const std::uint8_t> current, RenderRun& run) override;
    void shade(const FactoredMethod& method, const ShadeInput& input, RenderRun& run) override;
    void shade(const DenseMethod& method, const ShadeInput& input, RenderRun& run) override;
    void specular(const HighOrderTransfer& high_orders, const ShadeInput& input, RenderRun& run) override;
    void scale(const ShadeInput& input) override;
    void shade_pixels(const FactoredMethod& method, const PixelInput& input, RenderRun& run) override;
    void shade_pixels(const DenseMethod& method, const PixelInput& input, RenderRun& run) override;
    void make_physical(const ShadeInput& input) override;
    void illuminate(const LocalLights& lights, const ShadeInput& input, RenderRun& run) override;
    std::uint64_t finish() override { return 0; }
    void store(VertexBuffers& /*buffers*/) const override {}
    void store(PixelImage& /*image*/) const override {}
    void count(Statistics& /*statistics*/) const override {}

    /// Returns the gradients of the last shade_pixels(), once.
    [[nodiscard]] LightGradients take_gradients() noexcept { return std::move(gradients_); }

private:
    /// Sets gradients_, in the geometry's axes, from sums over all points.
    void collect(const GradientSums& sums, const PixelInput& input);

    const StokesImage& picture_;
    std::vector<AdjointLight> lights_;
    TexturePtr texture_;
    LightGradients gradients_;
};

}  // namespace nicol
