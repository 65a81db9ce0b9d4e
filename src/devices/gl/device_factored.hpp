// SPDX-License-Identifier: MIT
// The factored method on the device.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "devices/gl/device_light.hpp"
#include "devices/gl/device_pixels.hpp"
#include "devices/gl/device_rotation.hpp"
#include "devices/gl/device_shade.hpp"
#include "devices/gl/device_shadow_coefficients.hpp"
#include "devices/gl/device_shadow_grid.hpp"
#include "gl/program.hpp"
#include "methods/factored_method.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {

/// Shadow matrices for the second half of relight, on the device. All members must be called inside run() of
/// the context.
class DeviceShadowMatrices {
public:
    /// Copies the host's matrices; `shadows` must have some.
    DeviceShadowMatrices(const std::shared_ptr<gl::Context>& context, const VisibilityProduct& shadows);

    /// Multiplies light by its vertices' shadow matrices: light = V light, except in unoccluded blocks.
    void run(DeviceLight& light);

private:
    std::shared_ptr<gl::Context> context_;
    gl::Program multiply_;
    gl::Program store_;
    DeviceShadowCoefficients numbers_;
    gl::Buffer rows_;
    std::optional<gl::Buffer> product_;
};

/// Copies of a FactoredMethod's results, and the light of its vertices. All members must be called inside
/// run() of the context.
class DeviceFactored {
public:
    explicit DeviceFactored(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Relights all vertices.
    void relight(const FactoredMethod& method, const TransferInput& input, Progress& progress,
                 VertexBuffers& buffers);
    void shade(const FactoredMethod& method, const TransferInput& input, DeviceShade& shade,
               const DevicePoints& vertices);

    /// Copies what shading at pixels needs. Returns the largest number of points that it takes at once.
    std::size_t prepare_pixels(const FactoredMethod& method, const PixelInput& input);
    static constexpr DevicePixels::Joins kJoins = DevicePixels::Joins::plain;
    /// Computes the light of a stretch's points.
    void light_pixels(const PixelInput& input, const PixelStretch& stretch, DevicePixels& pixels);
    /// Shades a run's points with a plain material: computes the reflection of the points' light.
    void shade_pixels(const MaterialPtr& material, const PixelRun& run, const DevicePixels& pixels,
                      DeviceShade& shade, const DevicePoints& points);

private:
    void copy_tables(const FactoredMethod& method, const TransferInput& input);
    void copy_shadows(const FactoredMethod& method);
    void allocate_light(const TransferInput& input);
    void set_light(const TransferInput& input);
    void add_bounced(const Bounces& bounces, DeviceLight& light);
    [[nodiscard]] std::size_t most_points(const TransferInput& input) const;

    std::shared_ptr<gl::Context> context_;
    Stage<Version> copying_tables_;
    std::map<MaterialPtr, DeviceTable> tables_;
    std::optional<DeviceRotation> rotation_;
    Stage<Version> copying_shadows_;
    std::optional<DeviceShadowMatrices> shadow_matrices_;  // shadows as matrices, or as the grid below
    std::optional<DeviceShadowGrid> shadow_grid_;
    std::vector<DeviceLight> light_;
    std::optional<gl::Program> add_bounced_;
};

}  // namespace nicol
