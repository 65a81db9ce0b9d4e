// SPDX-License-Identifier: MIT
#include "import/gltf_animation.hpp"

#include "geometry/left_out.hpp"
#include "import/gltf_deformation.hpp"
#include "import/gltf_pose.hpp"

namespace nicol::scene {

SceneAnimation::Moment GltfAnimation::at(double time, const LoadBudget& budget) const {
    const GltfDocument& document = *document_;
    GltfNotices notices(document.path());
    const GltfPose pose(document, GltfMoment{.time = time, .animation = animation_}, budget, notices);
    geometry::LeftOut left_out;
    GltfBounds all;
    Moment out;
    for (const Part& part : parts_) {
        Shape& shape = out.shapes.emplace_back();
        if (!part.skinned) shape.to_world = pose.world(part.node);
        GltfBounds bounds = part.bounds;
        shape.mesh = part.mesh;
        if (part.deforming) {
            const GltfDeformation deformation(document, pose, part.node, *part.primitive, part.where);
            shape.mesh = read_gltf_primitive(document, *part.primitive, part.where, *part.deforming,
                                             &deformation, budget, left_out);
            if (shape.mesh) bounds = bounds_of(*shape.mesh);
        }
        shape.present = is_gltf_placement(shape.to_world) && shape.mesh;
        if (shape.present) all.add(bounds, shape.to_world);
    }
    for (const std::size_t node : lights_) {
        const std::string where = node_name(node);
        out.lights.push_back(
            read_gltf_light(document, document.model().nodes[node], where, pose.world(node), notices)
                ->parameters.to_world);
    }
    out.sensor = std::make_shared<const SensorDescription>(
        camera_ ? read_gltf_camera(document, document.model().nodes[*camera_], node_name(*camera_),
                                   pose.world(*camera_), all)
                : gltf_camera_in_front(all));
    return out;
}

}  // namespace nicol::scene
