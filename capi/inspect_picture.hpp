// SPDX-License-Identifier: MIT
// Equirectangular pictures of light on their way between files.
#pragma once

#include "nicol/environment.hpp"

namespace nicol::capi {

/// A picture as light, taken as it is: values need not be physical. Bilinear as image_environment().
class PictureLight final : public Environment {
public:
    explicit PictureLight(EquirectImage image);

    [[nodiscard]] int channels() const noexcept override { return image_.channels; }
    [[nodiscard]] bool polarized() const noexcept override { return polarized_; }
    [[nodiscard]] bool circular() const noexcept override { return circular_; }
    [[nodiscard]] const std::vector<double>& wavelengths() const noexcept override {
        return image_.wavelengths;
    }
    [[nodiscard]] Stokes radiance(int channel, const glm::dvec3& towards_light) const override;
    [[nodiscard]] PshVector project(int order) const override;
    [[nodiscard]] EquirectImage picture() const override { return image_; }

private:
    EquirectImage image_;
    bool polarized_ = false;
    bool circular_ = false;
};

/// Coefficients of the light without orders above `order` whose samples the pixels are. Throws
/// Error(invalid_argument) for fewer than 2 order + 1 columns or rows.
[[nodiscard]] PshVector project_samples_of(const EquirectImage& image, int order);

/// The light of coefficients at the pixels; orders that fewer than 2 order + 1 columns or rows cannot hold
/// are left out. The inverse of project_samples_of().
[[nodiscard]] EquirectImage synthesize_picture(const PshVector& field, int width, int height);

/// A light turned by a rotation, at other pixels: bilinear, or the mean over each pixel where they get larger
/// than those of `source_width` columns.
[[nodiscard]] EquirectImage resample_picture(const Environment& light, const glm::dmat3& rotation,
                                             int source_width, int width, int height);

}  // namespace nicol::capi
