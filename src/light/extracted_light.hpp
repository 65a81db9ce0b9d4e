// SPDX-License-Identifier: MIT
// A small bright part of an environment, taken out of it as a light of its own.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "light/lane_light.hpp"

namespace nicol {

/// Pixels of an equirectangular image: columns wrap. Cells are what lies between four of them.
struct EquirectWindow {
    int width = 0;  ///< of the image
    int height = 0;
    int top = 0;  ///< the first row of pixels
    int left = 0;
    int rows = 0;     ///< of cells, 1 to height - 1
    int columns = 0;  ///< of cells, 1 to width
};

/// Light from a window of an image (see EquirectImage): bilinear between its pixels, none beyond them.
/// Immutable; threads may share it.
class ExtractedLight {
public:
    /// values: Stokes vectors of the pixels in the frames of EquirectImage, [row][column][channel][p], of
    /// (rows + 1) x (columns + 1) pixels; s0 >= 0, not all 0.
    ExtractedLight(const EquirectWindow& window, int channels, std::vector<float> values);

    [[nodiscard]] int channels() const noexcept { return static_cast<int>(channels_); }
    /// Some s1, s2 or s3 is not zero.
    [[nodiscard]] bool polarized() const noexcept { return components_ > 1; }
    /// Some s3 is not zero.
    [[nodiscard]] bool circular() const noexcept { return components_ > 3; }
    /// Unit, towards it, in the environment's axes.
    [[nodiscard]] const glm::dvec3& centre() const noexcept { return centre_; }
    /// Radians, of a cone about centre() that holds all of it.
    [[nodiscard]] double angular_radius() const noexcept { return angular_radius_; }

    /// Sixteen places of it, chosen by numbers in [0, 1) nearly in proportion to the sum of s0 over the
    /// channels, infinitely far, in the environment's axes. Columns grow with u and rows with v, so that
    /// stratified numbers give stratified places. The mean irradiance over all u and v is that of the
    /// extracted light.
    void sample(const Lanes& u, const Lanes& v, LaneLight& out) const;

    /// What is seen of it in sixteen unit directions of the environment's axes: `out` has those in which
    /// there is some, and radiance in place of irradiance.
    void intersect(const LaneVectors& directions, LaneLight& out) const;

private:
    void find_cone();
    /// Of out.irradiance: `scale` times the values in a cell, whose upper left pixel is `first`, as far right
    /// and down in it as given, 0 to 1.
    void put(std::size_t first, float right, float down, float scale, std::size_t lane, LaneLight& out) const;

    EquirectWindow window_;
    std::size_t channels_;
    std::vector<float> values_;
    std::size_t components_ = 1;
    // At the pixels, [row][column]: s0 of all channels times solid angle; bilinear between them.
    std::vector<double> densities_;
    // Sums of the cells' mean densities: from the first of a row to each, [row][column]; of rows to each.
    std::vector<double> cells_;
    std::vector<double> rows_;
    glm::dvec3 centre_{};
    double angular_radius_ = 0;
};

}  // namespace nicol
