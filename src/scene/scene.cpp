// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "geometry/largest_coordinate.hpp"
#include "material/dielectric.hpp"
#include "material/spatial_variation.hpp"

namespace nicol {
namespace {

void check_transform(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(m[column][row])) refuse("to_world has an element that is not finite");
        }
    }
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) {
        refuse("the last row of to_world must be 0 0 0 1");
    }
    const double determinant = glm::determinant(glm::dmat3(m));
    if (!std::isfinite(determinant) || determinant == 0) refuse("to_world cannot be inverted");
}

// Returns the size of the largest number of a texture without colours of a mesh.
double largest_of(const Texture& texture) {
    const glm::vec2 first = glm::abs(texture.range());
    float largest = std::max(first.x, first.y);
    if (texture.channels() == 1) return static_cast<double>(largest);
    const TextureDescription description = texture.describe();
    const auto take = [&](float value) { largest = std::max(largest, std::abs(value)); };
    for (const glm::vec4& color : description.colors) {
        take(color.x);
        take(color.y);
        take(color.z);
    }
    if (!description.levels.empty()) std::ranges::for_each(description.levels.front().values, take);
    return static_cast<double>(largest);
}

void check_element(const SceneElement& element) {
    check(element);
    check_transform(element.to_world);
    const ElementTextures& textures = element.textures;
    const auto check_texture = [](const TexturePtr& texture, const char* name) {
        if (texture != nullptr &&
            (needs_colors(*texture) || texture->describe().kind == TextureDescription::Kind::product))
            refuse(std::string(name) + " of an element has the colours of a mesh; give an image");
    };
    check_texture(textures.angle, "the texture of the angle");
    check_texture(textures.retardance, "the texture of the retardance");
    if (textures.retardance != nullptr && textures.retardance->channels() == 4)
        refuse("the texture of the retardance of an element has 4 channels; it must have 1 or 3");
    const auto check_product = [](double number, const TexturePtr& texture, const char* name) {
        if (texture != nullptr) check_element_angle(number * largest_of(*texture), name);
    };
    check_product(element.angle, textures.angle, "the angle of an element times its texture");
    check_product(element.retardance, textures.retardance, "the retardance of an element times its texture");
}

void check_channels(const char* part, int channels, int others) {
    if (channels == 1 || others == 1 || channels == others) return;
    refuse("the " + std::string(part) + " has " + std::to_string(channels) +
           " colour channels and the scene " + std::to_string(others) + "; it must have 1 or as many");
}

// Adds a part whose channels count. Throws Error(invalid_argument) if they do not fit those of other parts.
template <class Part>
void add_counted(const char* name, Part part, Numbered<Part>& to, ChannelCounts& counts) {
    const int channels = part.channels();
    check_channels(name, channels, counts.largest());
    counts.make_room(channels);
    to.add(std::move(part));
    counts.add(channels);
}

// Changes such a part, and returns whether it differed.
template <class Part>
bool set_counted(const char* name, Part part, Part& changed, ChannelCounts& counts) {
    const int before = changed.channels(), channels = part.channels();
    check_channels(name, channels, counts.largest_without(before));
    if (changed == part) return false;
    counts.make_room(channels);
    counts.add(channels);
    counts.remove(before);
    changed = std::move(part);
    return true;
}

// Throws Error(invalid_argument) if the mesh lacks attributes that the material or the emission, which may be
// null, needs. `id` is the instance that has or would have them.
void check_attributes(const Mesh& mesh, const Material& material, const Emission* emission,
                      std::uint32_t id) {
    const SpatialVariation* const variation = material.variation();
    const Texture* const radiance = emission != nullptr ? emission->texture.get() : nullptr;
    const std::string instance = "instance " + std::to_string(id) + ": ";
    if (mesh.texcoords.empty()) {
        if (variation != nullptr && variation->needs_texcoords())
            refuse(instance +
                   "the material has textures, which need texture coordinates, and the mesh has "
                   "none; give it u, v");
        if (radiance != nullptr && radiance->needs_texcoords())
            refuse(instance +
                   "its radiance has a texture, which needs texture coordinates, and the mesh has "
                   "none; give it u, v");
    }
    const auto need = [&](ColorsOf of) { return needs_colors(material, of) || needs_colors(emission, of); };
    const bool of_vertices = need(ColorsOf::vertices);
    const bool of_faces = need(ColorsOf::faces);
    const std::string with_colors = instance + "the material or the radiance has the colours of ";
    if (of_vertices && of_faces) refuse(with_colors + "vertices and those of faces; give it one of them");
    if (of_vertices && mesh.colors.empty())
        refuse(with_colors + "vertices, and the mesh has none; give it a colour a vertex");
    if (of_faces && mesh.face_colors.empty())
        refuse(with_colors + "faces, and the mesh has none; give it a colour a triangle");
    if (radiance == nullptr || !needs_colors(*radiance)) return;
    for (const glm::vec3& color : of_faces ? mesh.face_colors : mesh.colors)
        if (std::min({color.x, color.y, color.z}) < 0)
            refuse(instance + "its radiance has the colours of the mesh, and one of them is below 0");
}

}  // namespace

