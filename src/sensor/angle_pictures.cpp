// SPDX-License-Identifier: MIT
#include "sensor/angle_pictures.hpp"

#include "files/file_error.hpp"
#include "image/bitmap.hpp"
#include "sensor/demosaic.hpp"

namespace nicol {
namespace {

/// Returns the numbers of a picture as light, [channel][y][x], in s0.
StokesImage read_light(const std::filesystem::path& file) {
    if (!is_bitmap(file)) return read_exr(file);
    Bitmap bitmap = read_bitmap(file);
    bitmap.linear = true;  // cameras write what they measure, without a curve
    return unpolarized_image(bitmap);
}

std::string size_text(const StokesImage& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels with " +
           std::to_string(image.channels) + " channels";
}

}  // namespace

StokesImage read_angle_pictures(const std::array<std::filesystem::path, 4>& files) {
    StokesImage out = read_light(files[0]);
    std::array<std::vector<float>, 4> s0;
    for (std::size_t a = 0; a < 4; ++a) {
        const StokesImage light = a == 0 ? out : read_light(files[a]);
        if (light.width != out.width || light.height != out.height || light.channels != out.channels)
            invalid_file(files[a], "has " + size_text(light) + "; the first picture has " + size_text(out));
        for (std::size_t i = 0; i < light.data.size(); i += 4) s0[a].push_back(light.data[i]);
    }
    for (std::size_t i = 0; i < s0[0].size(); ++i) {
        const std::array<float, 4> stokes = stokes_of_angles({s0[0][i], s0[1][i], s0[2][i], s0[3][i]}, 0);
        std::copy(stokes.begin(), stokes.end(), out.data.begin() + static_cast<std::ptrdiff_t>(4 * i));
    }
    return out;
}

}  // namespace nicol
