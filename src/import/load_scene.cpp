// SPDX-License-Identifier: MIT
#include "import/load_scene.hpp"
#include "files/suffix.hpp"
#include "import/file_kind.hpp"
#include "import/primitive_detail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "import/elements_before_lights.hpp"
#include "import/material_maker.hpp"
#include "import/scene_color.hpp"
#include "import/scene_description.hpp"
#include "import/scene_files.hpp"
#include "import/scene_textures.hpp"
#include "import/values.hpp"
#include "light/local_light.hpp"
#include "light/psh_file.hpp"
#include "light/sun.hpp"
#include "scene/rotation.hpp"

namespace nicol {
namespace {

/// Calls make(). Its errors begin with the scene's file and the object that is made.
template <class Make>
auto made(const std::filesystem::path& file, const std::string& object, Make make) {
    try {
        return make();
    } catch (const Error& error) {
        throw Error(error.code(), file.string() + ": " + object + ": " + error.what());
    }
}

std::string named(const std::string& kind, const std::string& id) {
    return id.empty() ? kind : kind + " \"" + id + "\"";
}

RayleighSky sky_of(const EnvironmentDescription& d) {
    const SceneChannels rgb;
    return {.sun_direction = d.sun_direction,
            .dop_max = d.dop_max,
            .radiance = radiance(d.radiance, rgb),
            .turbidity = d.turbidity,
            .ground_albedo = reflectance(d.ground_albedo, rgb)};
}

/// The light says what the channels are; grey light serves any. luminance: whether the film has one channel.
SceneChannels channels_under(const EnvironmentPtr& light, bool luminance) {
    if (!light || (light->channels() == 1 && light->wavelengths().empty()))
        return {.wavelengths = {}, .one_for_grey = luminance};
    return {.count = light->channels(), .wavelengths = light->wavelengths()};
}

/// luminance: whether the film has one channel.
EnvironmentPtr make(const EnvironmentDescription& d, bool luminance, scene::SceneFiles& files) {
    switch (d.kind) {
        case EnvironmentDescription::Kind::envmap: {
            EnvironmentPtr light = files.read(environment_files(d.filename, files.budget().files()), [&] {
                return load_environment(d.filename, 1, {}, files.budget());
            });
            const std::string negative = notice_of_negative(*light, d.filename.string());
            if (!negative.empty()) files.notice(negative);
            return light;
        }
        case EnvironmentDescription::Kind::psh:
            return psh_environment(
                files.read(d.filename, [&] { return read_psh_vector(d.filename, files.budget()); }));
        case EnvironmentDescription::Kind::constant:
            return constant_environment(radiance(d.radiance, channels_under(nullptr, luminance)));
        case EnvironmentDescription::Kind::sky:
            break;
    }
    return rayleigh_sky(sky_of(d));
}

/// Returns the sun of a sky as a light.
LocalLight make_sun(const EnvironmentDescription& d) {
    LocalLight light = sun_of(sky_of(d));
    light.to_world = glm::dmat4(rotation_of(d.to_world, "the emitter")) * light.to_world;
    return light;
}

bool is_curve(const ShapeDescription& d) {
    return d.kind == ShapeDescription::Kind::linear_curve || d.kind == ShapeDescription::Kind::bspline_curve;
}

/// Returns what the points of a mesh are moved by before placement(). The transform of curves moves their
/// points, not their radii.
glm::dmat3 axes_of(const ShapeDescription& d) {
    return is_curve(d) ? glm::dmat3(d.to_world) : glm::dmat3(1);
}

Mesh make(const ShapeDescription& d, double detail, const MeshColorNames& colors, scene::SceneFiles& files) {
    Mesh mesh;
    switch (d.kind) {
        case ShapeDescription::Kind::sphere:
            mesh = make_sphere(glm::dvec3(0.0), d.radius, detail);
            break;
        case ShapeDescription::Kind::rectangle:
            mesh = make_rectangle();
            break;
        case ShapeDescription::Kind::cube:
            mesh = make_cube();
            break;
        case ShapeDescription::Kind::disk:
            mesh = make_disk(detail);
            break;
        case ShapeDescription::Kind::cylinder:
            mesh = make_cylinder(glm::dvec3(0.0), d.p1 - d.p0, d.radius, detail);
            break;
        case ShapeDescription::Kind::linear_curve:
        case ShapeDescription::Kind::bspline_curve: {
            const bool linear = d.kind == ShapeDescription::Kind::linear_curve;
            mesh = files.read(d.filename, [&] {
                return load_curves(d.filename, linear ? CurveKind::linear : CurveKind::bspline, axes_of(d),
                                   files.budget());
            });
            break;
        }
        case ShapeDescription::Kind::sdf_grid:
            mesh = files.read(d.filename,
                              [&] { return load_sdf_grid(d.filename, d.sdf_normals, files.budget()); });
            break;
        default:
            mesh = files.read(d.filename, [&] {
                return load_mesh(
                    d.filename, [&](const std::string& text) { files.notice(text); }, d.index, files.budget(),
                    colors);
            });
            break;
    }
    if (d.face_normals) mesh = with_face_normals(mesh);
    if (d.flip_normals) flip_normals(mesh);
    if (d.flip_tex_coords) flip_texcoords(mesh);
    return mesh;
}

/// Returns the transform of the mesh of make(). A mesh's coordinates have single precision, so that the
/// position of a primitive belongs into the transform.
glm::dmat4 placement(const ShapeDescription& d) {
    switch (d.kind) {
        case ShapeDescription::Kind::sphere:
            return glm::translate(d.to_world, d.center);
        case ShapeDescription::Kind::cylinder:
            return glm::translate(d.to_world, d.p0);
        case ShapeDescription::Kind::linear_curve:
        case ShapeDescription::Kind::bspline_curve:
            return glm::translate(glm::dmat4(1), glm::dvec3(d.to_world[3]));
        default:
            return d.to_world;
    }
}

/// make_light() and make_emission() throw what reading textures throws, and Error(unsupported) for colours
/// that the scene's channels cannot have.
LocalLight make_light(const LightDescription& d, const SceneChannels& channels,
                      scene::SceneTextures& textures) {
    LocalLight light = d.parameters;
    light.value = radiance(d.value, channels);
    for (double& value : light.value) value *= d.scale;
    light.to_world = light_placement(light.to_world);
    if (d.texture) {
        light.texture = textures.color(*d.texture);
        light.aspect = textures.aspect(*d.texture);
    }
    light.fov = glm::radians(horizontal_fov(d.fov, d.fov_axis, light.aspect));
    return light;
}

EmissionPtr make_emission(const EmissionDescription& d, const SceneChannels& channels,
                          scene::SceneTextures& textures) {
    Emission emission;
    emission.radiance = d.radiance.texture ? std::vector<double>{1} : radiance(d.radiance, channels);
    for (double& value : emission.radiance) value *= d.scale;
    if (d.radiance.texture) emission.texture = textures.color(*d.radiance.texture);
    emission.two_sided = d.two_sided;
    emission.state = d.state;
    return std::make_shared<const Emission>(std::move(emission));
}

using NeededAttributes = std::set<scene::SceneTextures::NeededAttribute>;

/// Returns the attributes that become a mesh's colours. Throws Error(unsupported) if there are two of
/// vertices or two of faces.
MeshColorNames color_names(const NeededAttributes& needed) {
    MeshColorNames out;
    std::map<ColorsOf, std::string> known;
    for (const auto& [of, name, number] : needed) {
        if (known.try_emplace(of, name).first->second != name)
            throw Error(ErrorCode::unsupported, "its material has the attributes " + known[of] + " and " +
                                                    name + " of the mesh; give it one of them");
        (of == ColorsOf::faces ? out.faces : out.vertices) = name;
    }
    return out;
}

/// Throws Error(invalid_argument) if a mesh lacks an attribute or has three numbers instead of one.
void check_attributes(const Mesh& mesh, const NeededAttributes& needed) {
    for (const auto& [of, name, number] : needed) {
        const std::vector<glm::vec3>& values = of == ColorsOf::faces ? mesh.face_colors : mesh.colors;
        const std::string_view prefix = of == ColorsOf::faces ? kFacePrefix : kVertexPrefix;
        const std::string attribute = "attribute " + std::string(prefix) + name;
        if (values.empty()) refuse("it has no " + attribute + ", which its material needs");
        if (number && std::ranges::any_of(values, [](const glm::vec3& v) { return v != glm::vec3(v.x); }))
            refuse("its " + attribute + " has three numbers where its material needs one");
    }
}

/// Shapes of the same file or detail, of the same flags and attributes, share a mesh.
class Meshes {
public:
    Meshes(const PrimitiveDetail& detail, scene::SceneFiles& files) : detail_(detail), files_(files) {}

