// SPDX-License-Identifier: MIT
// Rotation of light between the geometry's axes and the frames of points, on the device.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "devices/gl/device_light.hpp"
#include "gl/program.hpp"
#include "harmonics/light_layout.hpp"
#include "harmonics/psh.hpp"

namespace nicol {

/// Rotation of the coefficients of LightLayout, as in Relight and FrameRotation. normals: three floats per
/// point, for all points. All lights of points must have the layout.
class DeviceRotation {
public:
    explicit DeviceRotation(const std::shared_ptr<gl::Context>& context);

    /// Sets the layout of the lights below.
    void set_layout(const LightLayout& layout);
    /// Sets the distant light: coefficients in the geometry's axes, of at least the layout's order.
    void set_light(const PshVector& light);

    /// Fills `out`, which must have the distant light's channels, with the distant light in the points'
    /// frames.
    void run(const gl::Buffer& normals, DeviceLight& out);
    /// Makes `light` that of the points in their frames: up to point `own` the distant light, from there on
    /// each point's own, which `light` has in the geometry's axes.
    void into_frames(const gl::Buffer& normals, std::size_t own, DeviceLight& light);
    /// Rotates each point's own light from the point's frame into the geometry's axes.
    void into_world(const gl::Buffer& normals, DeviceLight& light);

    /// Returns the size of the work space, in floats per point.
    [[nodiscard]] static std::size_t work_space(const LightLayout& layout);

private:
    struct Tables {
        LightLayout layout;
        gl::Buffer quarter_rotation;
        gl::Buffer entries;
        unsigned entry_count;
    };
    void rotate(const gl::Buffer& normals, bool back, std::size_t own, DeviceLight& light);

    std::shared_ptr<gl::Context> context_;
    gl::Program azimuth_;
    gl::Program zenith_;
    std::map<LightKind, Tables> tables_;  // tables of one order
    const Tables* current_ = nullptr;
    std::vector<std::vector<float>> numbers_;  // of the distant light, by channel
    std::optional<gl::ChannelStorage> distant_;
    std::optional<gl::Buffer> work_;
};

}  // namespace nicol
