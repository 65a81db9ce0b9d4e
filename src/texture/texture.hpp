// SPDX-License-Identifier: MIT
// Textures: values that vary over a surface.
#pragma once

#include <array>
#include <filesystem>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "files/load_budget.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Point of a surface at which a texture is evaluated.
struct TexturePoint {
    glm::vec2 uv{0};     ///< texture coordinates; v points down: an image's first row begins at v = 0
    glm::vec2 du{0};     ///< change of uv to the next pixel on the right
    glm::vec2 dv{0};     ///< change of uv to the next pixel below; du and dv both 0: no footprint, the finest
                         ///< level of a mipmap
    glm::vec3 color{1};  ///< the mesh's colour at the point: interpolated between vertices, or the face's
};

/// Kinds of a mesh's colours.
enum class ColorsOf { vertices, faces };

/// Returns the point of a triangle with these barycentric weights. Null pointers: the corners have no texture
/// coordinates or no colours.
[[nodiscard]] TexturePoint texture_point(const glm::vec3& weights, const std::array<glm::vec2, 3>* texcoords,
                                         const std::array<glm::vec3, 3>* colors);

/// Sixteen texture points side by side.
struct TexturePoints {
    std::array<Lanes, 2> uv, du, dv;
    std::array<Lanes, 3> color;

    [[nodiscard]] TexturePoint at(std::size_t lane) const {
        return {.uv = {uv[0][lane], uv[1][lane]},
                .du = {du[0][lane], du[1][lane]},
                .dv = {dv[0][lane], dv[1][lane]},
                .color = {color[0][lane], color[1][lane], color[2][lane]}};
    }
};

/// Sampling of an image as a function of u and v.
struct TextureSampling {
    /// mipmap: the mean over the pixel's footprint. Each look-up is bilinear in two levels and linear between
    /// the levels (texture/footprint.hpp).
    enum class Filter { nearest, bilinear, mipmap };
    enum class Wrap { repeat, mirror, clamp };
    Filter filter = Filter::bilinear;
    Wrap wrap = Wrap::repeat;
    /// Transform of (u, v, 1) before the look-up; its last row must be (0, 0, 1).
    glm::dmat3 to_uv{1.0};

    bool operator==(const TextureSampling&) const = default;
};

/// Image in memory: rows from the top, `channels` (1, 3 or 4) linear values per pixel.
struct TextureImage {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> values;
};

class Texture;
using TexturePtr = std::shared_ptr<const Texture>;

/// Description of a texture for code that evaluates the texture elsewhere.
struct TextureDescription {
    enum class Kind { constant, image, checkerboard, mesh_color, product };
    Kind kind;
    TextureSampling sampling = {};         ///< image; for a checkerboard only to_uv
    std::array<glm::vec4, 2> colors = {};  ///< constant: the first; checkerboard: both
    /// image: the finest level first; one more value may follow a level's values.
    std::span<const TextureImage> levels = {};
    std::array<TexturePtr, 2> factors = {};  ///< product
};