bool Scene::varies() const {
    return std::ranges::any_of(instances(), [](const Instance& instance) {
        return instance.material->variation() != nullptr ||
               (instance.emission != nullptr && instance.emission->texture != nullptr);
    });
}

bool Scene::transmits() const {
    return std::ranges::any_of(instances(), [](const Instance& instance) {
        return instance.material->smooth_boundary() != nullptr;
    });
}

std::uint32_t Scene::add(Instance instance) {
    if (!instance.mesh) refuse("the instance has no mesh");
    if (!instance.material) refuse("the instance has no material");
    const std::uint32_t id = instances_.next();
    check_transform(instance.to_world);
    check_channels("material", instance.material->channels(), channels());
    if (instance.emission) check(*instance.emission);
    check_attributes(*instance.mesh, *instance.material, instance.emission.get(), id);
    if (instance.emission) {
        check_channels("emission", instance.emission->channels(),
                       std::max(channels(), instance.material->channels()));
        emission_version_ = new_version();
    }
    const int of_material = instance.material->channels();
    const int of_emission = instance.emission ? instance.emission->channels() : 0;
    channels_.make_room(std::max(of_material, of_emission));
    instances_.add(std::move(instance));
    channels_.add(of_material);
    if (of_emission > 0) channels_.add(of_emission);
    geometry_version_ = new_version();
    material_version_ = new_version();
    return id;
}

void Scene::remove(std::uint32_t id) {
    const Instance& instance = at(id);
    channels_.remove(instance.material->channels());
    if (instance.emission) {
        channels_.remove(instance.emission->channels());
        emission_version_ = new_version();
    }
    instances_.remove(id);
    geometry_version_ = new_version();
    material_version_ = new_version();
}

void Scene::set_transform(std::uint32_t id, const glm::dmat4& to_world) {
    Instance& instance = instances_[instances_.index_of(id)];
    check_transform(to_world);
    if (instance.to_world == to_world) return;
    instance.to_world = to_world;
    geometry_version_ = new_version();
}

void Scene::set_mesh(std::uint32_t id, std::shared_ptr<const Mesh> mesh) {
    Instance& instance = instances_[instances_.index_of(id)];
    if (!mesh) refuse("the instance would have no mesh");
    check_attributes(*mesh, *instance.material, instance.emission.get(), id);
    if (instance.mesh == mesh) return;
    instance.mesh = std::move(mesh);
    geometry_version_ = new_version();
}

void Scene::set_material(std::uint32_t id, MaterialPtr material) {
    const std::size_t index = instances_.index_of(id);
    if (!material) refuse("the instance would have no material");
    Instance& instance = instances_[index];
    check_channels("material", material->channels(),
                   channels_.largest_without(instance.material->channels()));
    check_attributes(*instance.mesh, *material, instance.emission.get(), id);
    if (instance.material == material) return;
    channels_.make_room(material->channels());
    if (instance.material->twosided() != material->twosided() ||
        glass_key(*instance.material) != glass_key(*material) ||
        alpha_mask_of(*instance.material) != alpha_mask_of(*material))
        geometry_version_ = new_version();
    material_version_ = new_version();
    channels_.add(material->channels());
    channels_.remove(instance.material->channels());
    instance.material = std::move(material);
}

void Scene::set_emission(std::uint32_t id, EmissionPtr emission) {
    const std::size_t index = instances_.index_of(id);
    Instance& instance = instances_[index];
    if (emission) {
        check(*emission);
        check_attributes(*instance.mesh, *instance.material, emission.get(), id);
        check_channels("emission", emission->channels(),
                       instance.emission ? channels_.largest_without(instance.emission->channels())
                                         : channels_.largest());
    }
    if (instance.emission == emission || (instance.emission && emission && *instance.emission == *emission))
        return;
    if (emission) {
        channels_.make_room(emission->channels());
        channels_.add(emission->channels());
    }
    if (instance.emission) channels_.remove(instance.emission->channels());
    instance.emission = std::move(emission);
    emission_version_ = new_version();
}

