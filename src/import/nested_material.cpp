// SPDX-License-Identifier: MIT
#include "import/nested_material.hpp"

#include "import/material_readers.hpp"
#include "material/mixture.hpp"

namespace nicol::scene {
namespace {

/// A number of 0 to 1, or a texture.
TextureSpecificationPtr fraction(const MaterialSource& source, const char* name, double otherwise) {
    const TexturedNumber number = read_number(source, name, otherwise, 0.0, 1.0);
    if (number.texture) return number.texture;
    return std::make_shared<const TextureSpecification>(constant_specification(number.value));
}

/// The bsdfs inside, behind the last parameter.
std::vector<MaterialDescription> read_parts(const MaterialSource& source, std::size_t count) {
    source.plugin.finish();
    const std::vector<NestedObject> parts = source.plugin.objects({"bsdf"});
    if (parts.size() != count)
        source.plugin.fail(
            "", "has " + std::to_string(parts.size()) + " bsdfs inside; expected " + std::to_string(count));
    std::vector<MaterialDescription> out;
    out.reserve(parts.size());
    for (const NestedObject& part : parts)
        out.push_back(read_material(source.document, part.node, source.notices, source.left));
    return out;
}

}  // namespace

MaterialPtr NormalMapModel::make(const MaterialMaker& maker) const {
    MaterialPtr material = maker.make(base);
    return normal_mapped(std::move(material), maker.textures.vector(*texture), mirrored_y);
}

MaterialPtr BumpMapModel::make(const MaterialMaker& maker) const {
    MaterialPtr material = maker.make(base);
    return bump_mapped(std::move(material), maker.textures.number(*texture), scale);
}

MaterialPtr MaskModel::make(const MaterialMaker& maker) const {
    MaterialPtr material = maker.make(base);
    TexturePtr opacity = maker.textures.number(*texture);
    const float value = opacity->mean().x;
    if (opacity->constant() && value > 0 && value < 1)
        maker.files.notice("a surface with an opacity between 0 and 1 is " +
                           std::string(value < 0.5F ? "not drawn" : "drawn without seeing through it"));
    return masked(std::move(material), std::move(opacity));
}

MaterialPtr BlendModel::make(const MaterialMaker& maker) const {
    const MaterialPtr first = maker.make(base);
    const MaterialPtr second = maker.make(other);
    return blend(first, second, maker.textures.number(*texture));
}

MaterialDescription read_normal_map(const MaterialSource& source) {
    TextureSpecificationPtr normals = read_texture(source.document, source.plugin.only_texture());
    // Both treat light and views below the horizon of the perturbed normal.
    source.plugin.pass_over({"use_shadowing_function", "flip_invalid_normals"});
    return NormalMapModel(read_parts(source, 1).front(), std::move(normals));
}

MaterialDescription read_bump_map(const MaterialSource& source) {
    TextureSpecificationPtr heights = read_texture(source.document, source.plugin.only_texture());
    const double scale = source.plugin.number("scale", 1.0);
    BumpMapModel model(read_parts(source, 1).front(), std::move(heights));
    model.scale = scale;
    return model;
}

MaterialDescription read_mask(const MaterialSource& source) {
    TextureSpecificationPtr opacity = fraction(source, "opacity", 0.5);
    return MaskModel(read_parts(source, 1).front(), std::move(opacity));
}

MaterialDescription read_blend(const MaterialSource& source) {
    if (!source.plugin.has("weight"))
        source.plugin.fail("weight", "is missing; expected a <float> or a <texture>");
    TextureSpecificationPtr weight = fraction(source, "weight", 0.0);
    const std::vector<MaterialDescription> parts = read_parts(source, 2);
    return BlendModel(parts.front(), parts.back(), std::move(weight));
}

MaterialDescription read_twosided(const MaterialSource& source) {
    const auto& [document, node, plugin, notices, left] = source;
    plugin.finish();
    const std::vector<NestedObject> sides = plugin.objects({"bsdf"});
    if (sides.empty()) plugin.fail("", "has no bsdf inside; expected one");
    for (const NestedObject& side : sides) {
        if (std::string_view(side.node.attribute("type").value()) == "twosided")
            document.fail(side.place, "a bsdf \"twosided\" inside another");
        if (side.node != sides.front().node)
            document.fail(side.place, "a second bsdf in a \"twosided\"; both sides must be the same",
                          ErrorCode::unsupported);
    }
    MaterialDescription material = read_material(document, sides.front().node, notices, left);
    material.twosided = true;
    return material;
}

}  // namespace nicol::scene
