// SPDX-License-Identifier: MIT
// From a scene file's description to the things it describes.
#include <complex>
#include <map>

#include "handles.hpp"
#include "nicol/conductor.hpp"
#include "nicol/scene_description.hpp"

namespace nicol::capi {
namespace {

std::vector<double> rgb(const glm::dvec3& value) {
    return {value.x, value.y, value.z};
}

SceneParameters parse(const char* const* definitions, std::uint32_t count) {
    if (count > 0) require(definitions, "definitions");
    SceneParameters parameters;
    for (std::uint32_t i = 0; i < count; ++i) {
        require(definitions[i], "definitions[...]");
        const std::string text = definitions[i];
        const std::size_t equals = text.find('=');
        if (equals == 0 || equals == std::string::npos) {
            refuse("the definition \"" + text + "\" must have the form name=value");
        }
        parameters[text.substr(0, equals)] = text.substr(equals + 1);
    }
    return parameters;
}

/// n - ik for each channel.
std::vector<std::complex<double>> index_of(const MaterialDescription& d) {
    if (!d.metal.empty()) return metal_index(d.metal);
    std::vector<std::complex<double>> index;
    const glm::dvec3 &eta = d.eta, &k = d.k;
    for (glm::length_t c = 0; c < 3; ++c) index.emplace_back(eta[c], -k[c]);
    return index;
}

MaterialPtr make_front(const MaterialDescription& d) {
    const Distribution distribution =
        d.distribution == MaterialDescription::Distribution::ggx ? Distribution::ggx : Distribution::beckmann;
    switch (d.kind) {
        case MaterialDescription::Kind::diffuse:
            return diffuse(rgb(d.reflectance));
        case MaterialDescription::Kind::pplastic:
            return pplastic({.diffuse_reflectance = rgb(d.diffuse_reflectance),
                             .specular_reflectance = rgb(d.specular_reflectance),
                             .int_ior = d.int_ior,
                             .ext_ior = d.ext_ior,
                             .alpha = d.alpha,
                             .distribution = distribution});
        case MaterialDescription::Kind::conductor:
            return conductor(index_of(d), rgb(d.specular_reflectance));
        case MaterialDescription::Kind::roughconductor:
            return rough_conductor({.eta = index_of(d),
                                    .specular_reflectance = rgb(d.specular_reflectance),
                                    .alpha = d.alpha,
                                    .distribution = distribution});
        case MaterialDescription::Kind::psh:
        case MaterialDescription::Kind::measured_polarized:
            break;
    }
    throw Error(
        ErrorCode::unsupported,
        std::string("bsdf type \"") +
            (d.kind == MaterialDescription::Kind::psh ? "psh" : "measured_polarized") +
            "\" is not supported by this version; use pplastic, diffuse, conductor or roughconductor");
}

MaterialPtr make(const MaterialDescription& d) {
    return d.twosided ? twosided(make_front(d)) : make_front(d);
}

EnvironmentPtr make(const EmitterDescription& d) {
    switch (d.kind) {
        case EmitterDescription::Kind::envmap:
            return load_environment(d.filename);
        case EmitterDescription::Kind::constant:
            return constant_environment(rgb(d.radiance));
        case EmitterDescription::Kind::sky:
            return rayleigh_sky({.sun_direction = d.sun_direction,
                                 .dop_max = d.dop_max,
                                 .radiance = rgb(d.radiance),
                                 .turbidity = d.turbidity,
                                 .ground_albedo = rgb(d.ground_albedo)});
        case EmitterDescription::Kind::psh:
            break;
    }
    throw Error(ErrorCode::unsupported,
                "emitter type \"psh\" is not supported by this version; use envmap, constant or sky");
}

Mesh make(const ShapeDescription& d) {
    Mesh mesh;
    switch (d.kind) {
        case ShapeDescription::Kind::sphere:
            mesh = make_sphere(d.center, d.radius);
            break;
        case ShapeDescription::Kind::rectangle:
            mesh = make_rectangle();
            break;
        case ShapeDescription::Kind::cube:
            mesh = make_cube();
            break;
        default:
            mesh = load_mesh(d.filename);
            break;
    }
    if (d.face_normals) mesh = with_face_normals(mesh);
    if (d.flip_normals) flip_normals(mesh);
    return mesh;
}

Camera make(const SensorDescription& d) {
    Camera camera;
    camera.orthographic = d.kind == SensorDescription::Kind::orthographic;
    camera.to_world = d.to_world;
    if (!camera.orthographic) camera.fov = horizontal_fov(d);
    camera.near_clip = d.near_clip;
    camera.far_clip = d.far_clip;
    return camera;
}

}  // namespace

std::shared_ptr<SceneState> load_scene(const SessionPtr& session, const char* path,
                                       const char* const* definitions, std::uint32_t count) {
    require(path, "path");
    const SceneDescription description = read_mitsuba_scene(path, parse(definitions, count));
    if (session->log != nullptr) {
        for (const std::string& notice : description.notices) {
            session->log(session->log_user, NICOL_LOG_NOTICE, NICOL_OK, notice.c_str());
        }
    }
    if (description.sensor.luminance) {
        throw Error(ErrorCode::unsupported,
                    "film: pixel_format luminance is not supported by this version; use rgb");
    }

    auto state = std::make_shared<SceneState>(session);
    std::vector<MaterialPtr> materials;
    for (const MaterialDescription& material : description.materials) materials.push_back(make(material));
    for (const ShapeDescription& shape : description.shapes) {
        state->scene.add({.mesh = std::make_shared<const Mesh>(make(shape)),
                          .material = materials.at(shape.material),
                          .to_world = shape.to_world});
    }
    if (description.emitter) {
        state->scene.set_environment(make(*description.emitter),
                                     rotation_of(description.emitter->to_world, "emitter"),
                                     description.emitter->scale);
    }
    state->camera = make(description.sensor);
    state->width = static_cast<std::uint32_t>(description.sensor.width);
    state->height = static_cast<std::uint32_t>(description.sensor.height);
    return state;
}

}  // namespace nicol::capi
