// SPDX-License-Identifier: MIT
// Arbitrary output variables: depth, normals, positions, instances, coverage and variance by pixel.
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
    aov_variance = 16,  ///< by the reference method alone
    aov_alpha = 32,
};

/// The value of `instances` where there is no surface.
inline constexpr std::uint32_t kNoInstance = 0xffffffff;

/// Of the first surface on the ray through each pixel's centre; with several samples a pixel, of the nearest
/// that they show, and the normal is the mean. [y][x], row 0 at the top. Variance and coverage are of the
/// image itself. AOVs that were not requested are empty.
struct Aovs {
    int width = 0;
    int height = 0;
    int channels = 0;  ///< of `variance`, colour channels
    /// Distance along the camera's z, in the scene's units; +infinity where there is no surface.
    std::vector<float> depth;
    /// [y][x][3]: unit shading normals in the world, of a two-sided surface on the visible side, else on its
    /// front; 0 where there is no surface or the samples' normals cancel.
    std::vector<float> normals;
    /// [y][x][3]: points in the world; 0 where there is no surface.
    std::vector<float> positions;
    /// Ids of the scene's instances, or kNoInstance.
    std::vector<std::uint32_t> instances;
    /// [channel][y][x][p], as StokesImage::data: estimates of the variance of s0..s3 of each pixel over
    /// seeds, the squares of its standard errors; at most the largest float.
    std::vector<float> variance;
    /// Coverage: the fraction of a pixel's samples that show a surface, from the front or from behind.
    std::vector<float> alpha;

    Aovs() = default;
    /// These AOVs (bits of AovBit) of an image without surfaces; `channels` matters to the variance alone.
    Aovs(int width, int height, std::uint32_t mask, int channels = 0);

    /// The AOVs that are here.
    [[nodiscard]] std::uint32_t mask() const noexcept;
    /// Whether they are of an image of this size and these channels; no AOVs are of any.
    [[nodiscard]] bool fit(int image_width, int image_height, int image_channels) const noexcept;
    /// Throws Error(invalid_argument) naming `what` unless every AOV is empty or fits the size.
    void check(const char* what) const;
};

}  // namespace nicol
