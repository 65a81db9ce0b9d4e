// SPDX-License-Identifier: MIT
#include "import/gltf_pose.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "arguments.hpp"
#include "import/gltf_accessor.hpp"
#include "import/gltf_readers.hpp"

namespace nicol::scene {
namespace {

enum class Interpolation { step, linear, cubic };

// Place of a time among the times of a sampler.
struct Place {
    std::size_t before = 0, after = 0;  // keys
    double part = 0;                    // of the way from the one to the other
    double length = 0;                  // seconds between them
};

Place place_of(const GltfDocument& document, const GltfAccessor& times, double time, const std::string& where,
               const LoadBudget& budget) {
    if (times.components() != 1 || !times.is_real())
        document.fail(where, "input must have one float per key, the time in seconds");
    Place place;
    double last = 0;
    for (std::size_t i = 0; i < times.count(); ++i) {
        budget.step();
        const double at = times.number(i, 0);
        if (!std::isfinite(at) || at < 0 || (i > 0 && at <= last))
            document.fail(where, "input must ascend from 0 or more; number " + std::to_string(i) +
                                     " (0-based) does not");
        if (at <= time) place = {.before = i, .after = i};
        if (at > time && i > 0 && place.before == i - 1 && last <= time)
            place = {.before = i - 1, .after = i, .part = (time - last) / (at - last), .length = at - last};
        last = at;
    }
    return place;
}

Interpolation interpolation_of(const GltfDocument& document, const std::string& name,
                               const std::string& where) {
    if (name.empty() || name == "LINEAR") return Interpolation::linear;
    if (name == "STEP") return Interpolation::step;
    if (name == "CUBICSPLINE") return Interpolation::cubic;
    document.fail(where, "interpolation is \"" + name + R"("; expected "LINEAR", "STEP" or "CUBICSPLINE")");
}

// Returns the quaternion of four numbers x, y, z, w with unit length.
glm::dquat rotation_of(const GltfDocument& document, const std::vector<double>& xyzw,
                       const std::string& where) {
    const glm::dquat q(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    if (!(glm::length(q) > 0)) document.fail(where, "output has a rotation of length 0");
    return glm::normalize(q);
}

}  // namespace

std::vector<double> gltf_track_value(const GltfDocument& document, const tinygltf::AnimationSampler& sampler,
                                     double time, std::size_t size, bool rotation, const std::string& where,
                                     const LoadBudget& budget) {
    const GltfAccessor times(document, sampler.input, where + ": input");
    const GltfAccessor values(document, sampler.output, where + ": output");
    const Interpolation interpolation = interpolation_of(document, sampler.interpolation, where);
    // A cubic key is three values: the tangent before it, the value and the tangent after it.
    const std::size_t parts = interpolation == Interpolation::cubic ? 3 : 1;
    const std::size_t numbers = values.count() * values.components();
    if (size == 0) size = numbers / (times.count() * parts);
    if (size == 0 || numbers != times.count() * parts * size)
        document.fail(where, "output has " + std::to_string(numbers) + " numbers for " +
                                 std::to_string(times.count()) + " keys; expected " +
                                 std::to_string(parts * size) + " per key");
    const auto value = [&](std::size_t key, std::size_t part) {
        std::vector<double> out;
        for (std::size_t i = 0; i < size; ++i) {
            budget.step();
            const std::size_t number = (key * parts + part) * size + i;
            out.push_back(values.number(number / values.components(), number % values.components()));
            if (!std::isfinite(out.back()))
                document.fail(where, "output has a number that is not finite, of key " + std::to_string(key));
        }
        return out;
    };
    const Place place = place_of(document, times, time, where, budget);
    std::vector<double> out = value(place.before, parts / 2);
    if (place.before != place.after && interpolation != Interpolation::step) {
        const std::vector<double> next = value(place.after, parts / 2);
        const double t = place.part;
        if (interpolation == Interpolation::cubic) {
            const std::vector<double> leaving = value(place.before, 2), arriving = value(place.after, 0);
            const double t2 = t * t, t3 = t2 * t;
            for (std::size_t i = 0; i < size; ++i)
                out[i] = (2 * t3 - 3 * t2 + 1) * out[i] + place.length * (t3 - 2 * t2 + t) * leaving[i] +
                         (3 * t2 - 2 * t3) * next[i] + place.length * (t3 - t2) * arriving[i];
        } else if (rotation) {
            // glm takes the shorter way.
            const glm::dquat q =
                glm::slerp(rotation_of(document, out, where), rotation_of(document, next, where), t);
            out = {q.x, q.y, q.z, q.w};
        } else {
            for (std::size_t i = 0; i < size; ++i) out[i] += t * (next[i] - out[i]);
        }
    }
    if (rotation) {
        const glm::dquat q = rotation_of(document, out, where);
        out = {q.x, q.y, q.z, q.w};
    }
    return out;
}

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
