// SPDX-License-Identifier: MIT
// The visibility of shadowed vertices, on the device.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "devices/gl/device_light.hpp"
#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "simd/lanes.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {

/// The numbers() of a VisibilityProduct with at least one block, in pieces that fit into one binding.
class DeviceShadowCoefficients {
public:
    DeviceShadowCoefficients(const std::shared_ptr<gl::Context>& context, const VisibilityProduct& shadows)
        : vertices_(shadows.vertices().begin(), shadows.vertices().end()),
          vertex_buffer_(context, gl::BufferUse::storage, std::as_bytes(shadows.vertices())) {
        const std::size_t of_block = shadows.numbers_of_vertex() * kLanes;
        const std::size_t blocks = shadows.blocks();
        const std::size_t most = context->limits().storage_bytes / (of_block * sizeof(std::int16_t));
        for (std::size_t first = 0; first < blocks; first += most) {
            const std::size_t last = std::min(blocks, first + most);
            std::vector<std::int16_t> numbers;
            numbers.reserve((last - first) * of_block);
            for (std::size_t block = first; block < last; ++block) {
                const std::span of = shadows.numbers(block);
                numbers.insert(numbers.end(), of.begin(), of.end());
            }
            pieces_.push_back(
                {first, last,
                 gl::Buffer(context, gl::BufferUse::storage, std::as_bytes(std::span(numbers)))});
        }
    }

    /// Returns the scene's indices of the shadowed vertices.
    [[nodiscard]] const gl::Buffer& vertices() const noexcept { return vertex_buffer_; }
    [[nodiscard]] std::size_t count() const noexcept { return vertices_.size(); }

    /// Calls visit(first, last, first_block, numbers) for the shadowed vertices first <= s < last that
    /// `light` holds, at most `most` at once. `numbers` holds their blocks, from first_block on.
    template <class Visit>
    void for_chunks(const DeviceLight& light, std::size_t most, const Visit& visit) const {
        for (const Piece& piece : pieces_) {
            const std::size_t end = std::min(rank(light.last()), piece.last_block * kLanes);
            for (std::size_t first = std::max(rank(light.first()), piece.first_block * kLanes); first < end;
                 first += most) {
                visit(first, std::min(end, first + most), piece.first_block, piece.numbers);
            }
        }
    }

private:
    struct Piece {
        std::size_t first_block;
        std::size_t last_block;
        gl::Buffer numbers;
    };

    [[nodiscard]] std::size_t rank(std::size_t vertex) const {
        return static_cast<std::size_t>(std::ranges::lower_bound(vertices_, vertex) - vertices_.begin());
    }

    std::vector<std::uint32_t> vertices_;
    gl::Buffer vertex_buffer_;
    std::vector<Piece> pieces_;
};

}  // namespace nicol
