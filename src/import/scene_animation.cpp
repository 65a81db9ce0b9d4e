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
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        const SceneAnimation::Shape& shape = moment.shapes[i];
        MovingInstance& moving = instances_[i];
        if (moving.absent && shape.present) {
            Instance instance = *moving.absent;
            instance.to_world = shape.to_world;
            if (shape.mesh) instance.mesh = shape.mesh;
            moving.id = scene.add(std::move(instance));
            moving.absent.reset();
        }
        if (!moving.id || !std::ranges::binary_search(scene.ids(), *moving.id)) continue;
        if (!shape.present) {
            moving.absent = scene.at(*moving.id);
            scene.remove(*moving.id);
            moving.id.reset();
            continue;
        }
        if (shape.mesh) scene.set_mesh(*moving.id, shape.mesh);
        scene.set_transform(*moving.id, shape.to_world);
    }
    for (std::uint32_t id = 0; id < moment.lights.size(); ++id) {
        if (!std::ranges::binary_search(scene.light_ids(), id)) continue;
        LocalLight light = scene.light(id);
        light.to_world = light_placement(moment.lights[id]);
        scene.set_light(id, std::move(light));
    }
    camera = camera_of(*moment.sensor);
}

}  // namespace nicol
