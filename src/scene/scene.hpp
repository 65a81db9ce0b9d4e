// SPDX-License-Identifier: MIT
// Scenes: instances of meshes, an environment, local lights and polarization elements.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "geometry/mesh.hpp"
#include "light/environment.hpp"
#include "light/local_light.hpp"
#include "material/material.hpp"
#include "scene/scene_element.hpp"
#include "versioned.hpp"

namespace nicol {

/// Number of parts of a scene for each number of colour channels.
class ChannelCounts {
public:
    /// Allocates the memory that add() needs, so that a change to a scene happens as a whole or not at all.
    void make_room(int channels) { parts_.reserve(static_cast<std::size_t>(channels) + 1); }
    void add(int channels) {
        const auto at = static_cast<std::size_t>(channels);
        if (at >= parts_.size()) parts_.resize(at + 1);
        ++parts_[at];
    }
    /// Removes a part that was added with this number of channels.
    void remove(int channels) {
        --parts_[static_cast<std::size_t>(channels)];
        while (!parts_.empty() && parts_.back() == 0) parts_.pop_back();
    }

    /// Returns the largest number of channels; 1 if there are no parts.
    [[nodiscard]] int largest() const { return parts_.empty() ? 1 : static_cast<int>(parts_.size()) - 1; }
    /// Returns the largest number of channels without one part that has `channels` of them.
    [[nodiscard]] int largest_without(int channels) const {
        int most = largest();
        if (most != channels || parts_.back() > 1) return most;
        while (--most > 1 && parts_[static_cast<std::size_t>(most)] == 0) continue;
        return most < 1 ? 1 : most;
    }

private:
    std::vector<std::size_t> parts_;  // indexed by number of channels; the last is not 0
};

/// Parts of a scene that are identified by ids. Ids count up from 0 and are never given twice.
template <class T>
class Numbered {
public:
    /// `what`: singular noun for messages; the text must outlive the object.
    explicit Numbered(const char* what) : what_(what) {}

    [[nodiscard]] const std::vector<T>& values() const noexcept { return values_; }
    /// Returns the ids of values(), ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& ids() const noexcept { return ids_; }

    /// Returns the id of the next add(). Throws Error(invalid_argument) if no ids are left.
    [[nodiscard]] std::uint32_t next() const {
        if (next_ == std::numeric_limits<std::uint32_t>::max())
            refuse("the scene has had too many " + std::string(what_) + "s");
        return next_;
    }

    /// Returns the index in values(). Throws Error(invalid_argument) if no part has this id.
    [[nodiscard]] std::size_t index_of(std::uint32_t id) const {
        const auto found = std::ranges::lower_bound(ids_, id);
        if (found == ids_.end() || *found != id)
            refuse(
                "there is no " + std::string(what_) + " " + std::to_string(id) +
                (id < next_ ? "; it was removed" : "; ids below " + std::to_string(next_) + " were given"));
        return static_cast<std::size_t>(found - ids_.begin());
    }
    [[nodiscard]] const T& at(std::uint32_t id) const { return values_[index_of(id)]; }
    [[nodiscard]] T& operator[](std::size_t index) { return values_[index]; }

    std::uint32_t add(T value) {
        const std::uint32_t id = next();
        if (ids_.size() == ids_.capacity()) ids_.reserve(2 * ids_.size() + 1);
        values_.push_back(std::move(value));
        ids_.push_back(id);
        ++next_;
        return id;
    }
    void remove(std::uint32_t id) {
        const auto index = static_cast<std::ptrdiff_t>(index_of(id));
        values_.erase(values_.begin() + index);
        ids_.erase(ids_.begin() + index);
    }

private:
    const char* what_;
    std::vector<T> values_;
    std::vector<std::uint32_t> ids_;
    std::uint32_t next_ = 0;
};

/// Roles of an instance.
struct InstanceRoles {
    bool casts_shadows = true;     ///< false: no surface receives less or more light because of the instance
    bool receives_shadows = true;  ///< false: nothing hides lights from it, not even itself
    bool visible = true;           ///< false: the camera does not see it, nor in mirrors and through glass

    bool operator==(const InstanceRoles&) const = default;
};

struct Instance {
    std::shared_ptr<const Mesh> mesh;  ///< validated
    MaterialPtr material;
    glm::dmat4 to_world{1.0};
    EmissionPtr emission = nullptr;  ///< null: no emission
    InstanceRoles roles{};
};

/// Scene with a version of each state, so that a renderer can decide what to compute again. Not for
/// concurrent use by several threads.
class Scene {
public:
    /// Returns the new instance's id. Ids count up from 0 and are never given twice. Throws
    /// Error(invalid_argument) for null pointers, a transform that is not affine and invertible, channels
    /// that do not fit the scene's, or a mesh without the texture coordinates or colours that its material
    /// needs.
    std::uint32_t add(Instance instance);
    /// Functions that change an instance. They throw Error(invalid_argument) for ids of no instance, and what
    /// add() throws.
    void remove(std::uint32_t id);
    void set_transform(std::uint32_t id, const glm::dmat4& to_world);
    void set_mesh(std::uint32_t id, std::shared_ptr<const Mesh> mesh);
    void set_material(std::uint32_t id, MaterialPtr material);
    void set_roles(std::uint32_t id, const InstanceRoles& roles);
    /// Sets the emission of an instance. Null: no emission.
    void set_emission(std::uint32_t id, EmissionPtr emission);
    [[nodiscard]] const Instance& at(std::uint32_t id) const { return instances_.at(id); }

