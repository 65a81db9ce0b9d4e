// SPDX-License-Identifier: MIT
#include "import/tabulated_material.hpp"

#include <algorithm>

#include "import/material_readers.hpp"
#include "material/measured.hpp"
#include "material/mixture.hpp"
#include "material/psh_matrix_file.hpp"

namespace nicol::scene {
namespace {

MaterialPtr times_texture(const MaterialPtr& material, const TexturedColor& scale,
                          const MaterialMaker& maker) {
    return scale.texture ? scaled(material, maker.textures.color(*scale.texture)) : material;
}

void read_tabulated(const MaterialSource& source, TabulatedModel& model) {
    Plugin& plugin = source.plugin;
    model.filename = plugin.filename("filename");
    model.scale = read_color(source.document, plugin, "scale", 1.0, kNoLimit);
    model.symmetrize = plugin.boolean("symmetrize", false);
    if (!model.scale.spectrum.empty())
        plugin.fail("scale", "is a table over the wavelength; expected one value or three",
                    ErrorCode::unsupported);
}

}  // namespace

MaterialPtr PshModel::make(const MaterialMaker& maker) const {
    const auto read = [&] {
        std::vector<IsotropicMatrix> matrices = read_psh_matrix(filename, maker.files.budget());
        std::vector<double> factors{1.0};
        if (!scale.texture) factors = reflectance(scale, maker.channels);
        if (std::ranges::all_of(factors, [&](double s) { return s == factors.front(); })) factors.resize(1);
        if (matrices.size() == 1) matrices.resize(factors.size(), matrices.front());
        return psh_matrix_material(std::move(matrices), factors, symmetrize);
    };
    return times_texture(maker.files.read(filename, read), scale, maker);
}

MaterialPtr MeasuredModel::make(const MaterialMaker& maker) const {
    MeasuredParameters parameters{.wavelengths = maker.channels.wavelengths, .symmetrize = symmetrize};
    if (wavelength) parameters.wavelengths = {*wavelength};
    const MaterialPtr material = maker.files.read(filename, [&] {
        return load_measured(
            filename, parameters, [&](const std::string& text) { maker.files.notice(text); },
            maker.files.budget());
    });
    if (scale.texture || scale.rgb == glm::dvec3(1)) return times_texture(material, scale, maker);
    return scaled(material, maker.textures.color(constant_specification(scale)));
}

MaterialDescription read_psh(const MaterialSource& source) {
    PshModel model;
    read_tabulated(source, model);
    return model;
}

MaterialDescription read_measured(const MaterialSource& source) {
    MeasuredModel model;
    read_tabulated(source, model);
    Plugin& plugin = source.plugin;
    const double wavelength = plugin.number("wavelength", -1.0);
    if (wavelength != -1.0) model.wavelength = plugin.number("wavelength", 0.0, 0.0, kNoLimit, true);
    plugin.pass_over({"alpha_sample"});
    return model;
}

}  // namespace nicol::scene