/// Immutable function of a surface point. Safe to call from several threads at once.
class Texture {
public:
    virtual ~Texture() = default;
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    /// Returns 1 (one value for all colours), 3, or 4 (with coverage).
    [[nodiscard]] virtual int channels() const noexcept = 0;
    /// Returns red, green, blue and coverage, linear and not clipped. One channel gives three equal values.
    /// Coverage is 1 if the texture has none.
    [[nodiscard]] virtual glm::vec4 at(const TexturePoint& point) const = 0;
    /// Computes at() of sixteen points: red, green, blue, coverage.
    virtual void at_lanes(const TexturePoints& points, std::array<Lanes, 4>& out) const;
    /// Returns the derivatives of the first channel by u and v. For an image, the derivatives follow the
    /// interpolation of at(); the filter `nearest` counts as bilinear. For other textures, the derivatives
    /// are 0.
    [[nodiscard]] virtual glm::vec2 gradient(const TexturePoint& point) const = 0;
    /// Returns the mean of at() over the whole texture.
    [[nodiscard]] virtual glm::vec4 mean() const = 0;
    /// Returns the least and largest value of the first channel that at() yields.
    [[nodiscard]] virtual glm::vec2 range() const = 0;
    /// Returns the distinct values of the first channel, ascending, if there are few (such as the two of a
    /// checkerboard, which are not interpolated); else an empty vector.
    [[nodiscard]] virtual std::vector<float> values() const { return {}; }
    /// Returns whether at() is mean() everywhere.
    [[nodiscard]] virtual bool constant() const noexcept = 0;
    /// Returns whether at() needs texture coordinates, or these colours of the mesh.
    [[nodiscard]] virtual bool needs_texcoords() const noexcept = 0;
    [[nodiscard]] virtual bool needs_colors(ColorsOf of) const noexcept = 0;
    /// Returns whether at() depends on the distance between pixels.
    [[nodiscard]] virtual bool needs_footprint() const noexcept { return needs_texcoords(); }

    /// Returns a description that is valid as long as the texture exists.
    [[nodiscard]] virtual TextureDescription describe() const = 0;

protected:
    Texture() = default;
};

/// Returns whether a texture needs any colours of the mesh.
[[nodiscard]] inline bool needs_colors(const Texture& texture) {
    return texture.needs_colors(ColorsOf::vertices) || texture.needs_colors(ColorsOf::faces);
}

/// Returns the texture of an image. Throws Error(invalid_argument) for an image without pixels, sizes that do
/// not fit, a value that is not finite, or a transform that is not finite and affine.
[[nodiscard]] TexturePtr image_texture(TextureImage image, const TextureSampling& sampling = {});

/// Decodes colours of 0 to 1 from sRGB and leaves coverage unchanged.
void decode_srgb(TextureImage& image);

/// Reads a file of PNG, JPEG, BMP, TGA, Radiance HDR or EXR (R G B or Y of its first part, with A as
/// coverage). Grey with coverage becomes four channels. With `raw`, values are the file's numbers, n / 255 or
/// n / 65535 for integers. Without `raw`, numbers of 8 and 16 bits are decoded from sRGB. Throws
/// Error(file_not_found), Error(invalid_file) or Error(unsupported).
[[nodiscard]] TextureImage load_texture_image(const std::filesystem::path& file, bool raw,
                                              const LoadBudget& budget = {});

/// Returns Mitsuba's checkerboard of colours: color0 if floor(2u) + floor(2v) is even, else color1, for the
/// fractional parts of u and v after to_uv. Both colours have 1 or 3 channels.
[[nodiscard]] TexturePtr checkerboard_texture(const glm::vec3& color0, const glm::vec3& color1, int channels,
                                              const glm::dmat3& to_uv = glm::dmat3(1.0));

/// Returns a texture with the colours of the mesh. Because the texture does not know the mesh, mean() is 0.5
/// and range() is 0 to 1.
[[nodiscard]] TexturePtr mesh_color_texture(ColorsOf of);

/// Returns a texture with one value everywhere and 1, 3 or 4 channels.
[[nodiscard]] TexturePtr constant_texture(const glm::vec4& value, int channels);

/// Returns the colours divided by their luminance (of linear BT.709), or white if the luminance is 0. A
/// texture of one channel gives 1 everywhere. Throws Error(unsupported) for colours of a mesh, alone or as a
/// factor, and Error(invalid_argument) for null.
[[nodiscard]] TexturePtr tint_texture(const TexturePtr& colors);

/// Returns the product of two textures. Its gradient is 0, and its mean is the product of the factors' means,
/// which is exact for independent factors. Throws Error(invalid_argument) for null, and for channels other
/// than 1 or 3.
[[nodiscard]] TexturePtr product_texture(TexturePtr first, TexturePtr second);

}  // namespace nicol
