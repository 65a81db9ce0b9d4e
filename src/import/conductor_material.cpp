// SPDX-License-Identifier: MIT
#include "import/conductor_material.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "files/suffix.hpp"
#include "import/material_readers.hpp"
#include "import/values.hpp"
#include "material/metal_constants.hpp"

namespace nicol::scene {
namespace {

using P = RoughConductorParameters;

/// The name as named_metals() spells it, empty for none of these.
std::string_view known_metal(const std::string& name) {
    for (const NamedMetal& metal : named_metals())
        if (lower_case(std::string(metal.name)) == lower_case(name)) return metal.name;
    return {};
}

void read_index(Plugin& plugin, MetalModel& model) {
    const std::string name = plugin.string("material", "none");
    model.metal = known_metal(name);
    if (model.metal.empty() && lower_case(name) != "none")
        plugin.fail("material", "is " + in_quotes(name) + "; expected none, eta and k instead, or one of " +
                                    metal_names());
    model.eta = plugin.color("eta", model.eta, 100.0);
    model.k = plugin.color("k", model.k, 100.0);
    for (const char* part : {"eta", "k"})
        if (!model.metal.empty() && plugin.has(part))
            plugin.fail(part, "is given beside material; expected either");
    if (!model.eta.spectrum.empty() || !model.k.spectrum.empty()) return;
    for (glm::length_t i = 0; i < 3; ++i)
        if (std::hypot(model.eta.rgb[i], model.k.rgb[i]) < kSmallestIndex)
            plugin.fail(plugin.has("k") ? "k" : "eta",
                        "and the other part of the index are both 0 or close to it; eta^2 + k^2 of a "
                        "metal is 1e-6 or more");
}

}  // namespace

MaterialPtr MetalModel::make(const MaterialMaker& maker) const {
    P conductor = with(maker);
    conductor.eta = index(maker.channels);
    return with_film(maker, film, [&](const FilmParameters& of_point) {
        conductor.film = film_table(of_point, 1, conductor.eta);
        return rough_conductor(conductor);
    });
}

std::vector<std::complex<double>> MetalModel::index(const SceneChannels& channels) const {
    if (!metal.empty()) {
        if (channels.rgb()) return metal_index(metal);
        if (!channels.wavelengths.empty()) return metal_index(metal, channels.wavelengths);
        throw Error(ErrorCode::unsupported, "a named metal under light of " + std::to_string(channels.count) +
                                                " channels without wavelengths; give grey eta and k");
    }
    const std::vector<double> n = refractive_index(eta, channels);
    const std::vector<double> absorption = refractive_index(k, channels);
    std::vector<std::complex<double>> out;
    for (std::size_t c = 0; c < std::max(n.size(), absorption.size()); ++c)
        out.emplace_back(n[n.size() == 1 ? 0 : c], -absorption[absorption.size() == 1 ? 0 : c]);
    // Both parts may be 0 if a table ends within the visible range.
    std::ranges::replace(out, std::complex<double>(0), std::complex<double>(0.001));
    return out;
}

MaterialDescription read_conductor(const MaterialSource& source) {
    MetalModel model;
    read_index(source.plugin, model);
    read_color(source, "specular_reflectance", model, &P::specular_reflectance);
    model.parameters.alpha = 0.0;
    model.film = read_film(source);
    if (source.plugin.type() == "roughconductor") set_facets(read_anisotropic_facets(source), model);
    return model;
}

glm::dvec3 extinction_of(const glm::dvec3& reflectance) {
    constexpr double most = 100;
    glm::dvec3 k;
    for (glm::length_t c = 0; c < 3; ++c)
        k[c] = std::min(2 * std::sqrt(reflectance[c] / (1 - std::min(reflectance[c], 0.9999))), most);
    return k;
}

}  // namespace nicol::scene
