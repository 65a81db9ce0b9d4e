// SPDX-License-Identifier: MIT
// Mueller matrices over the angles between half vector, normal and light.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "files/load_budget.hpp"
#include "material/spectrum_weights.hpp"
#include "material/tensor_file.hpp"
#include "polarization/mueller.hpp"

namespace nicol {

/// A grid of compressed matrices [side][|phi_d|][theta_d][theta_h][channel] in s-frames; see load_measured().
/// Sides: phi_d >= 0 and phi_d <= 0, or the first alone, whose mirror image is the other.
class MeasuredTable {
public:
    struct Angles {
        double phi_d;  ///< -pi..pi
        double theta_d;
        double theta_h;
    };

    /// Streams the field M. Weights: of the file's wavelengths in each channel.
    MeasuredTable(TensorFile& file, const ChannelWeights& weights, bool symmetrize, const LoadBudget& budget);

    [[nodiscard]] std::size_t channels() const noexcept { return channels_; }
    [[nodiscard]] bool mirror_symmetric() const noexcept { return sides_ == 1; }
    /// Writes the matrices of `count` channels from `first` on.
    void at(const Angles& angles, std::size_t first, std::span<Mueller> out) const;
    /// theta_h at which M00, averaged over phi_d and theta_d up to 45 degrees, falls to a quarter of that at
    /// the first theta_h; the smallest of all channels.
    [[nodiscard]] double lobe_width() const;
    /// Hash of everything that was read.
    [[nodiscard]] const std::string& content() const noexcept { return content_; }

    /// Names of the angle fields that hold no values, separated by commas: their angles are evenly spaced.
    [[nodiscard]] const std::string& implied() const noexcept { return implied_; }

    /// The wavelengths of a file. Throws Error(invalid_file) unless there are 1 to 1000, increasing.
    [[nodiscard]] static std::vector<double> wavelengths(TensorFile& file);

private:
    struct Cell {
        std::size_t index;
        double fraction;
    };
    std::vector<double> angles(TensorFile& file, const std::string& name, double low, double high);
    static Cell find(const std::vector<double>& grid, double value);
    void fold_azimuths(const std::vector<double>& phi);
    void take(std::size_t entry, const std::array<double, 16>& matrix);
    void fill_missing();

    std::string implied_;  // filled while the angles are read
    std::vector<double> phi_d_, theta_d_, theta_h_;
    struct Azimuth {
        std::size_t index;  // in phi_d_
        int sign;           // 0 in the plane of incidence, which is of both sides
    };
    std::vector<Azimuth> azimuths_;  // by index in the file
    std::size_t sides_ = 2;
    std::size_t side_size_ = 0;  // entries
    std::size_t channels_;
    std::vector<float> m00_;                          // negative: nothing yet
    std::vector<std::array<std::int16_t, 15>> rest_;  // elements 1 to 15 relative to M00
    std::string content_;
};

}  // namespace nicol
