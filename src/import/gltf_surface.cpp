// SPDX-License-Identifier: MIT
// The properties of primitives on which materials depend.
#include <charconv>
#include <string_view>

#include "import/gltf_readers.hpp"

namespace nicol::scene {
namespace {

/// Returns the material that KHR_materials_variants gives a primitive in the file's first variant, or -1.
int material_of_first_variant(const GltfDocument& document, const tinygltf::Primitive& primitive,
                              const std::string& where) {
    const auto found = primitive.extensions.find("KHR_materials_variants");
    if (found == primitive.extensions.end()) return -1;
    const auto is = [&](bool valid, const std::string& what) {
        if (!valid) document.fail(where, "KHR_materials_variants: " + what);
    };
    // tinygltf leaves out arrays without elements.
    static const tinygltf::Value::Array kEmpty;
    const auto list = [&](const tinygltf::Value& of, const char* name) -> const tinygltf::Value::Array& {
        if (!of.Has(name)) return kEmpty;
        is(of.Get(name).IsArray(), std::string(name) + " is not an array");
        return of.Get(name).Get<tinygltf::Value::Array>();
    };
    for (const tinygltf::Value& mapping : list(found->second, "mappings")) {
        is(mapping.IsObject(), "mappings has an element that is not an object");
        for (const tinygltf::Value& variant : list(mapping, "variants")) {
            is(variant.IsInt(), "variants has an element that is not a whole number");
            if (variant.GetNumberAsInt() != 0) continue;
            is(mapping.Has("material") && mapping.Get("material").IsInt(), "material is not a whole number");
            return mapping.Get("material").GetNumberAsInt();
        }
    }
    return -1;
}

}  // namespace

GltfSurface::GltfSurface(const GltfDocument& document, const tinygltf::Primitive& primitive,
                         const std::string& where)
    : material(primitive.material), colors(primitive.attributes.contains("COLOR_0")) {
    if (material == -1) material = material_of_first_variant(document, primitive, where);
    constexpr std::string_view prefix = "TEXCOORD_";
    for (const auto& [name, accessor] : primitive.attributes) {
        if (!name.starts_with(prefix)) continue;
        int set = 0;
        const char* const end = name.data() + name.size();
        if (std::from_chars(name.data() + prefix.size(), end, set).ptr == end) texcoord_sets.push_back(set);
    }
}

}  // namespace nicol::scene
