// SPDX-License-Identifier: MIT
// Buffers of immutable size.
#include "gl/buffer.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "error.hpp"
#include "gl/host_state.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

MemoryKind memory_kind(BufferUse use) {
    switch (use) {
        case BufferUse::vertex:
            return MemoryKind::vertex;
        case BufferUse::index:
            return MemoryKind::index;
        case BufferUse::storage:
            break;
    }
    return MemoryKind::storage;
}

std::span<const std::uint32_t> checked(std::span<const std::uint32_t> indices) {
    if (indices.empty() || indices.size() % 3 != 0)
        throw Error(ErrorCode::invalid_argument,
                    "an index buffer needs three indices a triangle, not " + std::to_string(indices.size()));
    return indices;
}

}  // namespace

Buffer::Buffer(std::shared_ptr<Context> context, BufferUse use, std::span<const std::byte> data,
               BufferUpdate update)
    : object_(std::move(context), ObjectKind::buffer), size_(data.size()), update_(update) {
    allocate(use, data.data());
}

Buffer::Buffer(std::shared_ptr<Context> context, BufferUse use, std::size_t bytes, BufferUpdate update)
    : object_(std::move(context), ObjectKind::buffer), size_(bytes), update_(update) {
    allocate(use, nullptr);
}

void Buffer::allocate(BufferUse use, const void* data) {
    if (size_ == 0) throw Error(ErrorCode::invalid_argument, "a buffer needs at least one byte");
    const std::string what = "a buffer of " + std::to_string(size_) + " bytes";
    if (size_ > PTRDIFF_MAX) throw Error(ErrorCode::out_of_memory, what + " is more than can be addressed");
    const GladGLContext& gl = functions(*context(), what);
    const GLbitfield flags = update_ == BufferUpdate::dynamic ? GL_DYNAMIC_STORAGE_BIT : GLbitfield{0};
    object_.account(memory_kind(use), size_);
    gl.NamedBufferStorage(id(), static_cast<GLsizeiptr>(size_), data, flags);
    context()->state().check(what);
    if (data == nullptr) {
        if (HostState* const host = context()->state().host_state) host->prepare_uploads();
        gl.ClearNamedBufferData(id(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
        context()->state().check(what);
    }
}

void Buffer::require_range(const char* what, std::size_t offset, std::size_t bytes) const {
    if (offset > size_ || bytes > size_ - offset)
        throw Error(ErrorCode::invalid_argument, std::string(what) + ": " + std::to_string(bytes) +
                                                     " bytes from " + std::to_string(offset) +
                                                     " do not lie in a buffer of " + std::to_string(size_));
}

void Buffer::update(std::size_t offset, std::span<const std::byte> data) {
    const GladGLContext& gl = functions(*context(), "Buffer::update");
    if (update_ != BufferUpdate::dynamic)
        throw Error(ErrorCode::invalid_argument, "Buffer::update: the buffer was made fixed, not dynamic");
    require_range("Buffer::update", offset, data.size());
    if (data.empty()) return;
    gl.NamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()),
                          data.data());
    context()->state().check_command("Buffer::update");
}

void Buffer::read(std::size_t offset, std::span<std::byte> data) const {
    const GladGLContext& gl = functions(*context(), "Buffer::read");
    require_range("Buffer::read", offset, data.size());
    if (data.empty()) return;
    gl.GetNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()),
                             data.data());
    context()->state().check("Buffer::read");
}

void Buffer::bind_storage(unsigned binding, std::size_t offset, std::size_t bytes) const {
    std::ignore = functions(*context(), "Buffer::bind_storage");
    const Limits& limits = context()->limits();
    require_range("Buffer::bind_storage", offset, bytes);
    const auto refuse = [](const std::string& text) {
        throw Error(ErrorCode::invalid_argument, "Buffer::bind_storage: " + text);
    };
    if (binding >= static_cast<unsigned>(limits.storage_bindings))
        refuse("binding " + std::to_string(binding) + " is not below the limit of " +
               std::to_string(limits.storage_bindings));
    if (bytes == 0 || bytes > limits.storage_bytes)
        refuse(std::to_string(bytes) + " bytes are not between 1 and the limit of " +
               std::to_string(limits.storage_bytes) + "; bind a part of the buffer");
    if (offset % limits.storage_alignment != 0)
        refuse("the offset " + std::to_string(offset) + " is not a multiple of " +
               std::to_string(limits.storage_alignment));
    if (HostState* const host = context()->state().host_state) host->prepare_storage(binding);
    Context::State::want(context()->state().storages, binding,
                         Context::State::StorageRange{.buffer = id(), .offset = offset, .bytes = bytes});
}

IndexBuffer::IndexBuffer(std::shared_ptr<Context> context, std::span<const std::uint32_t> indices)
    : buffer_(std::move(context), BufferUse::index, std::as_bytes(checked(indices))),
      count_(indices.size()),
      largest_(*std::max_element(indices.begin(), indices.end())) {}

}  // namespace nicol::gl
