// SPDX-License-Identifier: MIT
// Save and restore of the host's OpenGL state that this library changes or depends on.
#pragma once

#include <functional>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

#include "gl/state.hpp"

namespace nicol::gl {

/// The host's state during a visit. The first command of a kind calls one of the functions below, which saves
/// the state that such commands change or depend on, and sets that of a fresh context of our own; the
/// destructor restores what was saved. For a host that sets its own state, nothing is saved or restored.
class HostState {
public:
    static constexpr int kTextureUnits = 16;
    static constexpr int kStorageBindings = 16;
    static constexpr int kDrawBuffers = 4;
    static constexpr int kBlendedBuffers = 8;  ///< number that every driver has

    HostState(const Context::State& state, bool restores);
    ~HostState();
    HostState(const HostState&) = delete;
    HostState& operator=(const HostState&) = delete;

    /// Returns whether the destructor restores the host's state.
    [[nodiscard]] bool restores() const noexcept { return restoring_; }

    /// Prepares draws and clears: capabilities (depth, stencil and scissor test, culling, blending, logical
    /// operation, dithering, polygon offset and smoothing, sample masks, primitive restart, rasterizer
    /// discard, clip distances, depth clamp, sRGB writes; of compatibility contexts alpha test and stipple),
    /// the first viewport and depth range, masks, depth function, faces, polygon mode, clip control,
    /// provoking vertex, vertex array and draw framebuffer.
    void prepare_drawing();
    /// Prepares the use of a program: that of the host with its subroutines.
    void prepare_program(bool compute);
    /// Prepares reads of textures, and uploads: pixel storage and buffer; of compatibility contexts pixel
    /// transfer.
    void prepare_reads();
    void prepare_uploads();
    /// Prepares a binding of a 2D texture, of a storage buffer, and of the first image.
    void prepare_texture(GLuint unit);
    void prepare_storage(GLuint binding);
    void prepare_image();

private:
    enum class Kind { drawing, program, reads, uploads, transfer, units, texture, storages, storage, image };

    /// Returns whether commands of the kind are new to this visit.
    [[nodiscard]] bool first(Kind kind, GLuint index = 0) { return prepared_.insert({kind, index}).second; }
    void restore(std::function<void()> command) { restores_.push_back(std::move(command)); }
    /// Sets a state that only this class changes.
    template <class Set>
    void set(GLenum name, GLint fresh, Set set);
    void disable(GLenum capability);
    void save_what_draws_set();
    void set_rasterisation();
    void set_viewport();
    void set_draw_buffer(GLuint index);
    void set_blending(GLuint index);
    void set_pixels(GLenum buffer, GLenum binding, std::initializer_list<GLenum> zeros, GLenum alignment);
    void set_transfer();
    void unbind_storages();
    [[nodiscard]] GLuint name(GLenum binding) const { return static_cast<GLuint>(state_.integer(binding)); }

    const Context::State& state_;
    const GladGLContext& gl_;
    bool restoring_;
    bool computed_ = false;  ///< whether the last program was a compute program
    std::set<std::pair<Kind, GLuint>> prepared_;
    std::set<GLuint> unbound_;  ///< storage bindings that we used and where the host has no buffer
    std::vector<std::function<void()>> restores_;  ///< called in reverse order
};

}  // namespace nicol::gl
