// SPDX-License-Identifier: MIT
// <bsdf>s of metals.
#include <cmath>

#include "files/suffix.hpp"
#include "import/material_readers.hpp"
#include "import/values.hpp"
#include "material/conductor.hpp"
#include "material/metal_constants.hpp"

namespace nicol::scene {
namespace {

/// The name as named_metals() spells it, empty for none of these.
std::string_view known_metal(const std::string& name) {
    for (const NamedMetal& metal : named_metals())
        if (lower_case(std::string(metal.name)) == lower_case(name)) return metal.name;
    return {};
}

}  // namespace

void read_conductor(const MaterialSource& source, MaterialDescription& material) {
    Plugin& plugin = source.plugin;
    const bool rough = plugin.type() == "roughconductor";
    material.kind = rough ? MaterialDescription::Kind::roughconductor : MaterialDescription::Kind::conductor;
    const std::string name = plugin.string("material", "none");
    material.metal = known_metal(name);
    if (material.metal.empty() && lower_case(name) != "none")
        plugin.fail("material", "is " + in_quotes(name) + "; expected none, eta and k instead, or one of " +
                                    metal_names());
    material.eta = plugin.color("eta", material.eta, 100.0);
    material.k = plugin.color("k", material.k, 100.0);
    for (const char* part : {"eta", "k"})
        if (!material.metal.empty() && plugin.has(part))
            plugin.fail(part, "is given beside material; expected either");
    if (material.eta.spectrum.empty() && material.k.spectrum.empty())
        for (glm::length_t i = 0; i < 3; ++i)
            if (std::hypot(material.eta.rgb[i], material.k.rgb[i]) < kSmallestIndex)
                plugin.fail(plugin.has("k") ? "k" : "eta",
                            "and the other part of the index are both 0 or close to it; eta^2 + k^2 of a "
                            "metal is 1e-6 or more");
    material.specular_reflectance = read_color(source.document, plugin, "specular_reflectance", 1.0, 1.0);
    if (rough) read_anisotropic_facets(source, material);
}

}  // namespace nicol::scene
