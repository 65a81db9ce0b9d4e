// SPDX-License-Identifier: MIT
// Equirectangular images as light.
#pragma once

#include "light/environment.hpp"

namespace nicol {

/// Radiance from a unit direction as Environment::radiance() has it, bilinear between pixels. Neighbours'
/// frames differ by no more than the angle between their columns, at the poles too, so that components can be
/// interpolated before they are rotated into the frame of the direction.
[[nodiscard]] Stokes look_up(const EquirectView& view, int channel, const glm::dvec3& towards_light);

/// An image as light. Its values are not checked and need not be physical.
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

private:
    /// With one component if the light is unpolarized.
    [[nodiscard]] EquirectView view() const;

    EquirectImage image_;
    bool polarized_ = false;
    bool circular_ = false;
};

}  // namespace nicol
