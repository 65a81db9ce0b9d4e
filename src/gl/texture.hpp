// SPDX-License-Identifier: MIT
// A two-dimensional texture of one level.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "gl/object.hpp"

namespace nicol::gl {

enum class Filter { nearest, linear };
enum class Wrap { clamp, repeat, mirror };  ///< clamp repeats the edge texel

/// Texel format: four floats, one float, or one unsigned integer (read through usampler2D).
enum class Format { rgba32f, r32f, r32ui };

struct TextureDescription {
    int width = 0, height = 0;  ///< texels, 1 .. Limits::texture_size
    Filter filter = Filter::nearest;
    Wrap wrap_x = Wrap::clamp, wrap_y = Wrap::clamp;
    Format format = Format::rgba32f;
};

/// A texture of one level: texels row after row; row 0 is at texture coordinate y = 0. All members must be
/// called inside run().
class Texture2D {
public:
    /// Makes a texture; without texels the content is zero. Throws Error(invalid_argument) for a size outside
    /// the limits or a wrong number of floats (numbers()), Error(out_of_memory) if the driver cannot hold it.
    Texture2D(std::shared_ptr<Context> context, const TextureDescription& description,
              std::span<const float> texels = {}, MemoryKind kind = MemoryKind::texture);

    /// Holds a texture that is not ours, of RGBA32F and immutable storage, and must outlive this object.
    /// Throws Error(invalid_argument) for any other texture.
    [[nodiscard]] static Texture2D borrowed(std::shared_ptr<Context> context, unsigned texture);

    /// Replaces all texels.
    void update(std::span<const float> texels);
    /// Replaces a rectangle of width * height texels at (x, y).
    void update(int x, int y, int width, int height, std::span<const float> texels);
    /// Copies the texels of a texture of equal size and format.
    void copy_from(const Texture2D& other);
    /// Copies out all texels; `texels` must hold numbers() numbers. Throws Error(invalid_argument) for
    /// numbers of another kind than the format's.
    void read(std::span<float> texels) const;
    void read(std::span<std::uint32_t> texels) const;

    /// Binds the texture for a `layout(binding = unit) uniform sampler2D`, or usampler2D for integers, of
    /// later draws and dispatches.
    void bind(unsigned unit) const;
    /// Binds the texture for a `layout(binding = 0) writeonly uniform image2D` of the format, the only one of
    /// a program.
    void bind_image() const;

    [[nodiscard]] int width() const noexcept { return description_.width; }
    [[nodiscard]] int height() const noexcept { return description_.height; }
    /// Returns the number of numbers of all texels; each has four bytes.
    [[nodiscard]] std::size_t numbers() const noexcept;
    [[nodiscard]] Format format() const noexcept { return description_.format; }
    [[nodiscard]] unsigned id() const noexcept { return object_.id(); }
    [[nodiscard]] const std::shared_ptr<Context>& context() const noexcept { return object_.context(); }

private:
    Texture2D(Object object, const TextureDescription& description)
        : object_(std::move(object)), description_(description) {}
    void check_numbers(const char* what, bool floats, std::size_t given, int width, int height) const;
    void read(void* texels) const;

    Object object_;
    TextureDescription description_;
};

}  // namespace nicol::gl
