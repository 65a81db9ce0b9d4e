// SPDX-License-Identifier: MIT
#include "import/gltf_deformation.hpp"

#include <cmath>
#include <glm/matrix.hpp>
#include <map>

namespace nicol::scene {
namespace {

glm::dvec3 vector(const GltfAccessor& from, std::size_t i) {
    return {from.number(i, 0), from.number(i, 1), from.number(i, 2)};
}

}  // namespace

GltfDeformation::GltfDeformation(const GltfDocument& document, const GltfPose& pose, std::size_t node,
                                 const tinygltf::Primitive& primitive, const std::string& where)
    : document_(document), where_(where) {
    const auto positions = primitive.attributes.find("POSITION");
    if (positions != primitive.attributes.end())
        vertices_ = GltfAccessor(document, positions->second, where + ": POSITION").count();
    read_targets(pose, node, primitive);
    const int skin = document.model().nodes[node].skin;
    if (skin >= 0) read_skin(pose, skin, primitive);
}

GltfAccessor GltfDeformation::attribute(int index, const std::string& name, std::size_t components) const {
    GltfAccessor accessor(document_, index, where_ + ": " + name);
    if (accessor.components() != components)
        document_.fail(where_, name + " has elements of " + std::to_string(accessor.components()) +
                                   " numbers; expected " + std::to_string(components));
    if (accessor.count() < vertices_)
        document_.fail(where_, name + " has " + std::to_string(accessor.count()) + " elements and POSITION " +
                                   std::to_string(vertices_));
    return accessor;
}

void GltfDeformation::read_targets(const GltfPose& pose, std::size_t node,
                                   const tinygltf::Primitive& primitive) {
    const std::vector<double> weights = pose.weights(node);
    for (std::size_t i = 0; i < primitive.targets.size() && i < weights.size(); ++i) {
        if (weights[i] == 0) continue;
        const std::map<std::string, int>& attributes = primitive.targets[i];
        const auto find = [&](const char* name) -> std::optional<GltfAccessor> {
            const auto found = attributes.find(name);
            if (found == attributes.end()) return std::nullopt;
            return attribute(found->second, "targets[" + std::to_string(i) + "]." + name, 3);
        };
        targets_.push_back({.weight = weights[i],
                            .positions = find("POSITION"),
                            .normals = find("NORMAL"),
                            .tangents = find("TANGENT")});
    }
}

void GltfDeformation::read_skin(const GltfPose& pose, int index, const tinygltf::Primitive& primitive) {
    const tinygltf::Skin& skin = document_.at(document_.model().skins, "skins", index, where_);
    const std::string name = "skins[" + std::to_string(index) + "]";
    for (int set = 0;; ++set) {
        const auto joints = primitive.attributes.find("JOINTS_" + std::to_string(set));
        const auto weights = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
        if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) break;
        influences_.push_back({.joints = attribute(joints->second, joints->first, 4),
                               .weights = attribute(weights->second, weights->first, 4)});
        if (!influences_.back().joints.is_unsigned() || influences_.back().joints.is_real())
            document_.fail(where_, joints->first + " must have integers without sign, not normalized");
        if (!influences_.back().weights.is_real())
            document_.fail(where_, weights->first + " has integers that are not normalized");
    }
    std::optional<GltfAccessor> inverse;
    if (skin.inverseBindMatrices >= 0) {
        inverse.emplace(document_, skin.inverseBindMatrices, name + ": inverseBindMatrices");
        if (inverse->components() != 16 || inverse->count() < skin.joints.size())
            document_.fail(name, "inverseBindMatrices has " + std::to_string(inverse->count()) +
                                     " elements of " + std::to_string(inverse->components()) +
                                     " numbers; expected 16 numbers for each of " +
                                     std::to_string(skin.joints.size()) + " joints");
    }
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        static_cast<void>(document_.at(document_.model().nodes, "nodes", skin.joints[j], name));
        glm::dmat4 bind(1.0);
        for (glm::length_t i = 0; inverse && i < 16; ++i)
            bind[i / 4][i % 4] = inverse->number(j, static_cast<std::size_t>(i));
        joints_.push_back(pose.world(static_cast<std::size_t>(skin.joints[j])) * bind);
    }
}

glm::dmat4 GltfDeformation::motion(std::size_t index) const {
    glm::dmat4 sum(0.0);
    double total = 0;
    for (const Influences& influences : influences_) {
        for (std::size_t k = 0; k < 4; ++k) {
            const double weight = influences.weights.number(index, k);
            if (weight == 0) continue;
            const auto joint = static_cast<std::size_t>(influences.joints.number(index, k));
            if (joint >= joints_.size())
                document_.fail(where_, "vertex " + std::to_string(index) + " follows joint " +
                                           std::to_string(joint) + ", but its skin has only " +
                                           std::to_string(joints_.size()));
            sum += weight * joints_[joint];
            total += weight;
        }
    }
    // A vertex that follows no joint stays where it is.
    return total > 0 ? sum / total : glm::dmat4(1.0);
}

GltfDeformation::Vertex GltfDeformation::operator()(std::size_t index, Vertex vertex) const {
    for (const Target& target : targets_) {
        if (target.positions) vertex.position += target.weight * vector(*target.positions, index);
        if (target.normals) vertex.normal += target.weight * vector(*target.normals, index);
        if (target.tangents) vertex.tangent += target.weight * vector(*target.tangents, index);
    }
    if (influences_.empty()) return vertex;
    const glm::dmat4 moved = motion(index);
    const glm::dmat3 linear(moved);
    vertex.position = glm::dvec3(moved * glm::dvec4(vertex.position, 1));
    vertex.tangent = linear * vertex.tangent;
    // Joints that flatten a surface leave it without a normal, which the reader then makes.
    vertex.normal =
        glm::determinant(linear) != 0 ? glm::transpose(glm::inverse(linear)) * vertex.normal : glm::dvec3(0);
    return vertex;
}

}  // namespace nicol::scene
