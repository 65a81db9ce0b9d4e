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

/// relight, second half: light times the shadow matrices of its vertices. All members inside run().
class DeviceShadowMatrices {
public:
    /// The same matrices as the host's; `shadows` has some.
    DeviceShadowMatrices(const std::shared_ptr<gl::Context>& context, const VisibilityProduct& shadows);

    /// light = V light for its vertices that are not in unoccluded blocks.
    void run(DeviceLight& light);

private:
    std::shared_ptr<gl::Context> context_;
    gl::Program multiply_;
    gl::Program store_;
    DeviceShadowCoefficients numbers_;
    gl::Buffer rows_;
    std::optional<gl::Buffer> product_;
};

/// Holds copies of what a FactoredMethod made and the light of its vertices. All members inside run().
class DeviceFactored {
public:
    explicit DeviceFactored(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// relight of all vertices.
    void relight(const FactoredMethod& method, const TransferInput& input, Progress& progress,
                 VertexBuffers& buffers);
    void shade(const FactoredMethod& method, const TransferInput& input, DeviceShade& shade,
               const DevicePoints& vertices);

    /// Copies what shading at pixels needs. Returns the most points that it takes at once.
    std::size_t prepare_pixels(const FactoredMethod& method, const PixelInput& input);
    /// The light of a run's points.
    void light_pixels(const PixelInput& input, const PixelRun& run, DevicePixels& pixels);
    /// What a material, one that is the same everywhere, reflects of it.
    void shade_pixels(const MaterialPtr& material, const PixelInput& input, const PixelRun& run,
                      DevicePixels& pixels, DeviceShade& shade, const DevicePoints& points);

private:
    void copy_tables(const FactoredMethod& method, const TransferInput& input);
    void copy_shadows(const FactoredMethod& method);
    void allocate_light(const TransferInput& input);
    void set_light(const TransferInput& input);
    [[nodiscard]] std::size_t most_points(const TransferInput& input) const;

    std::shared_ptr<gl::Context> context_;
    Stage<Version> copying_tables_;
    std::map<MaterialPtr, DeviceTable> tables_;
    std::optional<DeviceRotation> rotation_;
    Stage<Version> copying_shadows_;
    std::optional<DeviceShadowMatrices> shadow_matrices_;  // of shadows, one form or the other
    std::optional<DeviceShadowGrid> shadow_grid_;
    std::vector<DeviceLight> light_;
};

}  // namespace nicol
