// SPDX-License-Identifier: MIT
// relight, second half, on the device: light times the shadow matrices of its vertices.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/program.hpp"
#include "render/compute/device_light.hpp"
#include "transfer/shadow_product.hpp"

namespace nicol {

class DeviceShadows {
public:
    /// The same matrices as the host's.
    DeviceShadows(const std::shared_ptr<gl::Context>& context, const ShadowProduct::Matrices& matrices);

    /// light = V light for its vertices that do not see all.
    void run(DeviceLight& light);

private:
    // Whole blocks of sixteen vertices that one binding reaches.
    struct Piece {
        std::size_t first_block;
        std::size_t last_block;
        gl::Buffer numbers;
    };

    std::shared_ptr<gl::Context> context_;
    gl::Program multiply_;
    gl::Program join_;
    std::size_t size_;  // of split light
    std::size_t numbers_of_block_;
    std::vector<std::uint32_t> vertices_;
    gl::Buffer vertex_buffer_;
    gl::Buffer split_terms_;
    gl::Buffer join_terms_;
    gl::Buffer rows_;
    std::vector<Piece> pieces_;
    std::optional<gl::Buffer> work_;
};

}  // namespace nicol
