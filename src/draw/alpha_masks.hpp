// SPDX-License-Identifier: MIT
// draw: surfaces that are not there everywhere.
#pragma once

#include <memory>
#include <vector>

#include "draw/variation_buffers.hpp"
#include "draw/vertex_buffers.hpp"
#include "gl/program.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// What fragment shaders with ALPHA_MASK defined read (glsl/alpha_mask.glsl). All members inside run() of the
/// context.
class AlphaMasks {
public:
    explicit AlphaMasks(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Copies what the geometry's materials have of opacity, as far as changes make it necessary; `buffers`
    /// are of it. Throws Error(unsupported) for more than the driver lets a shader reach.
    void update(const WorldGeometry& geometry, Version geometry_version, Version material_version,
                VertexBuffers& buffers);

    /// Changes with what is cut out.
    [[nodiscard]] Version version() const noexcept { return version_; }
    /// Number of textures, for the define TEXTURES, that a range's opacity is made of; 0: it is whole.
    [[nodiscard]] int textures(std::size_t range) const;
    /// Of programs that draw with so many textures.
    [[nodiscard]] static std::vector<gl::Define> defines(int textures);
    /// For a draw of triangles of this range, which is not whole.
    void bind(gl::Program& program, std::size_t range) const;

private:
    std::shared_ptr<gl::Context> context_;
    Stage<Version, Version> copying_;
    Version version_ = 0;
    std::vector<std::shared_ptr<const VariationBuffers>> opacities_;  // by range, or empty
    VertexBuffers* buffers_ = nullptr;
};

}  // namespace nicol
