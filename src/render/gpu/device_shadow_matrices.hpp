// SPDX-License-Identifier: MIT
// relight, second half, on the device: light times the shadow matrices of its vertices.
#pragma once

#include <memory>
#include <optional>

#include "gl/program.hpp"
#include "render/gpu/device_light.hpp"
#include "render/gpu/device_shadow_numbers.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {

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
    DeviceShadowNumbers numbers_;
    gl::Buffer rows_;
    std::optional<gl::Buffer> product_;
};

}  // namespace nicol
