// SPDX-License-Identifier: MIT
// Owner of one OpenGL object's name: made in its context, deleted there from any thread.
#pragma once

#include <cstddef>
#include <memory>

#include "gl/context.hpp"
#include "memory_share.hpp"

struct GladGLContext;

namespace nicol::gl {

enum class ObjectKind { buffer, texture, renderbuffer, framebuffer, vertex_array, program, shader };

/// Deletes an object. Its context must be current.
void delete_object(const GladGLContext& gl, ObjectKind kind, unsigned id) noexcept;

/// Owner of one OpenGL object. Movable, not copyable. A moved-from object is empty and may only be destroyed
/// or assigned to.
class Object {
public:
    /// Makes the object. `detail` is the stage of a shader, or the target of a texture, 0 for a
    /// two-dimensional one, and otherwise unused. Inside run(); throws Error(opengl).
    Object(std::shared_ptr<Context> context, ObjectKind kind, unsigned detail = 0);
    /// Holds an object that is not ours, and never deletes it.
    static Object borrowed(std::shared_ptr<Context> context, ObjectKind kind, unsigned id);
    ~Object();
    Object(Object&& other) noexcept;
    Object& operator=(Object&& other) noexcept;

    [[nodiscard]] unsigned id() const noexcept { return id_; }
    [[nodiscard]] const std::shared_ptr<Context>& context() const noexcept { return context_; }
    /// Counts the object's bytes in the context's memory use until the object is dropped. Call at most once,
    /// before the bytes are allocated. Throws Error(out_of_memory) if the context's monitor refuses.
    void account(MemoryKind kind, std::size_t bytes);

private:
    Object(ObjectKind kind, unsigned id, std::shared_ptr<Context> context);
    void drop() noexcept;

    std::shared_ptr<Context> context_;
    ObjectKind kind_;
    unsigned id_ = 0;
    bool owned_ = true;
    MemoryKind memory_kind_ = MemoryKind::vertex;
    MemoryShare memory_;
};

}  // namespace nicol::gl
