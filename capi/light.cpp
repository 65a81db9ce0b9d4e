// SPDX-License-Identifier: MIT
// Lights of a scene in addition to its environment.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "assets.hpp"
#include "initialiser.hpp"
#include "light/sun.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

PolarizationState polarization_from(const nicol_polarization& given) {
    return {.dolp = given.dolp,
            .aolp = given.aolp,
            .docp = given.docp,
            .axis = {given.axis[0], given.axis[1], given.axis[2]}};
}

nicol_polarization polarization_to(const PolarizationState& state) {
    return {.dolp = state.dolp,
            .aolp = state.aolp,
            .docp = state.docp,
            .axis = {state.axis.x, state.axis.y, state.axis.z}};
}

nicol_spectrum spectrum_to(const std::vector<double>& values) {
    nicol_spectrum out = NICOL_SPECTRUM_INIT;
    out.count = static_cast<std::uint32_t>(values.size());
    std::ranges::transform(values, out.values, [](double value) { return static_cast<float>(value); });
    return out;
}

double angle_from(double degrees, double least, double most, const char* name) {
    if (!(degrees >= least && degrees <= most))
        refuse(std::string(name) + " is " + std::to_string(degrees) + " degrees; it must lie in " +
               std::to_string(least) + " to " + std::to_string(most));
    return degrees * kDegree;
}

static_assert(static_cast<int>(LocalLight::Kind::directional) == NICOL_LIGHT_DIRECTIONAL &&
              static_cast<int>(LocalLight::Kind::point) == NICOL_LIGHT_POINT &&
              static_cast<int>(LocalLight::Kind::spot) == NICOL_LIGHT_SPOT &&
              static_cast<int>(LocalLight::Kind::projector) == NICOL_LIGHT_PROJECTOR);

LocalLight light_from(const nicol_scene_impl& scene, const nicol_light* light) {
    const nicol_light given = read_struct(light, nicol_light NICOL_LIGHT_INIT, "light");
    require_constant(given.kind, NICOL_LIGHT_PROJECTOR, "light->kind", "NICOL_LIGHT_...");
    if (given.reserved != 0) refuse("light->reserved must be 0");
    LocalLight out;
    out.kind = static_cast<LocalLight::Kind>(given.kind);
    out.value = spectrum(given.value, 1, 1, "light->value");
    out.to_world = matrix(given.to_world);
    constexpr double narrowest = 0.01;
    if (given.kind == NICOL_LIGHT_DIRECTIONAL)
        out.angular_radius = angle_from(given.angular_radius, 0, 90, "light->angular_radius");
    if (given.kind == NICOL_LIGHT_SPOT) {
        out.cutoff_angle = angle_from(given.cutoff_angle, narrowest, 90, "light->cutoff_angle");
        out.beam_width = angle_from(given.beam_width, 0, given.cutoff_angle, "light->beam_width");
    }
    if (given.kind == NICOL_LIGHT_PROJECTOR) {
        out.fov = angle_from(given.fov, narrowest, 180 - 2 * narrowest, "light->fov");
        out.aspect = given.aspect;
    }
    out.texture = texture_of(given.texture, scene);
    out.state = polarization_from(given.polarization);
    return out;
}

nicol_light light_to(const LocalLight& light) {
    nicol_light out = NICOL_LIGHT_INIT;
    out.kind = static_cast<nicol_light_kind>(light.kind);
    out.value = spectrum_to(light.value);
    write_matrix(light.to_world, out.to_world);
    out.angular_radius = light.angular_radius / kDegree;
    out.cutoff_angle = light.cutoff_angle / kDegree;
    out.beam_width = light.beam_width / kDegree;
    out.fov = light.fov / kDegree;
    out.aspect = light.aspect;
    out.polarization = polarization_to(light.state);
    return out;
}

EmissionPtr emission_from(const nicol_scene_impl& scene, const nicol_emission* emission) {
    if (emission == nullptr) return nullptr;
    const nicol_emission given = read_struct(emission, nicol_emission NICOL_EMISSION_INIT, "emission");
    if (given.reserved != 0) refuse("emission->reserved must be 0");
    Emission out;
    out.radiance = spectrum(given.radiance, 1, 1, "emission->radiance");
    out.texture = texture_of(given.texture, scene);
    out.two_sided = switch_from(given.two_sided, "emission->two_sided");
    out.state = polarization_from(given.polarization);
    return std::make_shared<const Emission>(std::move(out));
}

nicol_emission emission_to(const EmissionPtr& emission) {
    nicol_emission out = NICOL_EMISSION_INIT;
    out.radiance = spectrum_to(emission ? emission->radiance : std::vector<double>{0});
    if (!emission) return out;
    out.two_sided = emission->two_sided ? 1 : 0;
    out.polarization = polarization_to(emission->state);
    return out;
}

}  // namespace

nicol_result nicol_sky_get_sun(const nicol_sky* sky, nicol_light* light) {
    return guarded([&] { write_struct(light, light_to(sun_of(sky_from(sky))), "light"); });
}

nicol_result nicol_scene_add_light(nicol_scene scene, const nicol_light* light, uint32_t* id) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        LocalLight given = light_from(self, light);
        const Edit edit(self);
        const std::uint32_t added = self.content->scene.add_light(std::move(given));
        if (id != nullptr) *id = added;
    });
}

nicol_result nicol_scene_set_light(nicol_scene scene, uint32_t id, const nicol_light* light) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        LocalLight given = light_from(self, light);
        const Edit edit(self);
        self.content->scene.set_light(id, std::move(given));
    });
}

nicol_result nicol_scene_remove_light(nicol_scene scene, uint32_t id) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        self.content->scene.remove_light(id);
    });
}

nicol_result nicol_scene_get_light(nicol_scene scene, uint32_t id, nicol_light* light,
                                   nicol_texture* texture) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        const LocalLight& found = self.content->scene.light(id);
        write_handle(self.session, found.texture, texture,
                     [&] { write_struct(light, light_to(found), "light"); });
    });
}

nicol_result nicol_scene_get_light_count(nicol_scene scene, uint32_t* lights) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        require(lights, "lights");
        const Edit edit(self);
        *lights = static_cast<uint32_t>(self.content->scene.light_ids().size());
    });
}

nicol_result nicol_scene_get_light_ids(nicol_scene scene, uint32_t* ids, uint64_t count) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        write_ids(self.content->scene.light_ids(), ids, count, "lights");
    });
}

nicol_result nicol_scene_set_emission(nicol_scene scene, uint32_t id, const nicol_emission* emission) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        EmissionPtr given = emission_from(self, emission);
        const Edit edit(self);
        self.content->scene.set_emission(id, std::move(given));
    });
}

nicol_result nicol_scene_get_emission(nicol_scene scene, uint32_t id, nicol_emission* emission,
                                      nicol_texture* texture) {
    return guarded([&] {
        const nicol_scene_impl& self = resolve(scene);
        const Edit edit(self);
        const EmissionPtr& found = self.content->scene.at(id).emission;
        write_handle(self.session, found ? found->texture : nullptr, texture,
                     [&] { write_struct(emission, emission_to(found), "emission"); });
    });
}

NICOL_INITIALISER(nicol_polarization, NICOL_POLARIZATION_INIT)
NICOL_INITIALISER(nicol_light, NICOL_LIGHT_INIT)
NICOL_INITIALISER(nicol_emission, NICOL_EMISSION_INIT)
