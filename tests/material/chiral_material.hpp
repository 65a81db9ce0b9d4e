// SPDX-License-Identifier: MIT
// An isotropic material without mirror symmetry.
#pragma once

#include <cmath>
#include <utility>

#include "material/material.hpp"

namespace nicol::test {

/// A material under a chiral film that light passes on its way in and out. The film rotates linear
/// polarization and absorbs circular light by its handedness.
class Chiral final : public Material {
public:
    /// `rotation` is twice the rotation angle, in radians. `circular` is the difference between both
    /// handednesses, -1..1.
    explicit Chiral(MaterialPtr base, double rotation = 0.5, double circular = 0.3)
        : base_(std::move(base)),
          film_({1, 0, 0, circular, 0, std::cos(rotation), -std::sin(rotation), 0, 0, std::sin(rotation),
                 std::cos(rotation), 0, circular, 0, 0, 1}) {}

    [[nodiscard]] int channels() const noexcept override { return base_->channels(); }
    [[nodiscard]] int terms() const noexcept override { return base_->terms(); }
    [[nodiscard]] double weight(int t, int c) const override { return base_->weight(t, c); }
    [[nodiscard]] double lobe_width(int t) const noexcept override { return base_->lobe_width(t); }
    [[nodiscard]] bool mirror_symmetric() const noexcept override { return false; }
    [[nodiscard]] Mueller evaluate(int t, const glm::dvec3& towards_light,
                                   const glm::dvec3& towards_viewer) const override {
        return film_ * base_->evaluate(t, towards_light, towards_viewer) * film_;
    }

private:
    MaterialPtr base_;
    Mueller film_;
};

inline MaterialPtr chiral(MaterialPtr base) {
    return std::make_shared<Chiral>(std::move(base));
}

}  // namespace nicol::test
