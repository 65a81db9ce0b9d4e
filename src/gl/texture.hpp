// SPDX-License-Identifier: MIT
// A two-dimensional texture of four floats a texel (GL_RGBA32F), one level.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "gl/object.hpp"

namespace nicol::gl {

enum class Filter { nearest, linear };
enum class Wrap { clamp, repeat, mirror };  ///< clamp repeats the edge texel

struct TextureDescription {
    int width = 0, height = 0;  ///< texels, 1 .. Limits::texture_size
    Filter filter = Filter::nearest;
    Wrap wrap_x = Wrap::clamp, wrap_y = Wrap::clamp;
};

/// Texels are four floats, row after row; row 0 is at texture coordinate y = 0. All members inside run().
class Texture2D {
public:
    /// Without texels the content is zero. Error(invalid_argument) for a size outside the limits or a wrong
    /// number of floats (width * height * 4), Error(out_of_memory) if the driver cannot hold it.
    Texture2D(std::shared_ptr<Context> context, const TextureDescription& description,
              std::span<const float> texels = {}, MemoryKind kind = MemoryKind::texture);

    /// Replaces everything.
    void update(std::span<const float> texels);
    /// Replaces a rectangle of width * height texels at (x, y).
    void update(int x, int y, int width, int height, std::span<const float> texels);
    /// Copies everything out; width * height * 4 floats.
    void read(std::span<float> texels) const;

    /// For a `layout(binding = unit) uniform sampler2D`.
    void bind(unsigned unit) const;

    [[nodiscard]] int width() const noexcept { return description_.width; }
    [[nodiscard]] int height() const noexcept { return description_.height; }
    [[nodiscard]] std::size_t floats() const noexcept;
    [[nodiscard]] unsigned id() const noexcept { return object_.id(); }
    [[nodiscard]] const std::shared_ptr<Context>& context() const noexcept { return object_.context(); }

private:
    Object object_;
    TextureDescription description_;
};

}  // namespace nicol::gl
