// SPDX-License-Identifier: MIT
// Distant light filtered by an isotropic lobe, stored as a map.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "harmonics/psh.hpp"

namespace nicol {

/// A Stokes vector field over propagation directions on an equirectangular grid about the light's own z axis,
/// for bilinear interpolation. Column c lies at phi = 2 pi c / columns() and repeats; row r lies at theta =
/// pi r / (rows() - 1), so both poles are rows and no filter ever crosses a seam. Linear polarization is
/// stored without a frame, as T = s1 (xx - yy) + s2 (xy + yx), which is smooth over the whole sphere.
///
/// A texel has layers() times four floats. Unpolarized: layer i holds s0 of the channels 4 i .. 4 i + 3.
/// Polarized: layer 2 c holds (s0, s3, Txx, Tyy) of channel c and layer 2 c + 1 (Txy, Txz, Tyz, 0); Tzz =
/// -Txx - Tyy.
///
/// The grid is chosen from the filtered light's spectrum, so that the interpolation error is below a
/// tolerance times the RMS (up to kMostRows rows). Texels are sharpened to compensate the blur of the
/// interpolation, so they differ slightly from the field at their centres.
class LobeMap {
public:
    static constexpr double kTolerance = 1e-3;
    static constexpr int kLeastRows = 33;
    static constexpr int kMostRows = 1025;

    LobeMap() = default;
    /// Filters the light by the gains; orders beyond either are left out. Throws Error(invalid_argument) if a
    /// value is not finite, `gains` is empty or the tolerance is not positive.
    LobeMap(const PshVector& light, std::span<const double> gains, bool polarized,
            double tolerance = kTolerance);

    [[nodiscard]] int rows() const noexcept { return rows_; }
    [[nodiscard]] int columns() const noexcept { return 2 * (rows_ - 1); }
    [[nodiscard]] int channels() const noexcept { return channels_; }
    [[nodiscard]] bool polarized() const noexcept { return polarized_; }
    [[nodiscard]] int layers() const noexcept { return polarized_ ? 2 * channels_ : (channels_ + 3) / 4; }
    /// Returns the texels, [row][column][layer][4]; the first column is repeated after the last.
    [[nodiscard]] std::span<const float> texels() const noexcept { return texels_; }
    /// Returns `count` layers for textures, one after another: [layer][row][column][4], without a repeated
    /// column.
    [[nodiscard]] std::vector<float> layers_apart(int first, int count) const;
    [[nodiscard]] std::size_t bytes() const noexcept { return texels_.size() * sizeof(float); }

private:
    void store(int channel, int first_row, std::span<const double> samples,
               std::span<const glm::dvec2> azimuths);

    int rows_ = kLeastRows;
    int channels_ = 0;
    bool polarized_ = false;
    std::vector<float> texels_;
};

}  // namespace nicol
