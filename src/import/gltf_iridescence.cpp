// SPDX-License-Identifier: MIT
#include "import/gltf_iridescence.hpp"

#include <vector>

#include "import/gltf_extension.hpp"

namespace nicol::scene {

GltfIridescence read_iridescence(const GltfDocument& document, const tinygltf::Material& material,
                                 const std::string& where, bool passes, GltfNotices& notices) {
    const GltfExtension extension(document, material.extensions, kIridescence, where);
    GltfIridescence out;
    out.factor = extension.number("iridescenceFactor", 0, 0, 1);
    const double ior = extension.number("iridescenceIor", 1.3, 1, 100);
    out.least = extension.number("iridescenceThicknessMinimum", 100, 0, kThickestFilm);
    const double most = extension.number("iridescenceThicknessMaximum", 400, 0, kThickestFilm);
    out.texture = extension.texture("iridescenceTexture");
    out.thickness = extension.texture("iridescenceThicknessTexture");
    const bool varies = out.thickness.index >= 0;
    out.film = {.thickness = most, .eta = {ior}, .wavelengths = {}};
    // A film without thickness has no effect.
    if (out.factor == 0 || (!out.film.present() && !(varies && out.least > 0))) return {};
    if (varies && passes) {
        notices.add(std::string(kIridescence) +
                    " with a texture of the thickness has the mean of its least and its largest thickness on "
                    "materials that light passes");
        out.film.thickness = (out.least + most) / 2;
        out.thickness = {};
    }
    return out;
}

}  // namespace nicol::scene
