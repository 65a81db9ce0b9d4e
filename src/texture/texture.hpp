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

/// A point of a surface, as a texture sees it.
struct TexturePoint {
    glm::vec2 uv{0};     ///< texture coordinates; v points down: an image's first row begins at v = 0
    glm::vec2 du{0};     ///< change of uv to the next pixel on the right ...
    glm::vec2 dv{0};     ///< ... and below; both 0: no footprint, the finest level of a mipmap
    glm::vec3 color{1};  ///< the mesh's colour there, of its vertices, interpolated, or of its face
};

/// Which of a mesh's colours.
enum class ColorsOf { vertices, faces };

/// The point of a triangle with these barycentric weights; null: its corners have none.
[[nodiscard]] TexturePoint texture_point(const glm::vec3& weights, const std::array<glm::vec2, 3>* texcoords,
                                         const std::array<glm::vec3, 3>* colors);

/// Sixteen points side by side.
struct TexturePoints {
    std::array<Lanes, 2> uv, du, dv;
    std::array<Lanes, 3> color;
};

/// How an image becomes a function of u and v.
struct TextureSampling {
    /// mipmap: the mean over what a pixel covers, of look-ups that are bilinear in two levels and linear
    /// between them (texture/footprint.hpp).
    enum class Filter { nearest, bilinear, mipmap };
    enum class Wrap { repeat, mirror, clamp };
    Filter filter = Filter::bilinear;
    Wrap wrap = Wrap::repeat;
    /// Applied to (u, v, 1) before the look-up; its last row must be (0, 0, 1).
    glm::dmat3 to_uv{1.0};

    bool operator==(const TextureSampling&) const = default;
};

/// An image in memory, rows from the top: values of `channels` (1, 3 or 4) a pixel, linear.
struct TextureImage {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> values;
};

class Texture;
using TexturePtr = std::shared_ptr<const Texture>;

/// What a texture is, for those who evaluate it elsewhere.
struct TextureDescription {
    enum class Kind { constant, image, checkerboard, mesh_color, product };
    Kind kind;
    TextureSampling sampling = {};         ///< image; of a checkerboard to_uv alone
    std::array<glm::vec4, 2> colors = {};  ///< constant: the first; checkerboard: both
    std::span<const TextureImage> levels =
        {};                                  ///< image: the finest first; values may be followed by one more
    std::array<TexturePtr, 2> factors = {};  ///< product
};

/// Immutable; all functions may be called from several threads at once.
class Texture {
public:
    virtual ~Texture() = default;
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    /// 1 (the same for every colour), 3, or 4 (with coverage).
    [[nodiscard]] virtual int channels() const noexcept = 0;
    /// Red, green, blue, coverage: linear, not clipped. One channel: three equal values; without coverage: 1.
    [[nodiscard]] virtual glm::vec4 at(const TexturePoint& point) const = 0;
    /// at() of sixteen points: red, green, blue, coverage.
    virtual void at_lanes(const TexturePoints& points, std::array<Lanes, 4>& out) const;
    /// Of the first channel by u and by v, of an image as at() interpolates it, but of one without a filter
    /// as of a bilinear one; 0 of other textures.
    [[nodiscard]] virtual glm::vec2 gradient(const TexturePoint& point) const = 0;
    /// Of at() over the whole texture.
    [[nodiscard]] virtual glm::vec4 mean() const = 0;
    /// Least and largest value of the first channel that at() yields.
    [[nodiscard]] virtual glm::vec2 range() const = 0;
    /// The values of the first channel, ascending, where there are few (as a checkerboard's two, without
    /// interpolation between them); else empty.
    [[nodiscard]] virtual std::vector<float> values() const { return {}; }
    /// Whether at() is mean() everywhere.
    [[nodiscard]] virtual bool constant() const noexcept = 0;
    /// Whether at() needs texture coordinates, or these colours of the mesh.
    [[nodiscard]] virtual bool needs_texcoords() const noexcept = 0;
    [[nodiscard]] virtual bool needs_colors(ColorsOf of) const noexcept = 0;
    /// Whether it matters how far apart pixels are.
    [[nodiscard]] virtual bool needs_footprint() const noexcept { return needs_texcoords(); }

    /// Valid as long as the texture.
    [[nodiscard]] virtual TextureDescription describe() const = 0;

protected:
    Texture() = default;
};

/// Throws Error(invalid_argument): no pixels, sizes that do not fit, a value that is not finite, a transform
/// that is not finite and affine.
[[nodiscard]] TexturePtr image_texture(TextureImage image, const TextureSampling& sampling = {});

/// Decodes colours of 0..1 from sRGB; coverage stays.
void decode_srgb(TextureImage& image);

/// PNG, JPEG, BMP, TGA, Radiance HDR, EXR (R G B or Y of its first part; with A as coverage). Grey with
/// coverage becomes four channels. raw: the file's numbers as they are, n / 255 or n / 65535 for integers;
/// else those of 8 and 16 bits are decoded from sRGB. Throws Error: file_not_found, invalid_file,
/// unsupported.
[[nodiscard]] TextureImage load_texture_image(const std::filesystem::path& file, bool raw,
                                              const LoadBudget& budget = {});
/// The same of the bytes of a file with this name, which is not opened; not EXR.
[[nodiscard]] TextureImage load_texture_image(const std::filesystem::path& file, std::string_view bytes,
                                              bool raw, const LoadBudget& budget = {});

/// Mitsuba's checkerboard of colours: color0 where floor(2u) + floor(2v) is even, else color1, u and v after
/// to_uv and without their whole part. Both of 1 or 3 channels.
[[nodiscard]] TexturePtr checkerboard_texture(const glm::vec3& color0, const glm::vec3& color1, int channels,
                                              const glm::dmat3& to_uv = glm::dmat3(1.0));

/// The colours of the mesh, which it does not know: mean() is 0.5, range() 0 to 1.
[[nodiscard]] TexturePtr mesh_color_texture(ColorsOf of);

/// One value everywhere; 1, 3 or 4 channels.
[[nodiscard]] TexturePtr constant_texture(const glm::vec4& value, int channels);

/// The colours over their luminance (of linear BT.709), white where that is 0; one channel: 1 everywhere.
/// Throws Error(unsupported) for colours of a mesh, alone or as a factor; Error(invalid_argument) for null.
[[nodiscard]] TexturePtr tint_texture(const TexturePtr& colors);

/// Of two textures. Its gradient is 0, and its mean that of factors that do not depend on each other. Throws
/// Error(invalid_argument) for null, and for channels other than 1 or 3.
[[nodiscard]] TexturePtr product_texture(TexturePtr first, TexturePtr second);

}  // namespace nicol
