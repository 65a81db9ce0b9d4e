// SPDX-License-Identifier: MIT
// The orders of light above order_low on the device.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "render/compute/device_light.hpp"
#include "render/high_orders.hpp"
#include "render/vertex_buffers.hpp"
#include "transfer/viewpoint.hpp"

namespace nicol {

/// Holds the maps, factors and visibility of a HighOrderTransfer. All members inside run().
class DeviceHighOrders {
public:
    explicit DeviceHighOrders(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Adds to the Stokes vectors of every vertex.
    void shade(const HighOrderTransfer& transfer, const TransferInput& input, const DistantLight& light,
               const Viewpoint& view, VertexBuffers& buffers);

private:
    using Textures = std::vector<gl::Texture2D>;  // by group of channels
    struct Part {
        Textures factors;
        const Textures* centre;
        const Textures* around;
        const Textures* base;
        float spread;
        bool has_base;
        bool polarized;
        std::vector<gl::Buffer> lobe;  // one where there is visibility
    };

    void mirror(const HighOrderTransfer& transfer, const TransferInput& input);
    const Textures* textures(const LobeMap* map, int channels);
    void mirror_visibility(const HighOrderTransfer& transfer);
    gl::Program& program(int channels, bool polarized, bool shadowed);
    void run(const Part& part, std::size_t first, std::size_t last, const DeviceLight* visibility,
             const TransferInput& input, VertexBuffers& buffers, const DistantLight& light,
             const Viewpoint& view);

    std::shared_ptr<gl::Context> context_;
    std::map<std::tuple<int, bool, bool>, gl::Program> programs_;
    std::map<const LobeMap*, Textures> maps_;
    std::map<MaterialPtr, Part> parts_;
    std::uint64_t parts_revision_ = 0;
    std::vector<DeviceLight> visibility_;  // coefficients instead of light
    std::uint64_t visibility_count_ = 0;
    int visibility_order_ = -1;
};

}  // namespace nicol
