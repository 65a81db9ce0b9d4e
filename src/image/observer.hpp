// SPDX-License-Identifier: MIT
// Observers: images of a camera, a polarizer or a polarimeter from a Stokes image.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "image/stokes_image.hpp"

namespace nicol {

/// Angles are radians, counter-clockwise as displayed from image right (the x of the Stokes frame).
/// Functions of a single value a pixel take `channel`: a colour channel, or kMeanChannel for the plain mean
/// of the Stokes vectors of all channels (Stokes vectors of incoherent light add). All throw
/// Error(invalid_argument) for an image that is empty or inconsistent and for arguments out of range.
/// Values that are not finite count as 0.
inline constexpr int kMeanChannel = -1;

/// 8-bit RGB, rgb[y][x][3], row 0 at the top, with its description.
struct Observation {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    /// Keyword and text of PNG tEXt chunks: Title, Nicol:Observer, Nicol:Scale, Nicol:Frame ...
    std::vector<std::pair<std::string, std::string>> text;
    /// The values are sRGB-encoded (tone-mapped radiance); otherwise they encode data linearly.
    bool srgb = false;
};

/// One float a pixel, values[y][x], row 0 at the top.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;
};

/// s0 times 2^exposure, clipped to 0..1, through the sRGB curve. One channel is grey, three are R G B; other
/// numbers of channels are refused.
[[nodiscard]] Observation tone_mapped(const StokesImage& image, double exposure = 0);

/// s_p (component p = 0..3) as red for negative and green for positive values, linear, without any gamma:
/// code = round(255 min(|s_p| / scale, 1)). scale = 0 takes the largest |s_p| of the image (1 if all is
/// zero); the scale used is in the text.
[[nodiscard]] Observation signed_component(const StokesImage& image, int component, double scale = 0,
                                           int channel = kMeanChannel);

/// Degree of linear polarization sqrt(s1^2 + s2^2) / s0, clipped to 0..1; 0 where s0 <= 0.
[[nodiscard]] Plane dolp(const StokesImage& image, int channel = kMeanChannel);
/// The same as linear grey, 255 = 1.
[[nodiscard]] Observation dolp_image(const StokesImage& image, int channel = kMeanChannel);

/// Angle of linear polarization atan2(s2, s1) / 2 in (-pi/2, pi/2]; 0 where s1 = s2 = 0 or s0 <= 0.
[[nodiscard]] Plane aolp(const StokesImage& image, int channel = kMeanChannel);

/// What encodes the DoLP in an AoLP image. Hue is AoLP / pi: horizontal red, +45 degrees yellow-green,
/// vertical cyan, -45 degrees violet.
enum class AolpStyle : std::int32_t {
    light = 0,  ///< saturation: unpolarized is white
    dark = 1,   ///< value: unpolarized is black
    full = 2,   ///< nothing: full colour wherever DoLP >= 1e-6, black elsewhere
};
[[nodiscard]] Observation aolp_image(const StokesImage& image, AolpStyle style = AolpStyle::light,
                                     int channel = kMeanChannel);

/// The light behind an ideal linear polarizer whose transmission axis stands at `angle`:
/// s0' = (s0 + s1 cos 2a + s2 sin 2a) / 2, fully polarized along the axis.
[[nodiscard]] StokesImage through_polarizer(const StokesImage& image, double angle);

/// Red, green and blue of BT.709 to their luminance, of each Stokes component: Stokes vectors of incoherent
/// light add, so this is the light that a grey sensor with the eye's sensitivity measures. The image must
/// have three channels.
[[nodiscard]] StokesImage luminance(const StokesImage& rgb);

/// Writes a PNG with the observation's text as tEXt chunks, and an sRGB chunk if `srgb`. The file appears
/// under its name only when complete. Throws Error(invalid_argument) if the sizes do not fit, or a keyword or
/// text is not fit for tEXt (keyword 1 to 79 bytes); Error(write_failed) naming the path.
void write_png(const std::filesystem::path& path, const Observation& observation);

}  // namespace nicol
