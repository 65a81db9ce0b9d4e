// SPDX-License-Identifier: MIT
// Materials.
#include <algorithm>
#include <array>
#include <complex>

#include "assets.hpp"
#include "initialiser.hpp"
#include "material/coated_plastic.hpp"
#include "material/conductor.hpp"
#include "material/dielectric.hpp"
#include "material/measured.hpp"
#include "material/plastic.hpp"
#include "material/principled.hpp"
#include "material/psh_matrix_file.hpp"
#include "material/varying_film.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

Distribution distribution_of(nicol_distribution given) {
    require_constant(given, NICOL_DISTRIBUTION_GGX, "distribution", "NICOL_DISTRIBUTION_...");
    return given == NICOL_DISTRIBUTION_GGX ? Distribution::ggx : Distribution::beckmann;
}

std::vector<std::complex<double>> index_of(const nicol_conductor& given) {
    const std::string metal = given.metal != nullptr ? given.metal : "";
    if (!metal.empty()) {
        if (given.eta.count != 0 || given.k.count != 0)
            refuse("parameters has a metal beside eta or k; give either");
        if (given.wavelengths.count == 0) return metal_index(metal);
        return metal_index(metal, spectrum(given.wavelengths, 0, 0, "wavelengths"));
    }
    if (given.wavelengths.count != 0)
        refuse("parameters has wavelengths, which belong to a named metal, but no metal");
    const std::vector<double> eta = spectrum(given.eta, 0, 1, "eta");
    const std::vector<double> k = spectrum(given.k, 1, 1, "k");
    const std::size_t channels = std::max(eta.size(), k.size());
    for (const auto* part : {&eta, &k}) {
        if (part->size() != 1 && part->size() != channels) {
            refuse("eta has " + std::to_string(eta.size()) + " values and k " + std::to_string(k.size()) +
                   "; they must agree or one have a single value");
        }
    }
    std::vector<std::complex<double>> index;
    for (std::size_t c = 0; c < channels; ++c)
        index.emplace_back(eta[eta.size() == 1 ? 0 : c], -k[k.size() == 1 ? 0 : c]);
    return index;
}

// Parameters with the textures that replace them.
NumberParameter number(float value, nicol_texture texture, const nicol_context_impl& context) {
    return {static_cast<double>(value), texture_of(texture, context)};
}
ColorParameter color(const nicol_spectrum& value, double otherwise, const char* name, nicol_texture texture,
                     const nicol_context_impl& context) {
    return {spectrum(value, otherwise, 1, name), texture_of(texture, context)};
}

bool smooth(const NumberParameter& alpha) {
    return alpha.value == 0 && alpha.texture == nullptr;
}

// Roughness in one direction.
template <class Facets>
NumberParameter roughness(const Facets& given, float alpha, nicol_texture texture,
                          const nicol_context_impl& context) {
    const bool own = alpha != 0 || texture != nullptr;
    return number(alpha != 0 ? alpha : given.alpha, own ? texture : given.alpha_texture, context);
}

// Roughness along u and along v; the latter is 0 if both are alike.
template <class Facets>
std::array<NumberParameter, 2> roughnesses(const Facets& given, const nicol_context_impl& context) {
    const NumberParameter u = roughness(given, given.alpha_u, given.alpha_u_texture, context);
    const NumberParameter v = roughness(given, given.alpha_v, given.alpha_v_texture, context);
    if (smooth(u) != smooth(v))
        refuse(std::string(smooth(u) ? "alpha_u" : "alpha_v") +
               " and alpha are 0, and there is a roughness in the other direction; give both");
    const bool alike = u.value == v.value && u.texture == v.texture;
    return {u, alike ? NumberParameter(0.0) : v};
}

FilmParameters film_of(const nicol_film& given) {
    if (given.reserved != 0) refuse("film.reserved must be 0");
    return {.thickness = static_cast<double>(given.thickness),
            .eta = {{static_cast<double>(given.eta), -static_cast<double>(given.k)}},
            .wavelengths = spectrum(given.wavelengths, 0, 0, "film.wavelengths")};
}

