// SPDX-License-Identifier: MIT
#include "shading/sampled_environment.hpp"

#include <limits>

#include "shading/light_changes.hpp"

namespace nicol {

LaneFrames SampledEnvironment::in_environment(const LaneFrames& of_points) const {
    LaneFrames out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        put(out.x, i, vector_at(of_points.x, i) * to_points_);
        put(out.y, i, vector_at(of_points.y, i) * to_points_);
        put(out.z, i, vector_at(of_points.z, i) * to_points_);
    }
    return out;
}

void SampledEnvironment::look_up(bool whole, const LaneFrames& frames, const ReflectedNode& node,
                                 LaneLight& out) const {
    out_of_frames(frames, node.seen, out.towards);
    (whole ? whole_ : rest_)->look_up(node.variances, out);
    if (out.components > 1) into_frames(frames, out.x, out.x);
    set_node(node, out);
}

void SampledEnvironment::look_up(bool whole, const LaneFrames& frames, const ReflectedNode& node,
                                 LaneLight& out, LaneVectors& lean) const {
    out_of_frames(frames, node.seen, out.towards);
    (whole ? whole_ : rest_)->look_up(node.variances, out, lean);
    into_frames(frames, lean, lean);
    set_node(node, out);
}

void SampledEnvironment::set_node(const ReflectedNode& node, LaneLight& out) const {
    scale(node.weights, out, scale_);
    out.towards = node.towards;
    out.points = (std::uint32_t{1} << kLanes) - 1;
    out.distance.value.fill(std::numeric_limits<float>::infinity());
}

}  // namespace nicol
