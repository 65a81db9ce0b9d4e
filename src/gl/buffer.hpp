// SPDX-License-Identifier: MIT
// Device memory: vertex attributes, indices, shader storage.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "gl/object.hpp"

namespace nicol::gl {

/// Category in which a buffer's memory is counted. Any buffer may be used for attributes and storage
/// bindings.
enum class BufferUse { vertex, index, storage };
enum class BufferUpdate { fixed, dynamic };  ///< dynamic buffers accept update()

/// A buffer in device memory. All members must be called inside run(). An empty buffer throws
/// Error(invalid_argument), a too large one Error(out_of_memory).
class Buffer {
public:
    /// Makes a buffer with a copy of `data`.
    Buffer(std::shared_ptr<Context> context, BufferUse use, std::span<const std::byte> data,
           BufferUpdate update = BufferUpdate::fixed);
    /// Makes a buffer of `bytes` zero bytes.
    Buffer(std::shared_ptr<Context> context, BufferUse use, std::size_t bytes, BufferUpdate update);

    /// Replaces data.size() bytes from `offset`. Throws Error(invalid_argument) for a range outside the
    /// buffer or a fixed buffer.
    void update(std::size_t offset, std::span<const std::byte> data);
    /// Copies out data.size() bytes from `offset`, after all commands that write them are done.
    void read(std::size_t offset, std::span<std::byte> data) const;
    /// Binds `bytes` from `offset` as shader storage buffer `binding` of later commands. The offset must be a
    /// multiple of Limits::storage_alignment and the range at most Limits::storage_bytes; therefore large
    /// data is bound in chunks.
    void bind_storage(unsigned binding, std::size_t offset, std::size_t bytes) const;
    void bind_storage(unsigned binding) const { bind_storage(binding, 0, size_); }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] unsigned id() const noexcept { return object_.id(); }
    [[nodiscard]] const std::shared_ptr<Context>& context() const noexcept { return object_.context(); }

private:
    void allocate(BufferUse use, const void* data);
    void require_range(const char* what, std::size_t offset, std::size_t bytes) const;

    Object object_;
    std::size_t size_;
    BufferUpdate update_;
};

/// Indices of triangles. Stores the largest index, so that no draw reads beyond its vertices.
class IndexBuffer {
public:
    /// Takes three indices per triangle. Throws Error(invalid_argument) if there are none or their count is
    /// not a multiple of three.
    IndexBuffer(std::shared_ptr<Context> context, std::span<const std::uint32_t> indices);

    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] std::uint32_t largest() const noexcept { return largest_; }
    [[nodiscard]] const Buffer& buffer() const noexcept { return buffer_; }

private:
    Buffer buffer_;
    std::size_t count_;
    std::uint32_t largest_;
};

}  // namespace nicol::gl
