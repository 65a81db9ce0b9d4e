// SPDX-License-Identifier: MIT
// Light of equirectangular images whose values are not checked.
#pragma once

#include "light/environment.hpp"

namespace nicol {

/// Returns the radiance from a unit direction in the frame of Environment::radiance(), bilinear between
/// pixels. The frames of neighbouring pixels differ by no more than the angle between their columns, at the
/// poles too, so that components can be interpolated before they are rotated into the frame of the direction.
[[nodiscard]] Stokes look_up(const EquirectView& view, int channel, const glm::dvec3& towards_light);

/// Light of an image. Its values are not checked and may be physically unrealizable.
class ImageLight final : public Environment {
public:
    explicit ImageLight(EquirectImage image);

    [[nodiscard]] int channels() const noexcept override { return image_.channels; }
    [[nodiscard]] bool polarized() const noexcept override { return polarized_; }
    [[nodiscard]] bool circular() const noexcept override { return circular_; }
    [[nodiscard]] const std::vector<double>& wavelengths() const noexcept override {
        return image_.wavelengths;
    }
    [[nodiscard]] Stokes radiance(int channel, const glm::dvec3& towards_light) const override;
    [[nodiscard]] PshVector project(int order) const override;
    [[nodiscard]] EquirectImage image() const override { return image_; }
    /// Returns pixels of one component if the light is unpolarized.
    [[nodiscard]] EquirectView pixels() const noexcept override;

private:
    EquirectImage image_;
    bool polarized_ = false;
    bool circular_ = false;
};

}  // namespace nicol
