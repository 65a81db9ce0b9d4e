// SPDX-License-Identifier: MIT
// Textures of scene files, as plain data.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "import/color_description.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Beginnings of the names that shapes give their attributes: those of vertices and those of faces.
inline constexpr std::string_view kVertexPrefix = "vertex_", kFacePrefix = "face_";

struct TextureSpecification {
    enum class Kind { constant, checkerboard, image };
    /// The part of an image that is used: its colours, or one of its channels as a number.
    enum class Part { color, red, green, blue, coverage };

    Kind kind = Kind::constant;
    ColorDescription color0{0.4};              ///< constant; checkerboard, the first square of colours
    ColorDescription color1{0.2};              ///< checkerboard, the first square of numbers
    std::filesystem::path filename;            ///< image; also names one that is in `bytes`
    std::shared_ptr<const std::string> bytes;  ///< image: its file, where the scene file holds it; else null
    bool raw = false;                          ///< image: see load_texture_image()
    Part part = Part::color;                   ///< image
    glm::dvec3 factor{1.0};  ///< image: t becomes factor t + offset, of red, green and blue; one number: red
    glm::dvec3 offset{0.0};  ///< image
    bool clamped = false;    ///< image: to 0 to 1, after that
    bool squared = false;    ///< image: after that
    TextureSampling sampling;                 ///< image; checkerboard: to_uv alone
    std::optional<ColorsOf> times_colors_of;  ///< any: these colours of the mesh are a factor
    std::string attribute = "color";          ///< attribute that becomes the colours, see MeshColorNames

    bool operator==(const TextureSpecification&) const = default;
};

using TextureSpecificationPtr = std::shared_ptr<const TextureSpecification>;

/// Returns a texture that is this colour everywhere.
[[nodiscard]] inline TextureSpecification constant_specification(const ColorDescription& color) {
    TextureSpecification out;
    out.color0 = color;
    return out;
}

/// Colour, or a texture that replaces the colour.
struct TexturedColor : ColorDescription {
    using ColorDescription::ColorDescription;
    TexturedColor(const ColorDescription& color) : ColorDescription(color) {}
    TexturedColor(TextureSpecificationPtr of) : ColorDescription(0.0), texture(std::move(of)) {}

    TextureSpecificationPtr texture;  ///< not null: in place of the values
};

/// Number, or a texture that replaces the number.
struct TexturedNumber {
    TexturedNumber(double number) : value(number) {}

    double value;
    TextureSpecificationPtr texture;  ///< not null: in place of the value
};

}  // namespace nicol
