// SPDX-License-Identifier: MIT
// The factored method on the device.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "render/factored_method.hpp"
#include "render/gpu/device_rotation.hpp"
#include "render/gpu/device_shade.hpp"
#include "render/gpu/device_shadow_grid.hpp"
#include "render/gpu/device_shadow_matrices.hpp"

namespace nicol {

/// Holds what a FactoredMethod prepared and the light of its vertices. All members inside run().
class DeviceFactored {
public:
    explicit DeviceFactored(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// relight, as far as changes make it necessary.
    void relight(const FactoredMethod& method, const TransferInput& input, Progress& progress,
                 Statistics& statistics, VertexBuffers& buffers);
    void shade(const TransferInput& input, DeviceShade& shade, VertexBuffers& buffers);

private:
    void mirror_tables(const FactoredMethod& method, const TransferInput& input);
    void mirror_shadows(const FactoredMethod& method, const TransferInput& input);
    void allocate_light(const TransferInput& input);

    std::shared_ptr<gl::Context> context_;
    std::map<MaterialPtr, DeviceTable> tables_;
    std::uint64_t tables_revision_ = 0;
    std::optional<DeviceRotation> rotation_;
    std::optional<DeviceShadowMatrices> shadow_matrices_;  // of shadows, one form or the other
    std::optional<DeviceShadowGrid> shadow_grid_;
    RelightKey shadows_for_;  // light not counted
    std::vector<DeviceLight> light_;
    RelightKey lit_for_;
};

}  // namespace nicol
