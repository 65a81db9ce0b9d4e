// SPDX-License-Identifier: MIT
#include "nicol/scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <string>
#include <utility>

#include "nicol/error.hpp"

namespace nicol {
namespace {

[[noreturn]] void refuse(const std::string& message) {
    throw Error(ErrorCode::invalid_argument, message);
}

void check_transform(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(m[column][row])) refuse("to_world has an element that is not finite");
        }
    }
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) {
        refuse("the last row of to_world must be 0 0 0 1");
    }
    const double determinant = glm::determinant(glm::dmat3(m));
    if (!std::isfinite(determinant) || determinant == 0) refuse("to_world cannot be inverted");
}

}  // namespace

void Scene::check_channels(int channels, const char* what) const {
    const int own = this->channels();
    if (channels == 1 || own == 1 || channels == own) return;
    refuse(std::string(what) + " has " + std::to_string(channels) + " colour channels and the scene " +
           std::to_string(own) + "; it must have 1 or as many");
}

int Scene::channels() const {
    int most = environment_ ? environment_->channels() : 1;
    for (const Instance& instance : instances_) most = std::max(most, instance.material->channels());
    return most;
}

std::uint32_t Scene::add(Instance instance) {
    if (!instance.mesh) refuse("the instance has no mesh");
    if (!instance.material) refuse("the instance has no material");
    if (instances_.size() >= std::numeric_limits<std::uint32_t>::max())
        refuse("the scene has too many instances");
    check_transform(instance.to_world);
    check_channels(instance.material->channels(), "the material");
    instances_.push_back(std::move(instance));
    ++geometry_revision_;
    return static_cast<std::uint32_t>(instances_.size() - 1);
}

void Scene::set_transform(std::uint32_t id, const glm::dmat4& to_world) {
    if (id >= instances_.size()) {
        refuse("there is no instance " + std::to_string(id) + "; the scene has " +
               std::to_string(instances_.size()));
    }
    check_transform(to_world);
    if (instances_[id].to_world == to_world) return;
    instances_[id].to_world = to_world;
    ++geometry_revision_;
}

void Scene::set_environment(EnvironmentPtr environment, const glm::dmat3& rotation, double scale) {
    if (!(scale >= 0) || !std::isfinite(scale)) {
        refuse("the scale of the environment is " + std::to_string(scale) +
               "; it must be finite and not negative");
    }
    const glm::dmat3 product = glm::transpose(rotation) * rotation;
    double deviation = 0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            deviation = std::fmax(deviation, std::abs(product[column][row] - (column == row ? 1 : 0)));
        }
    }
    if (!(deviation < 1e-5) || glm::determinant(rotation) < 0) {
        refuse(
            "the environment can only be turned: its to_world must be a rotation without scale or mirroring");
    }
    if (environment) {
        int materials = 1;
        for (const Instance& instance : instances_)
            materials = std::max(materials, instance.material->channels());
        if (environment->channels() != 1 && materials != 1 && environment->channels() != materials) {
            refuse("the environment has " + std::to_string(environment->channels()) +
                   " colour channels and the materials " + std::to_string(materials) +
                   "; it must have 1 or as many");
        }
    }
    environment_ = std::move(environment);
    rotation_ = rotation;
    scale_ = scale;
    ++light_revision_;
}

}  // namespace nicol
