// SPDX-License-Identifier: MIT
#include "scene/load_scene.hpp"
#include "files/suffix.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <iterator>
#include <map>
#include <tuple>

#include "arguments.hpp"
#include "light/psh_file.hpp"
#include "material/conductor.hpp"
#include "material/measured.hpp"
#include "material/psh_matrix_file.hpp"
#include "scene/scene_color.hpp"
#include "scene/values.hpp"

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

/// Reads what a scene names, within a budget, and keeps a record of each file.
class Files {
public:
    Files(std::vector<FileRecord> known, const LoadLimits& limits)
        : recorder_(std::move(known)), budget_(limits) {}

    template <class Read>
    auto read(const std::filesystem::path& file, Read read) {
        return this->read(std::vector{file}, read);
    }
    template <class Read>
    auto read(const std::vector<std::filesystem::path>& files, Read read) {
        for (const std::filesystem::path& file : files) budget_.take_file(file);
        return recorder_.read(files, read);
    }

    /// Keeps a sentence, once.
    void notice(const std::string& sentence) {
        if (std::ranges::find(notices_, sentence) == notices_.end()) notices_.push_back(sentence);
    }

    [[nodiscard]] LoadBudget& budget() { return budget_; }
    [[nodiscard]] const std::vector<std::string>& notices() const { return notices_; }
    [[nodiscard]] std::vector<FileRecord> records() { return recorder_.take(); }

private:
    FileRecorder recorder_;
    LoadBudget budget_;
    std::vector<std::string> notices_;
};

EnvironmentPtr make(const EmitterDescription& d, Files& files) {
    const SceneChannels rgb;
    switch (d.kind) {
        case EmitterDescription::Kind::envmap: {
            EnvironmentPtr light =
                files.read(environment_files(d.filename), [&] { return load_environment(d.filename); });
            const std::string negative = notice_of_negative(*light, d.filename.string());
            if (!negative.empty()) files.notice(negative);
            return light;
        }
        case EmitterDescription::Kind::psh:
            return psh_environment(files.read(d.filename, [&] { return read_psh_vector(d.filename); }));
        case EmitterDescription::Kind::constant:
            return constant_environment(radiance(d.radiance, rgb));
        case EmitterDescription::Kind::sky:
            break;
    }
    return rayleigh_sky({.sun_direction = d.sun_direction,
                         .dop_max = d.dop_max,
                         .radiance = radiance(d.radiance, rgb),
                         .turbidity = d.turbidity,
                         .ground_albedo = reflectance(d.ground_albedo, rgb)});
}

/// The light says what the channels are; grey light serves any.
SceneChannels channels_under(const EnvironmentPtr& light) {
    if (!light || (light->channels() == 1 && light->wavelengths().empty())) return {};
    return {.count = light->channels(), .wavelengths = light->wavelengths()};
}

/// n - ik, one or one a channel.
std::vector<std::complex<double>> index_of(const MaterialDescription& d, const SceneChannels& channels) {
    if (!d.metal.empty()) {
        if (channels.rgb()) return metal_index(d.metal);
        if (!channels.wavelengths.empty()) return metal_index(d.metal, channels.wavelengths);
        throw Error(ErrorCode::unsupported, "a named metal under light of " + std::to_string(channels.count) +
                                                " channels without wavelengths; give grey eta and k");
    }
    const std::vector<double> eta = refractive_index(d.eta, channels);
    const std::vector<double> k = refractive_index(d.k, channels);
    std::vector<std::complex<double>> index;
    for (std::size_t c = 0; c < std::max(eta.size(), k.size()); ++c)
        index.emplace_back(eta[eta.size() == 1 ? 0 : c], -k[k.size() == 1 ? 0 : c]);
    return index;
}

MaterialPtr matrix_material(const MaterialDescription& d, const SceneChannels& channels) {
    std::vector<IsotropicMatrix> matrices = read_psh_matrix(d.filename);
    std::vector<double> scale = reflectance(d.scale, channels);
    if (std::ranges::all_of(scale, [&](double s) { return s == scale.front(); })) scale.resize(1);
    if (matrices.size() == 1) matrices.resize(scale.size(), matrices.front());
    return psh_matrix_material(std::move(matrices), scale, d.symmetrize);
}

MaterialPtr measured_material(const MaterialDescription& d, const SceneChannels& channels, Files& files) {
    MeasuredParameters parameters{.wavelengths = channels.wavelengths, .symmetrize = d.symmetrize};
    if (d.wavelength) parameters.wavelengths = {*d.wavelength};
    return load_measured(d.filename, parameters, [&](const std::string& text) { files.notice(text); });
}

