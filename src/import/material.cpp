// SPDX-License-Identifier: MIT
// <bsdf>.
#include <algorithm>

#include "import/material_readers.hpp"
#include "import/polarization_element.hpp"
#include "import/text.hpp"

namespace nicol::scene {
namespace {

constexpr int kMostParts = 64;

/// Why a plug-in of Mitsuba is not there.
std::string reason(pugi::xml_node node) {
    if (is_element_material(node))
        return "it belongs into a <shape> of type rectangle or disk that emits no light";
    return "";
}

}  // namespace

MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node, Notices& notices,
                                  int& left) {
    // This ends circles, and trees that a few <ref>s make large.
    if (left-- == 0)
        document.fail(node, "a bsdf made of more than " + std::to_string(kMostParts) +
                                ", itself counted; does one refer to itself?");
    Plugin plugin(document, node);
    const auto* const type =
        std::ranges::find(kMaterialTypes, std::string_view(plugin.type()), &MaterialType::name);
    if (type == std::end(kMaterialTypes))
        plugin.fail_type(joined(kMaterialTypes, &MaterialType::name), reason(node));
    MaterialDescription material = type->read({document, node, plugin, notices, left});
    if (!type->holds_bsdfs) {
        plugin.finish();
        static_cast<void>(plugin.objects({}));
    }
    material.id = plugin.id();
    return material;
}

MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node, Notices& notices) {
    int left = kMostParts;
    return read_material(document, node, notices, left);
}

}  // namespace nicol::scene
