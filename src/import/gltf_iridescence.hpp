// SPDX-License-Identifier: MIT
// Thin films of a glTF file, KHR_materials_iridescence.
#pragma once

#include <string>

#include "import/gltf_document.hpp"
#include "import/gltf_notices.hpp"
#include "import/gltf_textures.hpp"
#include "material/film.hpp"

namespace nicol::scene {

inline constexpr const char* kIridescence = "KHR_materials_iridescence";

struct GltfIridescence {
    double factor = 0;              ///< share of the surface that has the film, 0 to 1
    GltfTextureUse texture;         ///< factor on the share, in red
    FilmParameters film;            ///< film of the largest thickness
    double least = 0;               ///< thickness in nm where `thickness` is 0
    GltfTextureUse thickness = {};  ///< thickness from `least` to film.thickness, in green
};

/// Reads the extension of a material. `where` names it. passes: whether light passes the material, whose film
/// has one thickness then. Throws as GltfExtension.
[[nodiscard]] GltfIridescence read_iridescence(const GltfDocument& document,
                                               const tinygltf::Material& material, const std::string& where,
                                               bool passes, GltfNotices& notices);

}  // namespace nicol::scene
