// SPDX-License-Identifier: MIT
// Shading at pixels on the device: surfaces with textured materials.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "devices/gl/device_pixels.hpp"
#include "draw/variation_buffers.hpp"
#include "gl/program.hpp"
#include "versioned.hpp"

namespace nicol {

/// Textures of a scene's materials. All members must be called inside run() of the context.
class DeviceTextures {
public:
    explicit DeviceTextures(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Copies the scene's textures; repeats only what changes require. Throws Error(unsupported) if there are
    /// more than the driver lets a shader reach.
    void prepare(const PixelInput& input, VertexBuffers& buffers);

    /// Finds the layers' weights at the points of a run, whose material must be textured, and perturbs the
    /// points' normals.
    void find(const PixelInput& input, const PixelRun& run, const DevicePixels& pixels);
    /// Returns the points with separate memory for the Stokes vectors of one layer.
    [[nodiscard]] const DevicePoints& layer_points(const DevicePoints& points);
    /// Adds a layer's Stokes vectors to the points' Stokes vectors; the first layer replaces them.
    void add(std::size_t layer, const PixelRun& run, const DevicePoints& points);

private:
    [[nodiscard]] gl::Program& program(int textures);

    std::shared_ptr<gl::Context> context_;
    std::map<int, gl::Program> programs_;  // by number of textures
    std::optional<gl::Program> add_;
    const CornerBuffers* corners_ = nullptr;
    Stage<Version> copying_;  // materials
    std::map<MaterialPtr, VariationBuffers> variations_;
    std::optional<gl::Buffer> weights_;
    std::size_t stride_ = 0;
    std::optional<StokesBuffer> stokes_;
    DevicePoints points_{};
};

}  // namespace nicol
