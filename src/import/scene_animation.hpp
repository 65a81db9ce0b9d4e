// SPDX-License-Identifier: MIT
// Places and meshes of a scene file's things at the times of its animation.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "files/load_budget.hpp"
#include "geometry/mesh.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace nicol {

struct SensorDescription;

/// The animation of a scene file. Immutable.
class SceneAnimation {
public:
    struct Shape {
        glm::dmat4 to_world{1.0};
        bool present = true;               ///< false: there is nothing to draw
        std::shared_ptr<const Mesh> mesh;  ///< null if there is nothing to draw
    };
    /// The state at one time, in the order of SceneDescription::shapes and lights.
    struct Moment {
        std::vector<Shape> shapes;
        std::vector<glm::dmat4> lights;  ///< to_world
        std::shared_ptr<const SensorDescription> sensor;
    };

    virtual ~SceneAnimation() = default;
    /// Returns the state at a time in seconds, which must be finite. Throws as the reader of the file does.
    [[nodiscard]] virtual Moment at(double time, const LoadBudget& budget) const = 0;
};

/// An instance of a shape of the file.
struct MovingInstance {
    std::optional<std::uint32_t> id;  ///< in the scene; none: an animation leaves nothing of it to draw
    std::optional<Instance> absent;   ///< the instance then, to be added again
};

/// A loaded scene whose file has an animation.
class MovingScene {
public:
    /// instances: in the order of the animation's shapes. Lights have the ids of the file's lights.
    MovingScene(std::shared_ptr<const SceneAnimation> animation, std::vector<MovingInstance> instances)
        : animation_(std::move(animation)), instances_(std::move(instances)) {}

    /// Moves the scene's instances and lights to their places at a time, and sets the camera. Instances and
    /// lights that others have removed stay so. An instance of which nothing is left at this time is removed,
    /// and added later under another id. Throws Error(invalid_argument) for a time that is not finite, and
    /// what SceneAnimation::at() throws; the scene is then unchanged.
    void set_time(double time, const LoadBudget& budget, Scene& scene, Camera& camera);

private:
    std::shared_ptr<const SceneAnimation> animation_;
    std::vector<MovingInstance> instances_;
};

}  // namespace nicol
