// SPDX-License-Identifier: MIT
// Reflection at the parts of pixels whose normals textures perturb.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "polarization/views.hpp"
#include "shading/pixel_places.hpp"
#include "shading/reflected_light.hpp"

namespace nicol {

/// Reflection at up to sixteen points, with the normals of their pixels' parts. Prepares a part when it is
/// first asked for.
class PartReflections {
public:
    /// The arguments must outlive the object. tangents: as of ReflectedLight::set(). parts: those of each
    /// point's pixel.
    PartReflections(const Views& views, std::span<const glm::vec3> positions,
                    std::span<const glm::vec3> tangents, std::span<const MirroredParts> parts)
        : views_(views), positions_(positions), tangents_(tangents), parts_(parts) {}

    [[nodiscard]] const ReflectedLight& at(std::size_t part);
    /// Returns the normals of a part that at() has prepared.
    [[nodiscard]] std::span<const glm::vec3> normals(std::size_t part) const {
        return std::span(normals_[part]).first(positions_.size());
    }

private:
    std::array<ReflectedLight, MirroredParts::kCount> reflected_;
    std::array<std::array<glm::vec3, kLanes>, MirroredParts::kCount> normals_;
    const Views& views_;
    std::span<const glm::vec3> positions_, tangents_;
    std::span<const MirroredParts> parts_;
    std::uint32_t prepared_ = 0;  // bits of the parts
};

}  // namespace nicol
