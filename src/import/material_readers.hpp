// SPDX-License-Identifier: MIT
// Parameters of <bsdf>s, one reader for each family of models.
#pragma once

#include <string>

#include "import/plugin.hpp"
#include "import/readers.hpp"

namespace nicol::scene {

/// One <bsdf>.
struct MaterialSource {
    const XmlDocument& document;
    pugi::xml_node node;
    Plugin& plugin;
    Notices& notices;
};

/// Each sets the kind and what belongs to it, and throws as read_mitsuba_scene does.
void read_pplastic(const MaterialSource& source, MaterialDescription& material);
/// plastic, roughplastic
void read_plastic(const MaterialSource& source, MaterialDescription& material);
/// dielectric, roughdielectric: what their boundary reflects. Refused where light is asked for that surfaces
/// reflect to each other: most of what passes through them is.
void read_dielectric(const MaterialSource& source, MaterialDescription& material);
/// null
void read_null(MaterialDescription& material);
void read_conductor(const MaterialSource& source, MaterialDescription& material);
void read_principled(const MaterialSource& source, MaterialDescription& material);

/// A number of `least` to `most`, or a texture.
[[nodiscard]] TexturedNumber read_number(const MaterialSource& source, const char* name, double otherwise,
                                         double least, double most);
/// A number, or the name of a medium.
[[nodiscard]] double refractive_index(Plugin& plugin, const std::string& name, double otherwise);
/// int_ior and ext_ior, which differ.
void read_indices(Plugin& plugin, MaterialDescription& material);
/// The distribution of facets and their roughness; of one that differs by direction, of which there is a
/// notice, the geometric mean.
void read_facets(const MaterialSource& source, MaterialDescription& material);
/// The same with the roughness of both directions.
void read_anisotropic_facets(const MaterialSource& source, MaterialDescription& material);

}  // namespace nicol::scene