/// Returns make() for the film of a material, whose thickness may vary.
template <class Given, class Make>
MaterialPtr with_film(const Given& given, const nicol_context_impl& context, const Make& make) {
    const FilmParameters film = film_of(given.film);
    const TexturePtr thickness = texture_of(given.film_thickness_texture, context);
    if (thickness == nullptr) return make(film);
    return with_film_thickness(make, film, given.film_thickness_least, film_texture(thickness));
}

MaterialPtr make(const nicol_pplastic& given, const nicol_context_impl& context) {
    if (given.reserved != 0) refuse("parameters->reserved must be 0");
    const auto [u, v] = roughnesses(given, context);
    const PplasticParameters parameters{
        .diffuse_reflectance = color(given.diffuse_reflectance, 0.5, "diffuse_reflectance",
                                     given.diffuse_reflectance_texture, context),
        .specular_reflectance = color(given.specular_reflectance, 1, "specular_reflectance",
                                      given.specular_reflectance_texture, context),
        .int_ior = static_cast<double>(given.int_ior),
        .ext_ior = static_cast<double>(given.ext_ior),
        .alpha = u,
        .alpha_v = v,
        .distribution = distribution_of(given.distribution)};
    return with_film(given, context,
                     [&](const FilmParameters& film) { return coated_pplastic(parameters, film); });
}

MaterialPtr make(const nicol_plastic& given, const nicol_context_impl& context) {
    return plastic({.diffuse_reflectance = color(given.diffuse_reflectance, 0.5, "diffuse_reflectance",
                                                 given.diffuse_reflectance_texture, context),
                    .specular_reflectance = color(given.specular_reflectance, 1, "specular_reflectance",
                                                  given.specular_reflectance_texture, context),
                    .int_ior = static_cast<double>(given.int_ior),
                    .ext_ior = static_cast<double>(given.ext_ior),
                    .alpha = number(given.alpha, given.alpha_texture, context),
                    .distribution = distribution_of(given.distribution),
                    .nonlinear = switch_from(given.nonlinear, "parameters->nonlinear")});
}

MaterialPtr make(const nicol_principled& given, const nicol_context_impl& context) {
    if (given.reserved != 0) refuse("parameters->reserved must be 0");
    const auto with = [&](float value, nicol_texture texture) { return number(value, texture, context); };
    return principled(
        {.base_color = color(given.base_color, 0.5, "base_color", given.base_color_texture, context),
         .roughness = with(given.roughness, given.roughness_texture),
         .anisotropic = with(given.anisotropic, given.anisotropic_texture),
         .metallic = with(given.metallic, given.metallic_texture),
         .spec_trans = with(given.spec_trans, given.spec_trans_texture),
         .eta = static_cast<double>(given.eta),
         .spec_tint = with(given.spec_tint, given.spec_tint_texture),
         .sheen = with(given.sheen, given.sheen_texture),
         .sheen_tint = with(given.sheen_tint, given.sheen_tint_texture),
         .flatness = with(given.flatness, given.flatness_texture),
         .clearcoat = with(given.clearcoat, given.clearcoat_texture),
         .clearcoat_gloss = with(given.clearcoat_gloss, given.clearcoat_gloss_texture)});
}

MaterialPtr make(const nicol_conductor& given, const nicol_context_impl& context) {
    if (given.reserved != 0) refuse("parameters->reserved must be 0");
    const auto [u, v] = roughnesses(given, context);
    RoughConductorParameters parameters{
        .eta = index_of(given),
        .specular_reflectance = color(given.specular_reflectance, 1, "specular_reflectance",
                                      given.specular_reflectance_texture, context),
        .alpha = u,
        .alpha_v = v,
        .distribution = distribution_of(given.distribution),
        .film = nullptr};
    return with_film(given, context, [&](const FilmParameters& film) {
        parameters.film = film_table(film, 1, parameters.eta);
        return rough_conductor(parameters);
    });
}

