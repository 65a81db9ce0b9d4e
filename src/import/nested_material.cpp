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

MapOptions read_map_options(const MaterialSource& source) {
    // Perturbed normals that face away from the viewer are always flipped.
    source.plugin.pass_over({"flip_invalid_normals"});
    return {.shadowed = source.plugin.boolean("use_shadowing_function", true)};
}

}  // namespace

MaterialPtr NormalMapModel::make(const MaterialMaker& maker) const {
    MaterialPtr material = maker.make(base);
    return normal_mapped(std::move(material), maker.textures.vector(*texture), options);
}

MaterialPtr BumpMapModel::make(const MaterialMaker& maker) const {
    MaterialPtr material = maker.make(base);
    if (texture->sampling.filter == TextureSampling::Filter::nearest) {
        maker.files.notice("a bump map whose texture has the filter_type nearest is flat, as in Mitsuba");
        return material;
    }
    return bump_mapped(std::move(material), maker.textures.number(*texture), scale, options);
}

MaterialPtr MaskModel::make(const MaterialMaker& maker) const {
    MaterialPtr material = maker.make(base);
    return masked(std::move(material), maker.textures.number(*texture), translucent);
}

MaterialPtr BlendModel::make(const MaterialMaker& maker) const {
    const MaterialPtr first = maker.make(base);
    const MaterialPtr second = maker.make(other);
    return blend(first, second, maker.textures.number(*texture));
}

MaterialDescription read_normal_map(const MaterialSource& source) {
    TextureSpecificationPtr normals = read_texture(source.document, source.plugin.only_texture());
    const MapOptions options = read_map_options(source);
    NormalMapModel model(read_parts(source, 1).front(), std::move(normals));
    model.options = options;
    return model;
}

MaterialDescription read_bump_map(const MaterialSource& source) {
    TextureSpecificationPtr heights = read_texture(source.document, source.plugin.only_texture());
    const double scale = source.plugin.number("scale", 1.0);
    const MapOptions options = read_map_options(source);
    BumpMapModel model(read_parts(source, 1).front(), std::move(heights));
    model.scale = scale;
    model.options = options;
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
