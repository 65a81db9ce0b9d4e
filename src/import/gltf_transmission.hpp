// SPDX-License-Identifier: MIT
// Refraction and transmission of light by surfaces of a glTF file.
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "import/gltf_document.hpp"
#include "import/gltf_notices.hpp"

namespace nicol::scene {

inline constexpr const char* kIor = "KHR_materials_ior";
inline constexpr const char* kTransmission = "KHR_materials_transmission";
inline constexpr const char* kVolume = "KHR_materials_volume";

/// Index of refraction of a material that gives none.
inline constexpr double kIndex = 1.5;
/// Returns the index of refraction of a material. `where` names it. Throws as GltfExtension.
[[nodiscard]] double read_index(const GltfDocument& document, const tinygltf::Material& material,
                                const std::string& where);

struct GltfTransmission {
    double share = 0;            ///< share of the light into the base that passes the surface, 0 to 1
    bool is_body = false;        ///< true: the surface bounds a body; false: it is a thin sheet
    glm::dvec3 absorption{0.0};  ///< absorption coefficient of the body, per unit of length
};

/// Reads both extensions of a material. `where` names it. Throws as GltfExtension.
[[nodiscard]] GltfTransmission read_transmission(const GltfDocument& document,
                                                 const tinygltf::Material& material, const std::string& where,
                                                 GltfNotices& notices);

}  // namespace nicol::scene
