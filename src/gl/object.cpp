// SPDX-License-Identifier: MIT
// Creation and deletion of OpenGL names.
#include "gl/object.hpp"

#include <utility>

#include "error.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

GLuint make(const GladGLContext& gl, ObjectKind kind, unsigned detail) {
    GLuint id = 0;
    switch (kind) {
        case ObjectKind::buffer:
            gl.CreateBuffers(1, &id);
            break;
        case ObjectKind::texture:
            gl.CreateTextures(detail != 0 ? detail : GL_TEXTURE_2D, 1, &id);
            break;
        case ObjectKind::renderbuffer:
            gl.CreateRenderbuffers(1, &id);
            break;
        case ObjectKind::framebuffer:
            gl.CreateFramebuffers(1, &id);
            break;
        case ObjectKind::vertex_array:
            gl.CreateVertexArrays(1, &id);
            break;
        case ObjectKind::program:
            id = gl.CreateProgram();
            break;
        case ObjectKind::shader:
            id = gl.CreateShader(detail);
            break;
    }
    return id;
}

}  // namespace

void delete_object(const GladGLContext& gl, ObjectKind kind, unsigned id) noexcept {
    switch (kind) {
        case ObjectKind::buffer:
            gl.DeleteBuffers(1, &id);
            break;
        case ObjectKind::texture:
            gl.DeleteTextures(1, &id);
            break;
        case ObjectKind::renderbuffer:
            gl.DeleteRenderbuffers(1, &id);
            break;
        case ObjectKind::framebuffer:
            gl.DeleteFramebuffers(1, &id);
            break;
        case ObjectKind::vertex_array:
            gl.DeleteVertexArrays(1, &id);
            break;
        case ObjectKind::program:
            gl.DeleteProgram(id);
            break;
        case ObjectKind::shader:
            gl.DeleteShader(id);
            break;
    }
}

Object::Object(std::shared_ptr<Context> context, ObjectKind kind, unsigned detail)
    : context_(std::move(context)), kind_(kind) {
    if (!context_) throw Error(ErrorCode::invalid_argument, "an OpenGL object needs a context, not null");
    id_ = make(functions(*context_, "making an OpenGL object"), kind_, detail);
    if (id_ == 0) {
        context_->state().check("making an OpenGL object");
        throw Error(ErrorCode::opengl, "the driver made no OpenGL object");
    }
}

Object::Object(ObjectKind kind, unsigned id, std::shared_ptr<Context> context)
    : context_(std::move(context)), kind_(kind), id_(id), owned_(false) {}

Object Object::borrowed(std::shared_ptr<Context> context, ObjectKind kind, unsigned id) {
    return {kind, id, std::move(context)};
}

Object::~Object() {
    drop();
}

Object::Object(Object&& other) noexcept
    : context_(std::move(other.context_)),
      kind_(other.kind_),
      id_(std::exchange(other.id_, 0)),
      owned_(other.owned_),
      memory_kind_(other.memory_kind_),
      memory_(std::move(other.memory_)) {}

Object& Object::operator=(Object&& other) noexcept {
    if (this != &other) {
        drop();
        context_ = std::move(other.context_);
        kind_ = other.kind_;
        id_ = std::exchange(other.id_, 0);
        owned_ = other.owned_;
        memory_kind_ = other.memory_kind_;
        memory_ = std::move(other.memory_);
    }
    return *this;
}

void Object::account(MemoryKind kind, std::size_t bytes) {
    memory_ = MemoryShare(context_->state().memory_monitor, bytes);
    memory_kind_ = kind;
    context_->state().bytes[static_cast<std::size_t>(kind)] += bytes;
}

void Object::drop() noexcept {
    if (id_ == 0) return;
    Context::State& state = context_->state();
    state.bytes[static_cast<std::size_t>(memory_kind_)] -= memory_.bytes();
    if (!owned_) {
        // The owner deletes it.
    } else if (context_->on_thread()) {
        state.remove(kind_, id_);
    } else if (state.host) {
        state.host->remove(state, kind_, id_);
    } else {
        // The worker's thread deletes the object asynchronously, before its next job and before it ends. The
        // thread keeps the state alive.
        try {
            state.worker.post([&state, kind = kind_, id = id_] { state.remove(kind, id); });
        } catch (...) {
            // There is no memory for the job, so the object stays until its context is destroyed.
        }
    }
    memory_.settle(0);
    id_ = 0;
    context_.reset();
}

}  // namespace nicol::gl
