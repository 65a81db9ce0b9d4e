// SPDX-License-Identifier: MIT
// What shadowed vertices see, on the device.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "render/gpu/device_light.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// The 16-bit numbers of a VisibilityProduct, [block][number][lane], in pieces that one binding reaches.
class DeviceShadowNumbers {
public:
    /// `vertices`: of all blocks, ascending; at least one.
    DeviceShadowNumbers(const std::shared_ptr<gl::Context>& context, std::span<const std::uint32_t> vertices,
                        std::span<const std::int16_t> numbers, std::size_t numbers_of_vertex)
        : vertices_(vertices.begin(), vertices.end()),
          vertex_buffer_(context, gl::BufferUse::storage, std::as_bytes(vertices)) {
        const std::size_t of_block = numbers_of_vertex * kLanes;
        const std::size_t blocks = numbers.size() / of_block;
        const std::size_t most = context->limits().storage_bytes / (of_block * sizeof(std::int16_t));
        for (std::size_t first = 0; first < blocks; first += most) {
            const std::size_t last = std::min(blocks, first + most);
            pieces_.push_back(
                {first, last,
                 gl::Buffer(context, gl::BufferUse::storage,
                            std::as_bytes(numbers.subspan(first * of_block, (last - first) * of_block)))});
        }
    }

    /// The scene's numbers of shadowed vertices.
    [[nodiscard]] const gl::Buffer& vertices() const noexcept { return vertex_buffer_; }
    [[nodiscard]] std::size_t count() const noexcept { return vertices_.size(); }

    /// visit(first, last, first_block, numbers) for shadowed vertices first <= s < last, which `light` holds:
    /// at most so many, whose blocks from first_block on `numbers` holds.
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
