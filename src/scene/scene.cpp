// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "geometry/largest_coordinate.hpp"
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

void check_channels(int channels, int others) {
    if (channels == 1 || others == 1 || channels == others) return;
    refuse("the material has " + std::to_string(channels) + " colour channels and the scene " +
           std::to_string(others) + "; it must have 1 or as many");
}

// Of instance `id`, which has or would have them.
void check_attributes(const Mesh& mesh, const Material& material, std::uint32_t id) {
    const SpatialVariation* variation = material.variation();
    if (variation == nullptr) return;
    const std::string instance = "instance " + std::to_string(id) + ": the material ";
    if (variation->needs_texcoords() && mesh.texcoords.empty())
        refuse(instance +
               "has textures, which need texture coordinates, and the mesh has none; give it u, v");
    if (variation->needs_colors() && mesh.colors.empty())
        refuse(instance + "has the colours of vertices, and the mesh has none; give it a colour a vertex");
}

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

}  // namespace

std::size_t Scene::index_of(std::uint32_t id) const {
    const auto found = std::ranges::lower_bound(ids_, id);
    if (found == ids_.end() || *found != id) {
        refuse(
            "there is no instance " + std::to_string(id) +
            (id < next_id_ ? "; it was removed" : "; ids below " + std::to_string(next_id_) + " were given"));
    }
    return static_cast<std::size_t>(found - ids_.begin());
}

int Scene::channels_without(std::size_t index) const {
    int most = environment_ ? environment_->channels() : 1;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        if (i != index) most = std::max(most, instances_[i].material->channels());
    }
    return most;
}

int Scene::channels() const {
    return channels_without(kNone);
}

bool Scene::varies() const {
    return std::ranges::any_of(
        instances_, [](const Instance& instance) { return instance.material->variation() != nullptr; });
}

std::uint32_t Scene::add(Instance instance) {
    if (!instance.mesh) refuse("the instance has no mesh");
    if (!instance.material) refuse("the instance has no material");
    if (next_id_ == std::numeric_limits<std::uint32_t>::max()) refuse("the scene has had too many instances");
    check_transform(instance.to_world);
    check_channels(instance.material->channels(), channels());
    check_attributes(*instance.mesh, *instance.material, next_id_);
    if (ids_.size() == ids_.capacity()) ids_.reserve(2 * ids_.size() + 1);
    instances_.push_back(std::move(instance));
    ids_.push_back(next_id_);
    geometry_version_ = new_version();
    material_version_ = new_version();
    return next_id_++;
}

void Scene::remove(std::uint32_t id) {
    const auto index = static_cast<std::ptrdiff_t>(index_of(id));
    instances_.erase(instances_.begin() + index);
    ids_.erase(ids_.begin() + index);
    geometry_version_ = new_version();
    material_version_ = new_version();
}

void Scene::set_transform(std::uint32_t id, const glm::dmat4& to_world) {
    Instance& instance = instances_[index_of(id)];
    check_transform(to_world);
    if (instance.to_world == to_world) return;
    instance.to_world = to_world;
    geometry_version_ = new_version();
}

void Scene::set_material(std::uint32_t id, MaterialPtr material) {
    const std::size_t index = index_of(id);
    if (!material) refuse("the instance would have no material");
    check_channels(material->channels(), channels_without(index));
    Instance& instance = instances_[index];
    check_attributes(*instance.mesh, *material, id);
    if (instance.material == material) return;
    if (instance.material->twosided() != material->twosided() ||
        opacity_of(*instance.material) != opacity_of(*material))
        geometry_version_ = new_version();
    material_version_ = new_version();
    instance.material = std::move(material);
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
        int materials = 1;
        for (const Instance& instance : instances_)
            materials = std::max(materials, instance.material->channels());
        if (environment->channels() != 1 && materials != 1 && environment->channels() != materials) {
            refuse("the environment has " + std::to_string(environment->channels()) +
                   " colour channels and the materials " + std::to_string(materials) +
                   "; it must have 1 or as many");
        }
    }
    if (environment_ == environment && rotation_ == rotation && scale_ == scale) return;
    environment_ = std::move(environment);
    rotation_ = rotation;
    scale_ = scale;
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
