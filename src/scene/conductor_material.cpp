// SPDX-License-Identifier: MIT
// <bsdf>s of metals.
#include <algorithm>
#include <array>

#include "files/suffix.hpp"
#include "scene/material_readers.hpp"
#include "scene/values.hpp"

namespace nicol::scene {
namespace {

struct NamedMetal {
    std::string_view name;
    const char* metal;  ///< empty: a mirror of index -i
};

// Mitsuba's names, and the words.
constexpr std::array<NamedMetal, 11> kNamedMetals = {{{"none", ""},
                                                      {"au", "Au"},
                                                      {"gold", "Au"},
                                                      {"ag", "Ag"},
                                                      {"silver", "Ag"},
                                                      {"cu", "Cu"},
                                                      {"copper", "Cu"},
                                                      {"al", "Al"},
                                                      {"aluminium", "Al"},
                                                      {"aluminum", "Al"},
                                                      {"a-c", "a-C"}}};

}  // namespace

void read_conductor(const MaterialSource& source, MaterialDescription& material) {
    Plugin& plugin = source.plugin;
    const bool rough = plugin.type() == "roughconductor";
    material.kind = rough ? MaterialDescription::Kind::roughconductor : MaterialDescription::Kind::conductor;
    const std::string name = lower_case(plugin.string("material", "none"));
    const auto found = std::ranges::find(kNamedMetals, std::string_view(name), &NamedMetal::name);
    if (found == kNamedMetals.end())
        plugin.fail("material", "is " + in_quotes(name) +
                                    "; expected one of Au, Ag, Cu, Al, a-C, none, or eta and k instead");
    material.metal = found->metal;
    material.eta = plugin.color("eta", material.eta, 100.0);
    material.k = plugin.color("k", material.k, 100.0);
    for (const char* part : {"eta", "k"})
        if (!material.metal.empty() && plugin.has(part))
            plugin.fail(part, "is given beside material; expected either");
    if (material.eta.spectrum.empty() && material.k.spectrum.empty())
        for (glm::length_t i = 0; i < 3; ++i)
            if (material.eta.rgb[i] == 0.0 && material.k.rgb[i] == 0.0)
                plugin.fail(plugin.has("k") ? "k" : "eta", "and the other part of the index are both 0");
    material.specular_reflectance = read_color(source.document, plugin, "specular_reflectance", 1.0, 1.0);
    if (rough) read_facets(source, material);
}

}  // namespace nicol::scene
