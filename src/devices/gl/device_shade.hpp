// SPDX-License-Identifier: MIT
// Shading on the device for every method: light dotted with rows of a table.
#pragma once

#include <memory>
#include <vector>

#include "devices/gl/device_light.hpp"
#include "devices/gl/device_points.hpp"
#include "gl/program.hpp"
#include "harmonics/light_layout.hpp"
#include "material/response_table.hpp"
#include "polarization/viewpoint.hpp"

namespace nicol {

/// ResponseTable on the device.
class DeviceTable {
public:
    DeviceTable(const std::shared_ptr<gl::Context>& context, const LightLayout& layout,
                const ResponseTable& table);

private:
    friend class DeviceShade;

    int row_size_;  // size of a row, all pairings
    int pairs_;     // size of one pairing
    int runs_;
    int angles_;
    bool makes_linear_;
    bool makes_circular_;
    gl::Buffer run_buffer_;
    gl::ChannelStorage rows_;
};

class DeviceShade {
public:
    explicit DeviceShade(const std::shared_ptr<gl::Context>& context);

    void set_view(const Viewpoint& view);
    /// Computes the Stokes vectors of points first <= i < last, which `light` must hold, in the camera's
    /// frame field.
    void run(const DeviceTable& table, const DeviceLight& light, std::size_t first, std::size_t last,
             const DevicePoints& points);

private:
    gl::Program program_;
};

}  // namespace nicol
