// SPDX-License-Identifier: MIT
// Texture coordinates and colours of triangles' corners, on the device.
#pragma once

#include <memory>
#include <optional>

#include "gl/buffer.hpp"
#include "surfaces/geometry.hpp"
#include "versioned.hpp"

namespace nicol {

/// Buffer of triangles' corners. All members must be called inside run() of the context.
class CornerBuffers {
public:
    explicit CornerBuffers(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Copies a geometry's corners; repeats only what changes require. Throws Error(unsupported) for more
    /// triangles than the driver lets a shader reach.
    void update(const WorldGeometry& geometry, Version geometry_version, Version material_version);

    /// Binds the buffer, which has numbers() floats per triangle: u and v of the corners; the shifts of a
    /// point as u and as v grows; the tangents of the corners, if with_tangents(); their colours, if
    /// colored().
    void bind(unsigned binding) const { buffer_->bind_storage(binding); }
    [[nodiscard]] int numbers() const noexcept { return 12 + (with_tangents_ ? 12 : 0) + (colored_ ? 9 : 0); }
    [[nodiscard]] bool with_tangents() const noexcept { return with_tangents_; }
    [[nodiscard]] bool colored() const noexcept { return colored_; }

private:
    std::shared_ptr<gl::Context> context_;
    Stage<Version, Version> copying_;
    bool with_tangents_ = false;
    bool colored_ = false;
    std::optional<gl::Buffer> buffer_;
};

}  // namespace nicol
