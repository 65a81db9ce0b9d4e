// SPDX-License-Identifier: MIT
// Clear coats of a glTF file, KHR_materials_clearcoat.
#pragma once

#include <optional>
#include <string>

#include "import/gltf_document.hpp"
#include "import/gltf_notices.hpp"
#include "import/gltf_textures.hpp"
#include "import/material_maker.hpp"

namespace nicol::scene {

inline constexpr const char* kClearcoat = "KHR_materials_clearcoat";

struct GltfClearcoat {
    double factor = 0;                 ///< share of the surface that has the coat, 0 to 1
    double roughness = 0;              ///< 0 to 1; the facets' alpha is its square
    GltfTextureUse share_texture;      ///< factor on the share, in red
    GltfTextureUse roughness_texture;  ///< factor on the roughness, in green
};
/// Reads the extension of a material. passes: whether light passes the material, which leaves the coat out.
/// `where` names the material. Throws as GltfExtension.
[[nodiscard]] GltfClearcoat read_clearcoat(const GltfDocument& document, const tinygltf::Material& material,
                                           const std::string& where, bool passes, GltfNotices& notices);

/// A material with a clearcoat().
struct ClearcoatModel final : MaterialModel {
    /// The textures are those of `coat`, if the material has them.
    ClearcoatModel(MaterialDescription below, const GltfClearcoat& coat,
                   std::optional<TextureSpecification> share, std::optional<TextureSpecification> roughness);

    MaterialDescription base;
    TexturedNumber factor, alpha;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