    /// Local lights, whose ids count up from 0 independently of instances. The functions throw what check()
    /// throws, and Error(invalid_argument) for unknown ids and for channels that do not fit the scene's.
    std::uint32_t add_light(LocalLight light);
    void remove_light(std::uint32_t id);
    void set_light(std::uint32_t id, LocalLight light);
    [[nodiscard]] const LocalLight& light(std::uint32_t id) const { return lights_.at(id); }
    [[nodiscard]] const std::vector<LocalLight>& lights() const noexcept { return lights_.values(); }
    /// Returns the ids of lights(), ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& light_ids() const noexcept { return lights_.ids(); }
    /// Returns whether there are local lights or instances with emission.
    [[nodiscard]] bool has_local_lights() const;

    /// Polarization elements, through which the camera sees the surfaces behind them. Elements cast no
    /// shadow, and light that surfaces receive does not pass through them. The functions throw what check()
    /// throws, and Error(invalid_argument) for unknown ids, for a transform that is not affine and
    /// invertible, for textures with colours of a mesh or that make a number too large, and for channels of a
    /// retardance that do not fit the scene's.
    std::uint32_t add_element(SceneElement element);
    void remove_element(std::uint32_t id);
    void set_element(std::uint32_t id, SceneElement element);
    [[nodiscard]] const SceneElement& element(std::uint32_t id) const { return elements_.at(id); }
    [[nodiscard]] const std::vector<SceneElement>& elements() const noexcept { return elements_.values(); }
    /// Returns the ids of elements(), ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& element_ids() const noexcept { return elements_.ids(); }

    /// Sets the environment. Null is darkness. `rotation` transforms from the light's axes to the world's and
    /// must be a proper rotation. `scale` multiplies the radiance and must be finite and not negative.
    void set_environment(EnvironmentPtr environment, const glm::dmat3& rotation, double scale);

    /// Sets whether light that goes straight from the environment or an emissive surface to the camera is
    /// hidden.
    void hide_emitters(bool hide);
    [[nodiscard]] bool emitters_hidden() const noexcept { return emitters_hidden_; }

    [[nodiscard]] const std::vector<Instance>& instances() const noexcept { return instances_.values(); }
    /// Returns the ids of instances(), ascending.
    [[nodiscard]] const std::vector<std::uint32_t>& ids() const noexcept { return instances_.ids(); }
    [[nodiscard]] const EnvironmentPtr& environment() const noexcept { return environment_; }
    /// Returns the environment if it gives light, or null if it is dark or its scale is 0.
    [[nodiscard]] const EnvironmentPtr& distant_light() const noexcept { return distant_light_; }
    /// Returns the distant light behind the instances, or null if emitters are hidden.
    [[nodiscard]] EnvironmentPtr background() const { return emitters_hidden_ ? nullptr : distant_light_; }
    [[nodiscard]] const glm::dmat3& light_rotation() const noexcept { return rotation_; }
    [[nodiscard]] double light_scale() const noexcept { return scale_; }
    /// Returns the number of colour channels: the largest number of any part. Parts of one channel apply to
    /// all channels.
    [[nodiscard]] int channels() const { return channels_.largest(); }
    /// Returns whether a material or an emission varies over its surface.
    [[nodiscard]] bool varies() const;
    /// Returns whether light passes a material, see Material::smooth_boundary().
    [[nodiscard]] bool transmits() const;

    /// Returns the version of the triangles' positions, of the sides that reflect, of alpha masks, of what
    /// light passes, and of the instances' roles.
    [[nodiscard]] Version geometry_version() const noexcept { return geometry_version_; }
    /// Returns the version of the materials and their assignment to instances.
    [[nodiscard]] Version material_version() const noexcept { return material_version_; }
    /// Returns the version of the environment, its rotation and scale.
    [[nodiscard]] Version light_version() const noexcept { return light_version_; }
    /// Returns the version of the instances' emission and of its visibility to the camera.
    [[nodiscard]] Version emission_version() const noexcept { return emission_version_; }
    /// Returns the version of lights().
    [[nodiscard]] Version local_light_version() const noexcept { return local_light_version_; }
    /// Returns the version of elements().
    [[nodiscard]] Version element_version() const noexcept { return element_version_; }

private:
    ChannelCounts channels_;
    Numbered<Instance> instances_{"instance"};
    Numbered<LocalLight> lights_{"light"};
    Numbered<SceneElement> elements_{"element"};
    EnvironmentPtr environment_;
    EnvironmentPtr distant_light_;
    glm::dmat3 rotation_{1.0};
    double scale_ = 1;
    bool emitters_hidden_ = false;
    Version geometry_version_ = new_version();
    Version material_version_ = new_version();
    Version light_version_ = new_version();
    Version emission_version_ = new_version();
    Version local_light_version_ = new_version();
    Version element_version_ = new_version();
};

/// Returns the mesh of an instance in world coordinates. Throws what transformed() throws, and
/// Error(invalid_argument) for coordinates beyond kLargestCoordinate. The message names the instance.
[[nodiscard]] Mesh placed(const Mesh& mesh, const glm::dmat4& to_world, std::uint32_t instance);

}  // namespace nicol
