// SPDX-License-Identifier: MIT
// Parts of glTF materials that are not followed.
#pragma once

#include "import/gltf_document.hpp"
#include "import/gltf_notices.hpp"

namespace nicol::scene {

inline constexpr const char* kAnisotropy = "KHR_materials_anisotropy";
inline constexpr const char* kSpecular = "KHR_materials_pbrSpecularGlossiness";
inline constexpr const char* kUnlit = "KHR_materials_unlit";

/// Adds notices about a material. is_specular: whether kSpecular describes it.
void say_what_is_left(const tinygltf::Material& material, bool is_specular, GltfNotices& notices);

}  // namespace nicol::scene
