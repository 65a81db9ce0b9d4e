// SPDX-License-Identifier: MIT
// The types of <bsdf>s, and what their readers share.
#pragma once

#include <string_view>

#include "import/film_description.hpp"
#include "import/late_parameters.hpp"
#include "import/plugin.hpp"
#include "import/readers.hpp"

namespace nicol::scene {

/// One <bsdf>.
struct MaterialSource {
    const XmlDocument& document;
    pugi::xml_node node;
    Plugin& plugin;
    Notices& notices;
    int& left;  ///< see read_material()
};

// Each of these functions reads the parameters of one type or family, and throws what read_mitsuba_scene
// throws.

[[nodiscard]] MaterialDescription read_pplastic(const MaterialSource& source);
/// plastic, roughplastic
[[nodiscard]] MaterialDescription read_plastic(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_diffuse(const MaterialSource& source);
/// conductor, roughconductor
[[nodiscard]] MaterialDescription read_conductor(const MaterialSource& source);
/// Reads what the boundary reflects if the scene's integrator reflects light once, and otherwise a material
/// that light passes.
[[nodiscard]] MaterialDescription read_dielectric(const MaterialSource& source);
/// Reads a rough boundary as read_dielectric() reads a smooth one.
[[nodiscard]] MaterialDescription read_rough_dielectric(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_thin_dielectric(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_null(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_principled(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_principled_thin(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_measured(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_psh(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_twosided(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_normal_map(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_bump_map(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_mask(const MaterialSource& source);
[[nodiscard]] MaterialDescription read_blend(const MaterialSource& source);

struct MaterialType {
    std::string_view name;
    MaterialDescription (*read)(const MaterialSource& source);
    bool holds_bsdfs = false;  ///< read() calls Plugin::finish() and takes the objects inside
};

/// In the order in which messages name them.
inline constexpr MaterialType kMaterialTypes[] = {{"pplastic", read_pplastic},
                                                  {"plastic", read_plastic},
                                                  {"roughplastic", read_plastic},
                                                  {"diffuse", read_diffuse},
                                                  {"conductor", read_conductor},
                                                  {"roughconductor", read_conductor},
                                                  {"dielectric", read_dielectric},
                                                  {"thindielectric", read_thin_dielectric},
                                                  {"roughdielectric", read_rough_dielectric},
                                                  {"null", read_null},
                                                  {"principled", read_principled},
                                                  {"principledthin", read_principled_thin},
                                                  {"measured_polarized", read_measured},
                                                  {"psh", read_psh},
                                                  {"twosided", read_twosided, true},
                                                  {"normalmap", read_normal_map, true},
                                                  {"bumpmap", read_bump_map, true},
                                                  {"mask", read_mask, true},
                                                  {"blendbsdf", read_blend, true}};

/// Reads a number of `least` to `most`, or a texture.
[[nodiscard]] TexturedNumber read_number(const MaterialSource& source, const char* name, double otherwise,
                                         double least, double most);
/// Reads a number of 0 to 1, or a texture, into a parameter; the model's default where the file has none.
template <class P>
void read_fraction(const MaterialSource& source, const char* name, LateParameters<P>& out,
                   NumberParameter P::*parameter) {
    out.set(parameter, read_number(source, name, (out.parameters.*parameter).value, 0.0, 1.0));
}
/// Reads a colour of 0 to 1, or a texture, into a parameter; the model's default where the file has none.
template <class P>
void read_color(const MaterialSource& source, const char* name, LateParameters<P>& out,
                ColorParameter P::*parameter) {
    const double otherwise = (out.parameters.*parameter).values.front();
    out.set(parameter, read_color(source.document, source.plugin, name, otherwise, 1.0));
}

/// Returns whether the scene's integrator, which may stand behind the bsdf in the file, reflects light more
/// than once; true if the scene has no integrator.
[[nodiscard]] bool reflects_often(const XmlDocument& document);

/// Reads int_ior and ext_ior, numbers or names of media, which must differ unless there is a film. The
/// arguments hold the defaults.
void read_indices(Plugin& plugin, double& int_ior, double& ext_ior);

/// Reads film_thickness, a number or a texture from film_thickness_least to film_thickness_most, film_eta and
/// film_k, which are not Mitsuba's.
[[nodiscard]] FilmDescription read_film(const MaterialSource& source);

/// Reads the facets of an isotropic material: the geometric mean, with a notice, where the roughness differs
/// by direction.
[[nodiscard]] FacetDescription read_facets(const MaterialSource& source);
/// Reads the facets of a material that may be anisotropic.
[[nodiscard]] FacetDescription read_anisotropic_facets(const MaterialSource& source);

}  // namespace nicol::scene
