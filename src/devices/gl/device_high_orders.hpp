// SPDX-License-Identifier: MIT
// The light's orders above order_low, on the device.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "devices/gl/device_light.hpp"
#include "devices/gl/device_points.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "methods/high_orders.hpp"

namespace nicol {

/// Filtered light and the materials' factors as the textures of glsl/high_order.glsl. All members must be
/// called inside run() of the context.
class HighOrderTextures {
public:
    using Textures = std::vector<gl::Texture2D>;  ///< by group of Framebuffer::kGroup channels

    struct Part {
        Textures factors;
        const Textures* central;
        const Textures* outer;
        const Textures* base;
        float spread;
        bool has_base;
    };

    explicit HighOrderTextures(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Copies the channels of an image from the maps and factors; repeats only what changes require.
    void update(const HighOrderTransfer& transfer, int channels);

    /// Returns a material's part as of the last update().
    [[nodiscard]] const Part& part(const MaterialPtr& material) const { return parts_.at(material); }
    /// Returns whether programs need the define HIGH_ORDER_POLARIZED.
    [[nodiscard]] bool polarized() const noexcept { return polarized_; }

    /// Binds a part to texture units 0 to 3 of a program, and sets its uniforms except to_light.
    static void bind(gl::Program& program, const Part& part, std::size_t group);

private:
    void copy(const HighOrderTransfer& transfer, int channels);
    const Textures* textures(const LobeMap* map, int channels);

    std::shared_ptr<gl::Context> context_;
    std::map<const LobeMap*, Textures> maps_;
    std::map<MaterialPtr, Part> parts_;
    Stage<Version, int> copying_;  // parts, channels
    bool polarized_ = false;
};

/// Reflection of high orders, with a copy of a HighOrderTransfer's visibility. All members must be called
/// inside run() of the context.
class DeviceHighOrders {
public:
    explicit DeviceHighOrders(std::shared_ptr<gl::Context> context)
        : context_(context), textures_(std::move(context)) {}

    /// Fills buffers.fractions() if anything casts shadows.
    void compute_fractions(const HighOrderTransfer& transfer, const ShadeInput& input,
                           VertexBuffers& buffers);
    /// Adds the high orders to the Stokes vectors of points first <= i < last, which have one material.
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
    std::vector<DeviceLight> visibility_;  // coefficients of visibility instead of light
    std::map<double, gl::Buffer> lobes_;   // by width
};

}  // namespace nicol
