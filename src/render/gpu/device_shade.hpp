// SPDX-License-Identifier: MIT
// shade on the device, for every method: packed light dotted with rows of a table.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gl/program.hpp"
#include "harmonics/light_layout.hpp"
#include "material/response_table.hpp"
#include "polarization/viewpoint.hpp"
#include "render/gpu/device_light.hpp"
#include "render/vertex_buffers.hpp"

namespace nicol {

/// Rows for each zenith angle from 0 to pi/2, as those of a ResponseTable: s0 and s1 are dot products with
/// real parts of the light, s2 and s3 with imaginary ones.
class DeviceTable {
public:
    DeviceTable(const std::shared_ptr<gl::Context>& context, const LightLayout& layout,
                const ResponseTable& table);
    /// The harmonics of an OutgoingShade, [angle][entry].
    DeviceTable(const std::shared_ptr<gl::Context>& context, const LightLayout& layout,
                std::span<const float> harmonics);

private:
    friend class DeviceShade;
    void upload(const std::shared_ptr<gl::Context>& context, std::span<const float> rows);

    LightLayout layout_;
    int angles_;
    bool makes_linear_;
    bool makes_circular_;
    std::vector<gl::Buffer> channels_;  // one, or one each
};

class DeviceShade {
public:
    explicit DeviceShade(const std::shared_ptr<gl::Context>& context);

    void set_view(const Viewpoint& view);
    /// The Stokes vectors of vertices first <= v < last, which `light` holds, in the camera's frame field.
    void run(const DeviceTable& table, const DeviceLight& light, std::size_t first, std::size_t last,
             const WorldGeometry& geometry, int channels, VertexBuffers& buffers);

private:
    gl::Program program_;
};

}  // namespace nicol
