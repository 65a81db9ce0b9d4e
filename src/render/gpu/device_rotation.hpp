// SPDX-License-Identifier: MIT
// relight, first half, on the device: distant light rotated into vertices' frames.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gl/program.hpp"
#include "harmonics/light_layout.hpp"
#include "render/gpu/device_light.hpp"
#include "render/vertex_buffers.hpp"

namespace nicol {

class DeviceRotation {
public:
    explicit DeviceRotation(const std::shared_ptr<gl::Context>& context);

    /// `light`: coefficients in the world's axes, of at least the layout's order.
    void set_light(const LightLayout& layout, const PshVector& light);
    /// Fills `out`, which has the layout and the channels.
    void run(const WorldGeometry& geometry, VertexBuffers& buffers, DeviceLight& out);

    /// Floats a vertex of the work space.
    [[nodiscard]] static std::size_t work_space(const LightLayout& layout);

private:
    std::shared_ptr<gl::Context> context_;
    gl::Program azimuth_;
    gl::Program zenith_;
    std::optional<LightLayout> layout_;
    std::optional<gl::Buffer> quarter_rotation_;
    std::optional<gl::Buffer> entries_;
    unsigned entry_count_ = 0;
    std::vector<gl::Buffer> fields_;  // by channel
    std::optional<gl::Buffer> work_;
};

}  // namespace nicol
