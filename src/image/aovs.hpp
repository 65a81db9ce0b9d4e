// SPDX-License-Identifier: MIT
// Arbitrary output variables per pixel: depth, normals, positions, instances, coverage and variance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nicol {

/// AOVs, as bits.
enum AovBit : std::uint32_t {
    aov_depth = 1,
    aov_normals = 2,
    aov_positions = 4,
    aov_instances = 8,
    aov_variance = 16,  ///< only by the reference method
    aov_alpha = 32,
};

/// Value of `instances` at pixels without a surface.
inline constexpr std::uint32_t kNoInstance = 0xffffffff;

/// AOVs of an image, [y][x], row 0 at the top. An AOV describes the first surface on the ray through the
/// pixel's centre. With several samples per pixel, it describes the nearest surface that the samples show,
/// and the normal is the mean of the samples. Variance and coverage describe the image itself. AOVs that were
/// not requested are empty.
struct Aovs {
    int width = 0;
    int height = 0;
    int channels = 0;  ///< colour channels of `variance`
    /// Distance along the camera's z, in the scene's units; +infinity at pixels without a surface.
    std::vector<float> depth;
    /// [y][x][3]: unit shading normals in the world, on the visible side of a two-sided surface, else on the
    /// front side; 0 at pixels without a surface or with normals that cancel.
    std::vector<float> normals;
    /// [y][x][3]: points in the world; 0 at pixels without a surface.
    std::vector<float> positions;
    /// Ids of the scene's instances, or kNoInstance.
    std::vector<std::uint32_t> instances;
    /// [channel][y][x][p], like StokesImage::data: estimated variance of s0..s3 of each pixel over seeds,
    /// which is the square of the standard error; at most the largest float.
    std::vector<float> variance;
    /// Coverage: the fraction of a pixel's samples that show a surface, from the front or from behind.
    std::vector<float> alpha;

    Aovs() = default;
    /// Makes the AOVs in `mask` (bits of AovBit) of an image without surfaces. `channels` matters only for
    /// variance.
    Aovs(int width, int height, std::uint32_t mask, int channels = 0);

    /// Returns the AOVs that are present, as bits of AovBit.
    [[nodiscard]] std::uint32_t mask() const noexcept;
    /// Returns whether the AOVs belong to an image of this size and these channels. Empty AOVs fit every
    /// image.
    [[nodiscard]] bool fit(int image_width, int image_height, int image_channels) const noexcept;
    /// Throws Error(invalid_argument) that names `what` unless every AOV is empty or fits the size.
    void check(const char* what) const;
};

}  // namespace nicol
