// SPDX-License-Identifier: MIT
// Texture coordinates and colours of triangles' corners, on the device.
#pragma once

#include <memory>
#include <optional>

#include "gl/buffer.hpp"
#include "surfaces/geometry.hpp"
#include "versioned.hpp"

namespace nicol {

/// All members inside run() of the context.
class CornerBuffers {
public:
    explicit CornerBuffers(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Copies a geometry's, as far as changes make it necessary. Throws Error(unsupported) for more triangles
    /// than the driver lets a shader reach.
    void update(const WorldGeometry& geometry, Version geometry_version, Version material_version);

    /// By triangle, numbers() floats: u and v of corners; how a point moves as u, and as v, grows; colours of
    /// corners, where there are any.
    void bind(unsigned binding) const { buffer_->bind_storage(binding); }
    [[nodiscard]] int numbers() const noexcept { return colored_ ? 21 : 12; }
    [[nodiscard]] bool colored() const noexcept { return colored_; }

private:
    std::shared_ptr<gl::Context> context_;
    Stage<Version, Version> copying_;
    bool colored_ = false;
    std::optional<gl::Buffer> buffer_;
};

}  // namespace nicol
