// SPDX-License-Identifier: MIT
// Binding of buffers to the attributes of a vertex shader, and the triangles over them.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "gl/buffer.hpp"

namespace nicol::gl {

/// One float attribute. Attributes may share a buffer (interleaved) or have one each.
struct Attribute {
    unsigned location = 0;  ///< location in the vertex shader's `layout(location = ...) in`
    int components = 0;     ///< 1 .. 4 floats
    std::shared_ptr<const Buffer> buffer;
    std::size_t offset = 0;  ///< bytes to the first vertex, a multiple of 4
    std::size_t stride = 0;  ///< bytes from vertex to vertex, a multiple of 4; 0: tightly packed
};

/// A vertex array. Keeps its buffers alive. All members must be called inside run().
class VertexArray {
public:
    /// Makes a vertex array. Throws Error(invalid_argument) if an attribute is out of range or used twice, if
    /// an index is beyond the last vertex of any attribute, or if a buffer belongs to another context.
    VertexArray(std::shared_ptr<Context> context, std::span<const Attribute> attributes,
                std::shared_ptr<const IndexBuffer> indices);

    [[nodiscard]] std::size_t index_count() const noexcept { return indices_->count(); }
    [[nodiscard]] unsigned id() const noexcept { return object_.id(); }
    [[nodiscard]] const std::shared_ptr<Context>& context() const noexcept { return object_.context(); }

private:
    Object object_;
    std::vector<std::shared_ptr<const Buffer>> buffers_;
    std::shared_ptr<const IndexBuffer> indices_;
};

}  // namespace nicol::gl
