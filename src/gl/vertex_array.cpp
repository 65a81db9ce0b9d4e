// SPDX-License-Identifier: MIT
// Attribute bindings, checked against the sizes of their buffers.
#include "gl/vertex_array.hpp"

#include <set>
#include <string>

#include "error.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

[[noreturn]] void refuse(unsigned location, const std::string& text) {
    throw Error(ErrorCode::invalid_argument,
                "VertexArray: attribute " + std::to_string(location) + ": " + text);
}

/// Returns the number of vertices that the buffer holds for this attribute.
std::size_t vertex_count(const Attribute& attribute, std::size_t stride) {
    const std::size_t bytes = static_cast<std::size_t>(attribute.components) * sizeof(float);
    const std::size_t size = attribute.buffer->size();
    if (attribute.offset > size || bytes > size - attribute.offset) return 0;
    return (size - attribute.offset - bytes) / stride + 1;
}

}  // namespace

VertexArray::VertexArray(std::shared_ptr<Context> context, std::span<const Attribute> attributes,
                         std::shared_ptr<const IndexBuffer> indices)
    : object_(std::move(context), ObjectKind::vertex_array), indices_(std::move(indices)) {
    const GladGLContext& gl = functions(*this->context(), "VertexArray");
    const Limits& limits = this->context()->limits();
    if (!indices_ || indices_->buffer().context() != this->context())
        throw Error(ErrorCode::invalid_argument,
                    "VertexArray: the index buffer is missing or of another context");
    std::set<unsigned> used;
    for (const Attribute& attribute : attributes) {
        const unsigned location = attribute.location;
        if (location >= static_cast<unsigned>(limits.vertex_attributes))
            refuse(location, "not below the limit of " + std::to_string(limits.vertex_attributes));
        if (!used.insert(location).second) refuse(location, "given twice");
        if (attribute.components < 1 || attribute.components > 4)
            refuse(location, std::to_string(attribute.components) + " components are not 1 to 4");
        if (!attribute.buffer || attribute.buffer->context() != this->context())
            refuse(location, "its buffer is missing or of another context");
        const std::size_t bytes = static_cast<std::size_t>(attribute.components) * sizeof(float);
        const std::size_t stride = attribute.stride == 0 ? bytes : attribute.stride;
        if (attribute.offset % sizeof(float) != 0 || stride % sizeof(float) != 0 ||
            stride > limits.vertex_stride)
            refuse(location, "offset " + std::to_string(attribute.offset) + " and stride " +
                                 std::to_string(stride) +
                                 " must be multiples of 4 bytes, the stride at most " +
                                 std::to_string(limits.vertex_stride));
        const std::size_t count = vertex_count(attribute, stride);
        if (indices_->largest() >= count)
            refuse(location, "its buffer holds " + std::to_string(count) +
                                 " vertices, but the largest index is " +
                                 std::to_string(indices_->largest()));
        gl.VertexArrayVertexBuffer(id(), location, attribute.buffer->id(),
                                   static_cast<GLintptr>(attribute.offset), static_cast<GLsizei>(stride));
        gl.VertexArrayAttribFormat(id(), location, attribute.components, GL_FLOAT, GL_FALSE, 0);
        gl.VertexArrayAttribBinding(id(), location, location);
        gl.EnableVertexArrayAttrib(id(), location);
        buffers_.push_back(attribute.buffer);
    }
    gl.VertexArrayElementBuffer(id(), indices_->buffer().id());
    this->context()->state().check("VertexArray");
}

}  // namespace nicol::gl
