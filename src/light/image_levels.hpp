// SPDX-License-Identifier: MIT
// Equirectangular images of different widths, looked up in sixteen places at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "light/equirect_texels.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Images, and look-ups between two that follow each other.
class ImageLevels {
public:
    /// planes: the number of planes of every image.
    explicit ImageLevels(std::size_t planes) : planes_(planes) {}

    /// Adds an image whose rows are vertex-centred.
    void add(const EquirectTexels& image);

    struct Places {
        Lanes turn, half_turn;  ///< see EquirectPlace
        /// Index of an image, and the weight of the next image as the fraction. Clamped to the images.
        Lanes level;
    };
    /// Computes the interpolated texels: out[4 plane + component]. There must be at least two images.
    void look_up(const Places& places, Lanes* out) const { look_up(places, out, nullptr); }
    /// Changes of the sum of the first plane's components with the place, relative to the sum: those of the
    /// second of the two images.
    struct Slopes {
        Lanes by_turn, by_half_turn;
    };
    /// Computes the interpolated texels and the slopes there.
    void look_up(const Places& places, Lanes* out, Slopes& slopes) const { look_up(places, out, &slopes); }

    [[nodiscard]] std::size_t bytes() const noexcept { return texels_.capacity() * sizeof(glm::vec4); }

    /// Widths, numbers of rows less one, and the first texels, by image.
    struct Shapes {
        std::vector<float> widths, last_rows;
        std::vector<std::int32_t> first;
    };

private:
    void look_up(const Places& places, Lanes* out, Slopes* slopes) const;

    std::size_t planes_;
    Shapes shapes_;
    /// [image][row][column][plane]. Each row ends with its first column once more.
    std::vector<glm::vec4> texels_;
};

}  // namespace nicol
