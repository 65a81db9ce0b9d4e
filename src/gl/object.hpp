// SPDX-License-Identifier: MIT
// The name of one OpenGL object: made in its context, deleted there from wherever it is dropped.
#pragma once

#include <cstddef>
#include <memory>

#include "gl/context.hpp"

struct GladGLContext;

namespace nicol::gl {

enum class ObjectKind { buffer, texture, renderbuffer, framebuffer, vertex_array, program, shader };

/// With the context current.
void delete_object(const GladGLContext& gl, ObjectKind kind, unsigned id) noexcept;

/// Movable, not copyable. A moved-from object is empty and may only be destroyed or assigned to.
class Object {
public:
    /// `detail` is the stage of a shader and unused otherwise. Inside run(); throws Error(opengl).
    Object(std::shared_ptr<Context> context, ObjectKind kind, unsigned detail = 0);
    ~Object();
    Object(Object&& other) noexcept;
    Object& operator=(Object&& other) noexcept;

    [[nodiscard]] unsigned id() const noexcept { return id_; }
    [[nodiscard]] const std::shared_ptr<Context>& context() const noexcept { return context_; }
    /// Adds the object's bytes to the context's account until it is dropped. At most once.
    void account(MemoryKind kind, std::size_t bytes) noexcept;

private:
    void drop() noexcept;

    std::shared_ptr<Context> context_;
    ObjectKind kind_;
    unsigned id_ = 0;
    MemoryKind memory_kind_ = MemoryKind::vertex;
    std::size_t bytes_ = 0;
};

}  // namespace nicol::gl