    std::shared_ptr<const Mesh> of(const ShapeDescription& d, const MeshColorNames& colors) {
        if (d.kind == ShapeDescription::Kind::mesh) return d.mesh;
        const double detail = d.segments > 0 ? d.segments / double(kSphereSegments) : detail_.of(d);
        const glm::dmat3 axes = axes_of(d);
        std::array<double, 9> numbers{};
        std::copy_n(&axes[0].x, numbers.size(), numbers.begin());
        const Key key{d.kind,
                      numbers,
                      d.filename,
                      d.index,
                      {d.p1.x - d.p0.x, d.p1.y - d.p0.y, d.p1.z - d.p0.z, d.radius, detail},
                      d.sdf_normals,
                      d.face_normals,
                      d.flip_normals,
                      d.flip_tex_coords,
                      colors};
        std::shared_ptr<const Mesh>& mesh = made_[key];
        if (!mesh) mesh = std::make_shared<const Mesh>(make(d, detail, colors, files_));
        return mesh;
    }

private:
    using Key = std::tuple<ShapeDescription::Kind, std::array<double, 9>, std::filesystem::path, std::size_t,
                           std::array<double, 5>, SdfNormals, bool, bool, bool, MeshColorNames>;
    PrimitiveDetail detail_;
    scene::SceneFiles& files_;
    std::map<Key, std::shared_ptr<const Mesh>> made_;
};

SceneDescription read_scene(const std::filesystem::path& file, const SceneParameters& parameters,
                            const LoadBudget& budget) {
    const std::string other = scene::kind_of_other_file(file, budget.files());
    if (!other.empty())
        throw Error(ErrorCode::invalid_file, file.string() + ": " + other +
                                                 "; a scene is a Mitsuba 3 XML file, a .gltf or a .glb file");
    const std::string suffix = suffix_of(file);
    if (suffix == ".gltf" || suffix == ".glb") return read_gltf_scene(file, parameters, budget);
    return read_mitsuba_scene(file, parameters, budget);
}

}  // namespace

Camera camera_of(const SensorDescription& d) {
    Camera camera;
    camera.orthographic = d.kind == SensorDescription::Kind::orthographic;
    camera.to_world = d.to_world;
    if (!camera.orthographic) camera.fov = horizontal_fov(d);
    camera.shift = d.principal_point_offset;
    if (d.crop) {
        // The pixels of a crop look where they do in the film.
        const glm::dvec2 film(d.width, d.height);
        const glm::dvec2 size(d.crop->size);
        const double part = size.x / film.x;
        camera.to_world[0] *= camera.orthographic ? part : 1;
        camera.to_world[1] *= camera.orthographic ? part : 1;
        camera.fov = glm::degrees(2 * std::atan(part * std::tan(glm::radians(camera.fov / 2))));
        camera.shift = (camera.shift * film + glm::dvec2(d.crop->offset) + 0.5 * (size - film)) / size;
    }
    camera.near_clip = d.near_clip;
    camera.far_clip = d.far_clip;
    return camera;
}

glm::dmat4 light_placement(const glm::dmat4& to_world) {
    glm::dmat4 out(rotation_of(to_world, "a light"));
    out[3] = to_world[3];
    return out;
}

LoadedScene load_scene(const std::filesystem::path& file, const SceneParameters& parameters,
                       const LoadBudget& budget) {
    const SceneDescription description = read_scene(file, parameters, budget);
    scene::SceneFiles files(description.files, budget);
    LoadedScene out;
    out.notices = description.notices;
    if (description.environment) {
        made(file, "emitter", [&] {
            out.scene.set_environment(make(*description.environment, description.sensor.luminance, files),
                                      rotation_of(description.environment->to_world, "the emitter"),
                                      description.environment->scale);
        });
    }
    out.scene.hide_emitters(description.integrator.hide_emitters);
    const SceneChannels channels = channels_under(out.scene.environment(), description.sensor.luminance);
    scene::SceneTextures textures(channels, files);
    const MaterialMaker maker{channels, textures, files};
    struct MadeMaterial {
        MaterialPtr material;
        NeededAttributes needed;
    };
    const auto make_material = [&](const MaterialDescription& material) {
        return made(file, named("bsdf", material.id), [&] {
            MaterialPtr out = maker.make(material);
            return MadeMaterial{std::move(out), textures.take_needed()};
        });
    };
    std::vector<MadeMaterial> materials;
    for (const MaterialDescription& material : description.materials)
        materials.push_back(make_material(material));
    for (const LightDescription& light : description.lights) {
        budget.step(256);
        made(file, named("emitter", light.id),
             [&] { return out.scene.add_light(make_light(light, channels, textures)); });
    }
    // After the file's lights, whose ids count up from 0.
    if (description.environment && description.environment->sun)
        made(file, "emitter", [&] { out.scene.add_light(make_sun(*description.environment)); });
    out.camera = camera_of(description.sensor);
    const SensorDescription& sensor = description.sensor;
    out.width = sensor.crop ? sensor.crop->size.x : sensor.width;
    out.height = sensor.crop ? sensor.crop->size.y : sensor.height;
    Meshes meshes(PrimitiveDetail(out.camera, {out.width, out.height}), files);
    std::vector<MovingInstance> instances;
    for (const ShapeDescription& shape : description.shapes) {
        made(file, named("shape", shape.id), [&] {
            textures.set_attributes(&shape.attributes);
            MadeMaterial surface = shape.attributes.empty()
                                       ? materials.at(shape.material)
                                       : make_material(description.materials.at(shape.material));
            const EmissionPtr emission =
                shape.emission ? make_emission(*shape.emission, channels, textures) : nullptr;
            textures.set_attributes(nullptr);
            surface.needed.merge(textures.take_needed());
            const std::shared_ptr<const Mesh> mesh = meshes.of(shape, color_names(surface.needed));
            if (mesh) {  // nothing may be left of a mesh that deforms
                check_attributes(*mesh, surface.needed);
                budget.take_instance(file, mesh->positions.size(), mesh->triangles.size());
            }
            if (surface.material->anisotropic() && mesh && mesh->texcoords.empty())
                files.notice(
                    "a surface without texture coordinates has a roughness that depends on the direction, "
                    "which "
                    "is any then");
            Instance instance{.mesh = mesh,
                              .material = surface.material,
                              .to_world = placement(shape),
                              .emission = emission};
            MovingInstance& moving = instances.emplace_back();
            if (shape.present)
                moving.id = out.scene.add(std::move(instance));
            else
                moving.absent = std::move(instance);
        });
    }
    for (const ElementDescription& element : description.elements)
        made(file, "shape", [&] {
            ElementTextures of_element;
            if (element.angle_texture) {
                of_element.angle = textures.number_of_color(*element.angle_texture);
                if (textures.colored(*element.angle_texture))
                    files.notice(element.where +
                                 ": theta has colours, which have one angle here, that of their luminance.");
            }
            if (element.retardance_texture)
                of_element.retardance = textures.color(*element.retardance_texture);
            return out.scene.add_element(SceneElement(element, of_element));
        });
    scene::put_elements_before_lights(description, out.scene, files);
    std::ranges::copy(files.notices(), std::back_inserter(out.notices));
    if (description.animation) out.animation.emplace(description.animation, std::move(instances));
    out.files = files.records();
    out.luminance = sensor.luminance;
    out.sample_count = sensor.sample_count;
    out.filter = sensor.filter;
    out.max_depth = description.integrator.max_depth;
    out.aovs = description.integrator.aovs;
    return out;
}

}  // namespace nicol
