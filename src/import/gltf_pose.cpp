// SPDX-License-Identifier: MIT
#include "import/gltf_pose.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "arguments.hpp"
#include "import/gltf_readers.hpp"
#include "import/gltf_track.hpp"

namespace nicol::scene {
GltfPose::GltfPose(const GltfDocument& document, const std::optional<GltfMoment>& moment,
                   const LoadBudget& budget, GltfNotices& notices)
    : document_(document), budget_(budget), animated_(document.model().nodes.size()) {
    const std::vector<tinygltf::Animation>& animations = document.model().animations;
    if (moment) {
        const tinygltf::Animation& animation = animation_of(*moment);
        const auto index = static_cast<std::size_t>(&animation - animations.data());
        animate(animation, moment->time, "animations[" + std::to_string(index) + "]", notices);
    } else if (!animations.empty()) {
        notices.add("animations are followed only with a time; without it nodes rest");
    }
    find_worlds();
}

const tinygltf::Animation& GltfPose::animation_of(const GltfMoment& moment) const {
    const std::vector<tinygltf::Animation>& animations = document_.model().animations;
    const std::string file = document_.path().string();
    if (animations.empty()) refuse(file + ": the parameter time is not used; the file has no animations");
    if (moment.animation.empty()) return animations.front();
    std::string known;
    for (std::size_t i = 0; i < animations.size(); ++i) {
        if (moment.animation == animations[i].name || moment.animation == std::to_string(i))
            return animations[i];
        known += (i > 0 ? ", " : "") + std::to_string(i) + " \"" + animations[i].name + "\"";
    }
    refuse(file + ": there is no animation \"" + moment.animation + "\"; the file has " + known);
}

void GltfPose::animate(const tinygltf::Animation& animation, double time, const std::string& where,
                       GltfNotices& notices) {
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
        const tinygltf::AnimationChannel& channel = animation.channels[i];
        // glTF says to ignore a channel without a node.
        if (channel.target_node < 0) continue;
        const std::string name = where + ".channels[" + std::to_string(i) + "]";
        static_cast<void>(document_.at(document_.model().nodes, "nodes", channel.target_node, name));
        const tinygltf::AnimationSampler& sampler =
            document_.at(animation.samplers, "samplers", channel.sampler, name);
        const auto value = [&](std::size_t size, bool rotation) {
            return gltf_track_value(document_, sampler, time, size, rotation, name, budget_);
        };
        Animated& node = animated_[static_cast<std::size_t>(channel.target_node)];
        if (channel.target_path == "weights") {
            node.weights = value(0, false);
        } else if (channel.target_path == "rotation") {
            const std::vector<double> v = value(4, true);
            node.rotation = glm::dvec4(v[0], v[1], v[2], v[3]);
        } else if (channel.target_path == "translation" || channel.target_path == "scale") {
            const std::vector<double> v = value(3, false);
            (channel.target_path == "scale" ? node.scale : node.translation) = glm::dvec3(v[0], v[1], v[2]);
        } else {
            notices.add("animations of \"" + channel.target_path + "\" are not followed");
        }
    }
}

glm::dmat4 GltfPose::local(std::size_t index) const {
    const tinygltf::Node& node = document_.model().nodes[index];
    const Animated& animated = animated_[index];
    const std::string where = node_name(index);
    const auto check = [&](const std::vector<double>& values, std::size_t size, const char* name) {
        if (!values.empty() && values.size() != size)
            document_.fail(where, std::string(name) + " has " + std::to_string(values.size()) +
                                      " numbers; expected " + std::to_string(size));
        return !values.empty();
    };
    glm::dmat4 m(1.0);
    if (check(node.matrix, 16, "matrix")) {
        for (glm::length_t i = 0; i < 16; ++i) m[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1)
            document_.fail(where, "the last row of matrix (its numbers 4, 8, 12, 16) must be 0 0 0 1");
        if (animated.translation || animated.rotation || animated.scale)
            document_.fail(where, "has a matrix and is animated; expected translation, rotation and scale");
        return m;
    }
    const auto vector = [&](const std::vector<double>& values, const char* name,
                            const std::optional<glm::dvec3>& instead, double missing) {
        const bool given = check(values, 3, name);
        return instead.value_or(given ? glm::dvec3(values[0], values[1], values[2]) : glm::dvec3(missing));
    };
    m = glm::translate(m, vector(node.translation, "translation", animated.translation, 0));
    glm::dvec4 r(0, 0, 0, 1);
    if (check(node.rotation, 4, "rotation"))
        r = {node.rotation[0], node.rotation[1], node.rotation[2], node.rotation[3]};
    if (animated.rotation) r = *animated.rotation;
    const double length = glm::length(r);
    if (!(length > 0.5 && length < 2))
        document_.fail(where, "rotation has length " + std::to_string(length) + "; expected 1");
    m *= glm::mat4_cast(glm::normalize(glm::dquat(r.w, r.x, r.y, r.z)));
    return glm::scale(m, vector(node.scale, "scale", animated.scale, 1));
}

std::vector<double> GltfPose::weights(std::size_t index) const {
    const tinygltf::Node& node = document_.model().nodes[index];
    if (animated_[index].weights) return *animated_[index].weights;
    if (!node.weights.empty() || node.mesh < 0) return node.weights;
    return document_.at(document_.model().meshes, "meshes", node.mesh, node_name(index)).weights;
}

void GltfPose::find_worlds() {
    const std::vector<tinygltf::Node>& nodes = document_.model().nodes;
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const int child : nodes[i].children) {
            static_cast<void>(document_.at(nodes, "nodes", child, node_name(i)));
            int& parent = parents[static_cast<std::size_t>(child)];
            if (parent >= 0)
                document_.fail(node_name(static_cast<std::size_t>(child)),
                               "has two parents, or is below itself");
            parent = static_cast<int>(i);
        }
    worlds_.assign(nodes.size(), glm::dmat4(1.0));
    std::vector<bool> done(nodes.size(), false);
    std::vector<std::size_t> path;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        path.clear();
        for (int at = static_cast<int>(i); at >= 0 && !done[static_cast<std::size_t>(at)];
             at = parents[static_cast<std::size_t>(at)]) {
            path.push_back(static_cast<std::size_t>(at));
            if (path.size() > nodes.size())
                document_.fail(node_name(i), "has two parents, or is below itself");
        }
        for (; !path.empty(); path.pop_back()) {
            budget_.step(256);
            const std::size_t node = path.back();
            const int parent = parents[node];
            const glm::dmat4 above = parent < 0 ? glm::dmat4(1.0) : worlds_[static_cast<std::size_t>(parent)];
            worlds_[node] = above * local(node);
            for (glm::length_t column = 0; column < 4; ++column)
                for (glm::length_t row = 0; row < 4; ++row)
                    if (!std::isfinite(worlds_[node][column][row]))
                        document_.fail(node_name(node), "its transform is not finite");
            done[node] = true;
        }
    }
}

}  // namespace nicol::scene
