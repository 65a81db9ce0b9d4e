// SPDX-License-Identifier: MIT
// shade at pixels on the device: surfaces whose materials vary.
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

/// All members inside run() of the context.
class DeviceTextures {
public:
    explicit DeviceTextures(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Copies what the scene has of textures, as far as changes make it necessary. Throws Error(unsupported)
    /// for more of it than the driver lets a shader reach.
    void prepare(const PixelInput& input, VertexBuffers& buffers);

    /// For the points of a run, whose material varies: finds the weights of its layers, and turns the points'
    /// normals.
    void find(const PixelInput& input, const PixelRun& run, const DevicePixels& pixels);
    /// The points, with memory of their own for the Stokes vectors of one layer.
    [[nodiscard]] const DevicePoints& layer_points(const DevicePoints& points);
    /// Adds a layer's Stokes vectors to those of the points; the first replaces them.
    void add(std::size_t layer, const PixelRun& run, const DevicePoints& points);

private:
    [[nodiscard]] gl::Program& program(int textures);

    std::shared_ptr<gl::Context> context_;
    std::map<int, gl::Program> programs_;  // by textures
    std::optional<gl::Program> add_;
    const CornerBuffers* corners_ = nullptr;
    Stage<Version> copying_;  // materials
    std::map<MaterialPtr, VariationBuffers> variations_;
    std::optional<gl::Buffer> weights_;
    std::size_t stride_ = 0;
    std::vector<std::optional<gl::Buffer>> stokes_;
    DevicePoints points_{};
};

}  // namespace nicol
