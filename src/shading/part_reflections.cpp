// SPDX-License-Identifier: MIT
#include "shading/part_reflections.hpp"

namespace nicol {

const ReflectedLight& PartReflections::at(std::size_t part) {
    const std::uint32_t own = 1U << part;
    if ((prepared_ & own) == 0) {
        for (std::size_t i = 0; i < positions_.size(); ++i) normals_[part][i] = parts_[i].normals[part];
        reflected_[part].set(views_, positions_, normals(part), tangents_);
        prepared_ |= own;
    }
    return reflected_[part];
}

}  // namespace nicol
