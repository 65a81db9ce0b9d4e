// SPDX-License-Identifier: MIT
// Polarization elements of a scene, whose axis and retardance may vary.
#pragma once

#include <utility>

#include "polarization/element.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Textures of a polarization element. They cover the square |x| <= 1, |y| <= 1 of its local coordinates: u
/// runs along x and v along y, as on Mitsuba's rectangle. Each is a factor; null: 1. Textures have no
/// footprint, and no colours of a mesh.
struct ElementTextures {
    TexturePtr angle;       ///< factor on the angle: the first channel
    TexturePtr retardance;  ///< factor on the retardance: one channel, or red, green and blue
    bool operator==(const ElementTextures&) const = default;
};

/// Polarization element of a scene.
struct SceneElement : PolarizationElement {
    SceneElement(const PolarizationElement& element, ElementTextures with = {})
        : PolarizationElement(element), textures(std::move(with)) {}

    ElementTextures textures;
    bool operator==(const SceneElement&) const = default;

    /// Returns the number of colour channels: 3 for a retarder of red, green and blue.
    [[nodiscard]] int channels() const noexcept {
        return kind == Kind::retarder && textures.retardance != nullptr ? textures.retardance->channels() : 1;
    }
};

}  // namespace nicol
