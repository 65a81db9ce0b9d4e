// SPDX-License-Identifier: MIT
// The orders of light above order_low on the device.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "gl/program.hpp"
#include "render/gpu/device_light.hpp"
#include "render/gpu/device_points.hpp"
#include "render/gpu/high_order_textures.hpp"
#include "render/high_orders.hpp"

namespace nicol {

/// Holds a copy of the visibility of a HighOrderTransfer. All members inside run().
class DeviceHighOrders {
public:
    explicit DeviceHighOrders(std::shared_ptr<gl::Context> context)
        : context_(context), textures_(std::move(context)) {}

    /// Fills buffers.fractions() where anything casts shadows.
    void compute_fractions(const HighOrderTransfer& transfer, const ShadeInput& input,
                           VertexBuffers& buffers);
    /// Adds to the Stokes vectors of points first <= i < last, of one material.
    void add(const HighOrderTransfer& transfer, const MaterialPtr& material, std::size_t first,
             std::size_t last, const ShadeInput& input, const DevicePoints& points);

private:
    void copy_visibility(const HighOrderTransfer& transfer);
    void run(const HighOrderTextures::Part& part, std::size_t first, std::size_t last,
             const ShadeInput& input, const DevicePoints& points);
    gl::Program& program(int channels, bool polarized, bool shadowed);

    std::shared_ptr<gl::Context> context_;
    HighOrderTextures textures_;
    std::map<std::tuple<int, bool, bool>, gl::Program> programs_;
    std::optional<gl::Program> fraction_;
    Stage<Version> copying_;
    std::vector<DeviceLight> visibility_;  // coefficients instead of light
    std::map<double, gl::Buffer> lobes_;   // by width
};

}  // namespace nicol
