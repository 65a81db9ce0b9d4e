// SPDX-License-Identifier: MIT
#include "import/gltf_iridescence.hpp"

#include <vector>

#include "import/gltf_extension.hpp"

namespace nicol::scene {

GltfIridescence read_iridescence(const GltfDocument& document, const tinygltf::Material& material,
                                 const std::string& where, GltfNotices& notices) {
    const GltfExtension extension(document, material.extensions, kIridescence, where);
    const auto within = [&](double value, double least, double most, const char* name) {
        if (!(value >= least && value <= most))
            document.fail(where, std::string(kIridescence) + ": " + name + " is " + std::to_string(value) +
                                     "; expected " + std::to_string(least) + " to " + std::to_string(most));
        return value;
    };
    const auto thickness = [&](const char* name, double otherwise) {
        return within(extension.number(name, otherwise), 0, kThickestFilm, name);
    };
    GltfIridescence out;
    out.factor = within(extension.number("iridescenceFactor", 0), 0, 1, "iridescenceFactor");
    const double ior = within(extension.number("iridescenceIor", 1.3), 1, 100, "iridescenceIor");
    const double least = thickness("iridescenceThicknessMinimum", 100);
    const double most = thickness("iridescenceThicknessMaximum", 400);
    out.texture = extension.texture("iridescenceTexture");
    const bool varies = extension.texture("iridescenceThicknessTexture").index >= 0;
    if (varies && out.factor > 0)
        notices.add(std::string(kIridescence) +
                    " with a texture of the thickness has the mean of its least and its largest thickness");
    out.film.thickness = varies ? (least + most) / 2 : most;
    out.film.eta = {ior};
    // A film without thickness has no effect.
    if (!out.film.present()) out.factor = 0;
    return out;
}

}  // namespace nicol::scene
