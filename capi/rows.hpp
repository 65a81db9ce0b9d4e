// SPDX-License-Identifier: MIT
// Rows of numbers in the caller's memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "boundary.hpp"

namespace nicol::capi {

class Rows {
public:
    /// Throws Error(invalid_argument) unless byte_size bytes at `pixels` hold `height` rows of `elements`
    /// numbers of `element` bytes. row_stride: bytes from row to row, or 0 for tightly packed rows.
    Rows(void* pixels, std::uint64_t row_stride, std::uint64_t byte_size, std::size_t element,
         std::size_t elements, int height)
        : pixels_(static_cast<std::byte*>(pixels)) {
        require(pixels, "pixels");
        const std::uint64_t row_bytes = elements * element;
        stride_ = row_stride == 0 ? row_bytes : row_stride;
        if (stride_ < row_bytes || stride_ % element != 0 || stride_ > (std::uint64_t{1} << 40)) {
            refuse("row_stride is " + std::to_string(stride_) + "; a row takes " + std::to_string(row_bytes) +
                   " bytes, and strides are multiples of " + std::to_string(element));
        }
        const std::uint64_t needed = stride_ * static_cast<std::uint64_t>(height - 1) + row_bytes;
        if (byte_size < needed) {
            refuse("byte_size is " + std::to_string(byte_size) + "; the plane takes " +
                   std::to_string(needed) + " bytes");
        }
        if (reinterpret_cast<std::uintptr_t>(pixels) % element != 0)
            refuse("pixels must be aligned to " + std::to_string(element) + " bytes");
    }
    [[nodiscard]] std::byte* row(int y) const { return pixels_ + static_cast<std::size_t>(y) * stride_; }

private:
    std::byte* pixels_;
    std::uint64_t stride_ = 0;
};

}  // namespace nicol::capi
