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
    /// The same matrices as the host's.
    DeviceShadowMatrices(const std::shared_ptr<gl::Context>& context,
                         const VisibilityProduct::Matrices& matrices);

    /// light = V light for its vertices that do not see all.
    void run(DeviceLight& light);

private:
    std::shared_ptr<gl::Context> context_;
    gl::Program multiply_;
    gl::Program join_;
    std::size_t size_;  // of split light
    DeviceShadowNumbers numbers_;
    gl::Buffer split_terms_;
    gl::Buffer join_terms_;
    gl::Buffer rows_;
    std::optional<gl::Buffer> work_;
};

}  // namespace nicol
