// SPDX-License-Identifier: MIT
// Alpha masks of surfaces, for draw.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "draw/variation_buffers.hpp"
#include "draw/vertex_buffers.hpp"
#include "gl/program.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Returns the number of 0 to 1 that glsl/alpha_mask.glsl computes for a pixel as if by chance.
[[nodiscard]] inline float chance_at(std::uint32_t column, std::uint32_t row) {
    std::uint32_t hash = column * 0x9E3779B9U ^ row * 0x85EBCA6BU;
    hash = (hash ^ hash >> 16) * 0x7FEB352DU;
    hash = (hash ^ hash >> 15) * 0x846CA68BU;
    return static_cast<float>((hash ^ hash >> 16) >> 8) * 0x1p-24F;
}

/// Alpha masks on the device, as fragment shaders with ALPHA_MASK defined read them (glsl/alpha_mask.glsl).
/// All members must be called inside run() of the context.
class AlphaMasks {
public:
    explicit AlphaMasks(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Copies the opacity of the geometry's materials; repeats only what changes require. `buffers` must
    /// belong to the geometry. Throws Error(unsupported) if there is more than the driver lets a shader
    /// reach.
    void update(const WorldGeometry& geometry, Version geometry_version, Version material_version,
                VertexBuffers& buffers);

    /// Returns a version that changes with the alpha masks.
    [[nodiscard]] Version version() const noexcept { return version_; }
    /// Returns the number of textures in a range's opacity, for the define TEXTURES; 0: the range has no
    /// alpha mask.
    [[nodiscard]] int textures(std::size_t range) const;
    /// Returns the defines of programs that draw with this number of textures.
    [[nodiscard]] static std::vector<gl::Define> defines(int textures);
    /// Binds the alpha mask of a range, which must have one, for a draw of its triangles. sample: number of
    /// the drawn sample of `samples` a pixel.
    void bind(gl::Program& program, std::size_t range, std::size_t sample, std::size_t samples) const;

private:
    std::shared_ptr<gl::Context> context_;
    Stage<Version, Version> copying_;
    Version version_ = 0;
    struct Mask {
        std::shared_ptr<const VariationBuffers> opacity;  // null: the range has no alpha mask
        bool translucent = false;
    };
    std::vector<Mask> masks_;  // by range; empty: no range has an alpha mask
    VertexBuffers* buffers_ = nullptr;
};

}  // namespace nicol
