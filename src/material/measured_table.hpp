// SPDX-License-Identifier: MIT
// Mueller matrices over half and difference angles of light and viewer.
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

/// Grid of compressed matrices [side][|phi_d|][theta_d][theta_h][channel] in s-frames; see load_measured().
/// Sides: phi_d >= 0 and phi_d <= 0; if there is only the first side, its mirror image is the other.
class MeasuredTable {
public:
    struct Angles {
        double phi_d;  ///< -pi..pi
        double theta_d;
        double theta_h;
    };

    /// Streams the field M. `weights` are the weights of the file's wavelengths in each channel.
    MeasuredTable(TensorFile& file, const ChannelWeights& weights, bool symmetrize, const LoadBudget& budget);

    [[nodiscard]] std::size_t channels() const noexcept { return channels_; }
    [[nodiscard]] bool mirror_symmetric() const noexcept { return sides_ == 1; }
    [[nodiscard]] std::uint64_t bytes() const noexcept {
        return std::span(m00_).size_bytes() + std::span(rest_).size_bytes();
    }
    /// Computes the matrices of out.size() channels from channel `first` on.
    void at(const Angles& angles, std::size_t first, std::span<Mueller> out) const;
    /// Returns the theta_h at which M00, averaged over phi_d and over theta_d up to 45 degrees, falls to a
    /// quarter of its value at the first theta_h: the smallest of all channels, 0.001..1.
    [[nodiscard]] double lobe_width() const;
    /// Returns a hash of everything that was read.
    [[nodiscard]] const std::string& content() const noexcept { return content_; }

    /// Returns the angle fields without values, separated by commas; their angles are evenly spaced.
    [[nodiscard]] const std::string& implied() const noexcept { return implied_; }

    /// Returns the wavelengths of a file. Throws Error(invalid_file) unless there are 1 to 1000, increasing.
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

    std::string implied_;  // text of implied(), written while the angles are read
    std::vector<double> phi_d_, theta_d_, theta_h_;
    struct Azimuth {
        std::size_t index;  // position in phi_d_
        int sign;           // 1 or -1; 0 in the plane of incidence, which belongs to both sides
    };
    std::vector<Azimuth> azimuths_;  // one per azimuth of the file
    std::size_t sides_ = 2;
    std::size_t side_size_ = 0;  // number of entries
    std::size_t channels_;
    std::vector<float> m00_;                          // M00; negative: no value yet
    std::vector<std::array<std::int16_t, 15>> rest_;  // elements 1 to 15 relative to M00
    std::string content_;
};

}  // namespace nicol
