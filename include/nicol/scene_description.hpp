// SPDX-License-Identifier: MIT
// What a Mitsuba 3 scene file says, as plain data.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nicol {

/// A camera and the size of its picture. Camera space: +z forward, +x image LEFT, +y image up.
struct SensorDescription {
    enum class Kind { perspective, orthographic };
    enum class FovAxis { x, y, diagonal, smaller, larger };
    Kind kind = Kind::perspective;
    double fov = 0.0;  ///< perspective: degrees along fov_axis, in (0, 180)
    FovAxis fov_axis = FovAxis::x;
    /// Camera to world, affine. Orthographic: the picture spans [-1, 1] of camera x, and of y by the aspect.
    glm::dmat4 to_world{1.0};
    double near_clip = 1e-2;
    double far_clip = 1e4;
    int width = 768;
    int height = 576;
};

/// The horizontal field of view in degrees of a perspective sensor, whatever its fov_axis.
[[nodiscard]] double horizontal_fov(const SensorDescription& sensor);

struct MaterialDescription {
    enum class Kind { pplastic, diffuse, psh };
    enum class Distribution { beckmann, ggx };
    Kind kind = Kind::diffuse;
    std::string id;                                      ///< empty when the file gives none
    glm::dvec3 reflectance{0.5};                         ///< diffuse
    glm::dvec3 diffuse_reflectance{0.5};                 ///< pplastic
    glm::dvec3 specular_reflectance{1.0};                ///< pplastic
    double int_ior = 1.49;                               ///< pplastic, inside
    double ext_ior = 1.000277;                           ///< pplastic, outside
    double alpha = 0.1;                                  ///< pplastic, roughness
    Distribution distribution = Distribution::beckmann;  ///< pplastic
    std::filesystem::path filename;                      ///< psh: a PSH matrix (.npz)
    glm::dvec3 scale{1.0};                               ///< psh
};

struct ShapeDescription {
    enum class Kind { obj, ply, off, stl, sphere, rectangle, cube };
    Kind kind = Kind::obj;
    std::string id;                  ///< empty when the file gives none
    std::filesystem::path filename;  ///< obj, ply, off, stl
    glm::dvec3 center{0.0};          ///< sphere
    double radius = 1.0;             ///< sphere
    bool flip_normals = false;
    bool face_normals = false;  ///< obj, ply, off, stl: hard edges everywhere
    glm::dmat4 to_world{1.0};   ///< affine and invertible
    std::size_t material = 0;   ///< index into SceneDescription::materials
};

struct EmitterDescription {
    enum class Kind { envmap, psh, constant, sky };
    Kind kind = Kind::constant;
    std::filesystem::path filename;  ///< envmap: EXR; psh: a PSH vector (.npz)
    double scale = 1.0;              ///< envmap, psh
    glm::dvec3 radiance{1.0};        ///< constant, sky
    glm::dvec3 sun_direction{0.0};   ///< sky: unit, towards the sun, in the emitter's frame (y up)
    double dop_max = 0.8;            ///< sky: degree of polarization at 90 degrees from the sun, in [0, 1]
    glm::dmat4 to_world{1.0};        ///< affine and invertible; only its rotation matters
};

struct SceneDescription {
    SensorDescription sensor;
    std::vector<MaterialDescription> materials;
    std::vector<ShapeDescription> shapes;
    std::optional<EmitterDescription> emitter;
    std::vector<std::string> notices;  ///< what was read and not followed, one sentence each
};

/// Values for the file's $parameters, by name without the $; they win over <default>.
using SceneParameters = std::map<std::string, std::string>;

/// Reads a scene of Mitsuba 3's XML format. Defaults are Mitsuba's, and so is the meaning of each parameter;
/// beside its plug-ins (sensors perspective, orthographic; shapes obj, ply, sphere, rectangle, cube; bsdfs
/// pplastic, diffuse; emitters envmap, constant) these are ours: shapes off and stl, bsdf psh, emitters psh
/// and sky. Integrator, sampler and reconstruction filter are not followed. <rgb> takes one value, three, or
/// #rrggbb, which is linear n / 255. Filenames are resolved against the folder of the scene, not opened.
/// Throws Error: file_not_found; unsupported (a plug-in, element or value outside the above); invalid_file
/// (XML that is not well-formed, unknown or missing parameters, values out of range, undefined $parameters,
/// ids that are missing or doubled) as file:line, plug-in and parameter with what is accepted;
/// invalid_argument (an entry of `parameters` that the file never uses).
[[nodiscard]] SceneDescription read_mitsuba_scene(const std::filesystem::path& file,
                                                  const SceneParameters& parameters = {});

}  // namespace nicol