MaterialPtr make(const nicol_dielectric& given, const nicol_context_impl& context) {
    const bool thin = switch_from(given.thin, "parameters->thin");
    const auto make_glass = thin ? thin_dielectric : dielectric;
    return make_glass(
        {.specular_reflectance = spectrum(given.specular_reflectance, 1, 1, "specular_reflectance"),
         .specular_transmittance = spectrum(given.specular_transmittance, 1, 1, "specular_transmittance"),
         .int_ior = static_cast<double>(given.int_ior),
         .ext_ior = static_cast<double>(given.ext_ior),
         .absorption = spectrum(given.absorption, 0, 1, "absorption"),
         .alpha = number(given.alpha, given.alpha_texture, context),
         .distribution = distribution_of(given.distribution),
         .film = film_of(given.film)});
}

/// Loads a measured material, for load().
struct MeasuredLoader {
    const nicol_measured* options;

    MaterialPtr operator()(const std::filesystem::path& path, const LoadBudget& budget,
                           const SessionPtr& session) const {
        budget.take_file(path);
        const auto given = read_options(options, nicol_measured NICOL_MEASURED_INIT);
        require_constant(given.sampling, NICOL_WAVELENGTH_NEAREST, "options->sampling",
                         "NICOL_WAVELENGTH_...");
        return load_measured(
            path,
            {.wavelengths = spectrum(given.wavelengths, 0, 0, "options->wavelengths"),
             .sampling = given.sampling == NICOL_WAVELENGTH_NEAREST ? WavelengthSampling::nearest
                                                                    : WavelengthSampling::linear,
             .symmetrize = switch_from(given.symmetrize, "options->symmetrize")},
            [&](const std::string& text) { session->notice(text); }, budget);
    }
};

/// Loads a material of PSH matrices, for load().
struct PshLoader {
    const nicol_psh_matrix* options;

    MaterialPtr operator()(const std::filesystem::path& path, const LoadBudget& budget,
                           const SessionPtr& /*session*/) const {
        budget.take_file(path);
        const auto given = read_options(options, nicol_psh_matrix NICOL_PSH_MATRIX_INIT);
        const std::vector<double> scale = spectrum(given.scale, 1, 1, "options->scale");
        return psh_matrix_material(read_psh_matrix(path, budget), scale,
                                   switch_from(given.symmetrize, "options->symmetrize"));
    }
};

// A caller's function as the function of a material.
class MuellerFunction {
public:
    MuellerFunction(const nicol_callback_material& given, std::shared_ptr<void> owned, const Session* session)
        : function_(given.mueller), user_(given.user), owned_(std::move(owned)), session_(session) {}

    Mueller operator()(int channel, const glm::dvec3& towards_light, const glm::dvec3& towards_viewer) const {
        const double light[3] = {towards_light.x, towards_light.y, towards_light.z};
        const double viewer[3] = {towards_viewer.x, towards_viewer.y, towards_viewer.z};
        std::array<double, 16> m{};
        const CallbackScope scope(session_);
        if (function_(user_, static_cast<std::uint32_t>(channel), light, viewer, m.data()) == 0)
            throw Error(ErrorCode::cancelled, "the callback of a material returned 0");
        return Mueller(m);
    }

private:
    nicol_mueller_callback function_;
    void* user_;
    std::shared_ptr<void> owned_;
    const Session* session_;  // only compared, never dereferenced
};

}  // namespace

nicol_result nicol_material_create_pplastic(nicol_context context, const nicol_pplastic* parameters,
                                            nicol_material* material) {
    return create(context, material, "material", [&] {
        return make(read_struct(parameters, nicol_pplastic NICOL_PPLASTIC_INIT, "parameters"),
                    resolve(context));
    });
}

nicol_result nicol_material_create_plastic(nicol_context context, const nicol_plastic* parameters,
                                           nicol_material* material) {
    return create(context, material, "material", [&] {
        return make(read_struct(parameters, nicol_plastic NICOL_PLASTIC_INIT, "parameters"),
                    resolve(context));
    });
}

nicol_result nicol_material_create_principled(nicol_context context, const nicol_principled* parameters,
                                              nicol_material* material) {
    return create(context, material, "material", [&] {
        return make(read_struct(parameters, nicol_principled NICOL_PRINCIPLED_INIT, "parameters"),
                    resolve(context));
    });
}