void Scene::set_roles(std::uint32_t id, const InstanceRoles& roles) {
    Instance& instance = instances_[instances_.index_of(id)];
    if (instance.roles == roles) return;
    instance.roles = roles;
    geometry_version_ = new_version();
}

std::uint32_t Scene::add_light(LocalLight light) {
    const std::uint32_t id = lights_.next();
    check(light);
    add_counted("light", std::move(light), lights_, channels_);
    local_light_version_ = new_version();
    return id;
}

void Scene::remove_light(std::uint32_t id) {
    channels_.remove(light(id).channels());
    lights_.remove(id);
    local_light_version_ = new_version();
}

void Scene::set_light(std::uint32_t id, LocalLight light) {
    LocalLight& changed = lights_[lights_.index_of(id)];
    check(light);
    if (set_counted("light", std::move(light), changed, channels_)) local_light_version_ = new_version();
}

bool Scene::has_local_lights() const {
    return !lights().empty() || std::ranges::any_of(instances(), [](const Instance& instance) {
        return instance.emission != nullptr;
    });
}

void Scene::hide_emitters(bool hide) {
    if (hide == emitters_hidden_) return;
    emitters_hidden_ = hide;
    emission_version_ = new_version();
}

std::uint32_t Scene::add_element(SceneElement element) {
    const std::uint32_t id = elements_.next();
    check_element(element);
    add_counted("element", std::move(element), elements_, channels_);
    element_version_ = new_version();
    return id;
}

void Scene::remove_element(std::uint32_t id) {
    channels_.remove(element(id).channels());
    elements_.remove(id);
    element_version_ = new_version();
}

void Scene::set_element(std::uint32_t id, SceneElement element) {
    SceneElement& changed = elements_[elements_.index_of(id)];
    check_element(element);
    if (set_counted("element", std::move(element), changed, channels_)) element_version_ = new_version();
}

void Scene::set_environment(EnvironmentPtr environment, const glm::dmat3& rotation, double scale) {
    if (!(scale >= 0) || !std::isfinite(scale)) {
        refuse("the scale of the environment is " + std::to_string(scale) +
               "; it must be finite and not negative");
    }
    const glm::dmat3 product = glm::transpose(rotation) * rotation;
    double deviation = 0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            deviation = std::fmax(deviation, std::abs(product[column][row] - (column == row ? 1 : 0)));
        }
    }
    if (!(deviation < 1e-5) || glm::determinant(rotation) < 0) {
        refuse(
            "the environment can only be rotated: its to_world must be a rotation without scale or "
            "mirroring");
    }
    if (environment) {
        const int others = environment_ ? channels_.largest_without(environment_->channels()) : channels();
        if (environment->channels() != 1 && others != 1 && environment->channels() != others) {
            refuse("the environment has " + std::to_string(environment->channels()) +
                   " colour channels and the scene " + std::to_string(others) +
                   "; it must have 1 or as many");
        }
    }
    if (environment_ == environment && rotation_ == rotation && scale_ == scale) return;
    if (environment) {
        channels_.make_room(environment->channels());
        channels_.add(environment->channels());
    }
    if (environment_) channels_.remove(environment_->channels());
    environment_ = std::move(environment);
    rotation_ = rotation;
    scale_ = scale;
    distant_light_ = environment_ && scale_ != 0 && !environment_->dark() ? environment_ : nullptr;
    light_version_ = new_version();
}

Mesh placed(const Mesh& mesh, const glm::dmat4& to_world, std::uint32_t instance) {
    try {
        Mesh out = transformed(mesh, to_world);
        for (std::size_t v = 0; v < out.positions.size(); ++v)
            for (glm::length_t i = 0; i < 3; ++i)
                if (std::abs(out.positions[v][i]) > kLargestCoordinate)
                    refuse("vertex " + std::to_string(v) + " (0-based) lies beyond 1e15 in the world");
        return out;
    } catch (const Error& error) {
        throw Error(error.code(), "instance " + std::to_string(instance) + ": " + error.what());
    }
}

}  // namespace nicol
