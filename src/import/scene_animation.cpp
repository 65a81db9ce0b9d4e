// SPDX-License-Identifier: MIT
#include "import/scene_animation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "arguments.hpp"
#include "import/load_scene.hpp"

namespace nicol {

void MovingScene::set_time(double time, const LoadBudget& budget, Scene& scene, Camera& camera) {
    if (!std::isfinite(time)) refuse("time is " + std::to_string(time) + "; it must be finite");
    const SceneAnimation::Moment moment = animation_->at(time, budget);
    // Copies, so that a failure halfway changes nothing.
    Scene moved = scene;
    std::vector<MovingInstance> instances = instances_;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const SceneAnimation::Shape& shape = moment.shapes[i];
        MovingInstance& moving = instances[i];
        if (moving.absent && shape.present) {
            Instance instance = *moving.absent;
            instance.to_world = shape.to_world;
            instance.mesh = shape.mesh;
            moving.id = moved.add(std::move(instance));
            moving.absent.reset();
        }
        if (!moving.id || !std::ranges::binary_search(moved.ids(), *moving.id)) continue;
        if (!shape.present) {
            moving.absent = moved.at(*moving.id);
            moved.remove(*moving.id);
            moving.id.reset();
            continue;
        }
        moved.set_mesh(*moving.id, shape.mesh);
        moved.set_transform(*moving.id, shape.to_world);
    }
    for (std::uint32_t id = 0; id < moment.lights.size(); ++id) {
        if (!std::ranges::binary_search(moved.light_ids(), id)) continue;
        LocalLight light = moved.light(id);
        light.to_world = light_placement(moment.lights[id]);
        moved.set_light(id, std::move(light));
    }
    const Camera moved_camera = camera_of(*moment.sensor);
    scene = std::move(moved);
    instances_ = std::move(instances);
    camera = moved_camera;
}

}  // namespace nicol