MaterialPtr make_front(const MaterialDescription& d, const SceneChannels& channels, Files& files) {
    const Distribution distribution =
        d.distribution == MaterialDescription::Distribution::ggx ? Distribution::ggx : Distribution::beckmann;
    switch (d.kind) {
        case MaterialDescription::Kind::diffuse:
            return diffuse(reflectance(d.reflectance, channels));
        case MaterialDescription::Kind::pplastic:
            return pplastic({.diffuse_reflectance = reflectance(d.diffuse_reflectance, channels),
                             .specular_reflectance = reflectance(d.specular_reflectance, channels),
                             .int_ior = d.int_ior,
                             .ext_ior = d.ext_ior,
                             .alpha = d.alpha,
                             .distribution = distribution});
        case MaterialDescription::Kind::conductor:
            return conductor(index_of(d, channels), reflectance(d.specular_reflectance, channels));
        case MaterialDescription::Kind::roughconductor:
            return rough_conductor({.eta = index_of(d, channels),
                                    .specular_reflectance = reflectance(d.specular_reflectance, channels),
                                    .alpha = d.alpha,
                                    .distribution = distribution});
        case MaterialDescription::Kind::psh:
            return files.read(d.filename, [&] { return matrix_material(d, channels); });
        case MaterialDescription::Kind::measured_polarized:
            break;
    }
    return files.read(d.filename, [&] { return measured_material(d, channels, files); });
}

MaterialPtr make(const MaterialDescription& d, const SceneChannels& channels, Files& files) {
    MaterialPtr front = make_front(d, channels, files);
    return d.twosided ? twosided(std::move(front)) : front;
}

Mesh make(const ShapeDescription& d, Files& files) {
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
            mesh = files.read(d.filename, [&] {
                return load_mesh(
                    d.filename, [&](const std::string& text) { files.notice(text); }, d.index);
            });
            break;
    }
    if (d.face_normals) mesh = with_face_normals(mesh);
    if (d.flip_normals) flip_normals(mesh);
    return mesh;
}

/// Shapes of the same file and flags share a mesh.
class Meshes {
public:
    explicit Meshes(Files& files) : files_(files) {}

    std::shared_ptr<const Mesh> of(const ShapeDescription& d) {
        if (d.kind == ShapeDescription::Kind::mesh) return d.mesh;
        const Key key{d.kind,     d.filename, d.index,        d.center.x,    d.center.y,
                      d.center.z, d.radius,   d.face_normals, d.flip_normals};
        std::shared_ptr<const Mesh>& mesh = made_[key];
        if (!mesh) mesh = std::make_shared<const Mesh>(make(d, files_));
        return mesh;
    }

private:
    using Key = std::tuple<ShapeDescription::Kind, std::filesystem::path, std::size_t, double, double, double,
                           double, bool, bool>;
    Files& files_;
    std::map<Key, std::shared_ptr<const Mesh>> made_;
};

SceneDescription read_scene(const std::filesystem::path& file, const SceneParameters& parameters,
                            const LoadLimits& limits) {
    const std::string suffix = suffix_of(file);
    if (suffix == ".gltf" || suffix == ".glb") return read_gltf_scene(file, parameters, limits);
    return read_mitsuba_scene(file, parameters);
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

LoadedScene load_scene(const std::filesystem::path& file, const SceneParameters& parameters,
                       const LoadLimits& limits) {
    const SceneDescription description = read_scene(file, parameters, limits);
    Files files(description.files, limits);
    LoadedScene out;
    out.notices = description.notices;
    if (description.emitter) {
        made(file, "emitter", [&] {
            out.scene.set_environment(make(*description.emitter, files),
                                      rotation_of(description.emitter->to_world, "the emitter"),
                                      description.emitter->scale);
        });
    }
    const SceneChannels channels = channels_under(out.scene.environment());
    std::vector<MaterialPtr> materials;
    for (const MaterialDescription& material : description.materials)
        materials.push_back(
            made(file, named("bsdf", material.id), [&] { return make(material, channels, files); }));
    Meshes meshes(files);
    for (const ShapeDescription& shape : description.shapes) {
        made(file, named("shape", shape.id), [&] {
            const std::shared_ptr<const Mesh> mesh = meshes.of(shape);
            files.budget().take_instance(file, mesh->positions.size(), mesh->triangles.size());
            out.scene.add(
                {.mesh = mesh, .material = materials.at(shape.material), .to_world = shape.to_world});
        });
    }
    std::ranges::copy(files.notices(), std::back_inserter(out.notices));
    out.files = files.records();
    out.camera = make(description.sensor);
    out.width = description.sensor.width;
    out.height = description.sensor.height;
    out.luminance = description.sensor.luminance;
    return out;
}

glm::dmat3 rotation_of(const glm::dmat4& to_world, const char* what) {
    glm::dmat3 axes(to_world);
    for (int i = 0; i < 3; ++i) {
        const double length = glm::length(axes[i]);
        if (!(length > 0) || !std::isfinite(length)) {
            refuse(std::string(what) + ": to_world has an axis without length or that is not finite");
        }
        axes[i] /= length;
    }
    for (int i = 0; i < 3; ++i) {
        if (std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > 1e-5 || glm::determinant(axes) < 0) {
            refuse(std::string(what) + ": to_world must rotate without shearing or mirroring");
        }
    }
    return axes;
}

}  // namespace nicol
