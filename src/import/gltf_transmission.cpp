// SPDX-License-Identifier: MIT
#include "import/gltf_transmission.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "import/gltf_extension.hpp"

namespace nicol::scene {
namespace {

// Transmittance over the attenuation's distance that replaces a colour of 0.
constexpr double kDarkest = 1e-3;

}  // namespace

double read_index(const GltfDocument& document, const tinygltf::Material& material,
                  const std::string& where) {
    const double ior = GltfExtension(document, material.extensions, kIor, where).number("ior", kIndex);
    // 0 stands for an infinite index, a mirror at every angle.
    if (ior == 0) return 1e3;
    if (!(ior >= 1 && ior <= 1e3))
        document.fail(where, "KHR_materials_ior: ior is not 0 or a number from 1 to 1000");
    return ior;
}

GltfTransmission read_transmission(const GltfDocument& document, const tinygltf::Material& material,
                                   const std::string& where, GltfNotices& notices) {
    const GltfExtension transmission(document, material.extensions, kTransmission, where);
    const GltfExtension volume(document, material.extensions, kVolume, where);
    GltfTransmission out;
    const double factor = transmission.number("transmissionFactor", 0, 0, 1);
    if (factor == 0) return out;
    if (transmission.texture("transmissionTexture").index >= 0) {
        notices.add(std::string(kTransmission) +
                    " with a texture is not followed: no light passes the surface");
        return out;
    }
    out.share = factor * (1 - std::clamp(material.pbrMetallicRoughness.metallicFactor, 0.0, 1.0));
    out.is_body = volume.number("thicknessFactor", 0) > 0;
    const double distance = volume.number("attenuationDistance", 0);
    const std::vector<double> color = volume.numbers("attenuationColor", 3);
    if (!out.is_body || !(distance > 0) || color.empty()) return out;
    for (glm::length_t c = 0; c < 3; ++c) {
        const double left =
            document.in_range(color[static_cast<std::size_t>(c)], 0, 1, where, "attenuationColor");
        out.absorption[c] = -std::log(std::max(left, kDarkest)) / distance;
    }
    return out;
}

}  // namespace nicol::scene