nicol_result nicol_material_create_diffuse(nicol_context context, const nicol_spectrum* reflectance,
                                           nicol_material* material) {
    static constexpr nicol_spectrum unset = NICOL_SPECTRUM_INIT;
    return create(context, material, "material", [&] {
        return diffuse(spectrum(reflectance != nullptr ? *reflectance : unset, 0.5, 1, "reflectance"));
    });
}

nicol_result nicol_material_create_conductor(nicol_context context, const nicol_conductor* parameters,
                                             nicol_material* material) {
    return create(context, material, "material", [&] {
        return make(read_struct(parameters, nicol_conductor NICOL_CONDUCTOR_INIT, "parameters"),
                    resolve(context));
    });
}

nicol_result nicol_material_create_dielectric(nicol_context context, const nicol_dielectric* parameters,
                                              nicol_material* material) {
    return create(context, material, "material", [&] {
        return make(read_struct(parameters, nicol_dielectric NICOL_DIELECTRIC_INIT, "parameters"),
                    resolve(context));
    });
}

nicol_result nicol_material_load_measured(nicol_context context, const char* path,
                                          const nicol_measured* options, nicol_material* material) {
    return load(context, path, material, "material", MeasuredLoader{options});
}

nicol_result nicol_material_load_measured_memory(nicol_context context, const nicol_memory_file* file,
                                                 const nicol_measured* options, nicol_material* material) {
    return load(context, file, material, "material", MeasuredLoader{options});
}

nicol_result nicol_material_load_psh(nicol_context context, const char* path, const nicol_psh_matrix* options,
                                     nicol_material* material) {
    return load(context, path, material, "material", PshLoader{options});
}

nicol_result nicol_material_load_psh_memory(nicol_context context, const nicol_memory_file* file,
                                            const nicol_psh_matrix* options, nicol_material* material) {
    return load(context, file, material, "material", PshLoader{options});
}

nicol_result nicol_material_create_callback(nicol_context context, const nicol_callback_material* parameters,
                                            nicol_material* material) {
    return guarded([&] {
        std::shared_ptr<void> user =
            owned_user(parameters, &nicol_callback_material::release, &nicol_callback_material::user,
                       offsetof(nicol_callback_material, release) + sizeof parameters->release);
        const nicol_callback_material given =
            read_struct(parameters, nicol_callback_material NICOL_CALLBACK_MATERIAL_INIT, "parameters");
        require(material, "material");
        require(given.mueller, "parameters->mueller");
        if (given.reserved != 0) refuse("parameters->reserved must be 0");
        require_channels(given.channels);
        const SessionPtr session = resolve(context).session;
        *material = make_handle<nicol_material_impl>(
            session, callback_material({.reflect = MuellerFunction(given, std::move(user), session.get()),
                                        .channels = static_cast<int>(given.channels),
                                        .lobe_width = static_cast<double>(given.lobe_width)}));
    });
}

nicol_result nicol_material_retain(nicol_material material) {
    return retain(material);
}
nicol_result nicol_material_release(nicol_material material) {
    return release(material);
}

NICOL_INITIALISER(nicol_pplastic, NICOL_PPLASTIC_INIT)
NICOL_INITIALISER(nicol_plastic, NICOL_PLASTIC_INIT)
NICOL_INITIALISER(nicol_principled, NICOL_PRINCIPLED_INIT)
NICOL_INITIALISER(nicol_conductor, NICOL_CONDUCTOR_INIT)
NICOL_INITIALISER(nicol_film, NICOL_FILM_INIT)
NICOL_INITIALISER(nicol_dielectric, NICOL_DIELECTRIC_INIT)
NICOL_INITIALISER(nicol_measured, NICOL_MEASURED_INIT)
NICOL_INITIALISER(nicol_psh_matrix, NICOL_PSH_MATRIX_INIT)
NICOL_INITIALISER(nicol_callback_material, NICOL_CALLBACK_MATERIAL_INIT)
