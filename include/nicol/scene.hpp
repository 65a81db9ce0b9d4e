// SPDX-License-Identifier: MIT
// What is rendered: instances of meshes under one environment.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <memory>
#include <vector>

#include "nicol/environment.hpp"
#include "nicol/material.hpp"
#include "nicol/mesh.hpp"

namespace nicol {

struct Instance {
    std::shared_ptr<const Mesh> mesh;  ///< validated
    MaterialPtr material;
    glm::dmat4 to_world{1.0};
};

/// Counts its changes, so that a renderer knows what it must compute again. Not for use by two threads at
/// once.
class Scene {
public:
    /// Returns the new instance's id, counting from 0. Throws Error(invalid_argument) for null pointers, a
    /// transform that is not affine and invertible, or channels that do not fit the scene's.
    std::uint32_t add(Instance instance);
    void set_transform(std::uint32_t id, const glm::dmat4& to_world);
    /// Null is darkness. `rotation` turns the light's axes into the world's; it must be a proper rotation.
    /// `scale` multiplies the radiance and must be finite and not negative.
    void set_environment(EnvironmentPtr environment, const glm::dmat3& rotation, double scale);

    [[nodiscard]] const std::vector<Instance>& instances() const noexcept { return instances_; }
    [[nodiscard]] const EnvironmentPtr& environment() const noexcept { return environment_; }
    [[nodiscard]] const glm::dmat3& light_rotation() const noexcept { return rotation_; }
    [[nodiscard]] double light_scale() const noexcept { return scale_; }
    /// Colour channels: the largest number of any part; parts of one channel serve all.
    [[nodiscard]] int channels() const;

    [[nodiscard]] std::uint64_t geometry_revision() const noexcept { return geometry_revision_; }
    [[nodiscard]] std::uint64_t light_revision() const noexcept { return light_revision_; }

private:
    void check_channels(int channels, const char* what) const;

    std::vector<Instance> instances_;
    EnvironmentPtr environment_;
    glm::dmat3 rotation_{1.0};
    double scale_ = 1;
    std::uint64_t geometry_revision_ = 1;
    std::uint64_t light_revision_ = 1;
};

}  // namespace nicol
