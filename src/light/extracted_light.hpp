// SPDX-License-Identifier: MIT
// Extracted lights: small bright parts of an environment, taken out of it as separate lights.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "light/lane_light.hpp"

namespace nicol {

/// Window of pixels of an equirectangular image; columns wrap. A cell is the area between four pixels.
struct EquirectWindow {
    int width = 0;  ///< columns of the image
    int height = 0;
    int top = 0;  ///< first row of pixels
    int left = 0;
    int rows = 0;     ///< number of rows of cells, 1 to height - 1
    int columns = 0;  ///< number of columns of cells, 1 to width
};

/// Light from a window of an image (see EquirectImage): bilinear between its pixels, zero beyond them.
/// Immutable and safe to share between threads.
class ExtractedLight {
public:
    /// values: Stokes vectors of (rows + 1) x (columns + 1) pixels in the frames of EquirectImage,
    /// [row][column][channel][p]; s0 >= 0, not all 0.
    ExtractedLight(const EquirectWindow& window, int channels, std::vector<float> values);

    [[nodiscard]] int channels() const noexcept { return static_cast<int>(channels_); }
    /// Returns whether some s1, s2 or s3 is not zero.
    [[nodiscard]] bool polarized() const noexcept { return components_ > 1; }
    /// Returns whether some s3 is not zero.
    [[nodiscard]] bool circular() const noexcept { return components_ > 3; }
    /// Returns the unit direction towards the light's centre, in the environment's axes.
    [[nodiscard]] const glm::dvec3& centre() const noexcept { return centre_; }
    /// Returns the radius, in radians, of a cone about centre() that contains all of the light.
    [[nodiscard]] double angular_radius() const noexcept { return angular_radius_; }

    /// Samples sixteen points of the light by numbers in [0, 1), with a density nearly proportional to the
    /// sum of s0 over the channels. The points are infinitely far, in the environment's axes. Columns grow
    /// with u and rows with v, so that stratified numbers give stratified points. The mean irradiance over
    /// all u and v is the irradiance of the extracted light.
    void sample(const Lanes& u, const Lanes& v, LaneLight& out) const;

    /// Finds the light seen in sixteen unit directions of the environment's axes. out.points has the
    /// directions with light, and out.irradiance holds radiance in place of irradiance.
    void intersect(const LaneVectors& directions, LaneLight& out) const;

private:
    void find_cone();
    /// Sets out.irradiance of a lane to `scale` times the values in the cell whose upper left pixel is
    /// `first`. `right` and `down` are the position in the cell, 0 to 1.
    void put(std::size_t first, float right, float down, float scale, std::size_t lane, LaneLight& out) const;

    EquirectWindow window_;
    std::size_t channels_;
    std::vector<float> values_;
    std::size_t components_ = 1;
    // s0 of all channels times solid angle at the pixels, [row][column]; bilinear between them.
    std::vector<double> densities_;
    // Sums of the cells' mean densities: from the first cell of a row to each cell, [row][column]; from the
    // first row to each row.
    std::vector<double> cells_;
    std::vector<double> rows_;
    glm::dvec3 centre_{};
    double angular_radius_ = 0;
};

}  // namespace nicol
