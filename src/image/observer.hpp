// SPDX-License-Identifier: MIT
// Observers: images of a camera, a polarizer or a polarimeter from a Stokes image.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "image/png.hpp"
#include "image/stokes_image.hpp"

namespace nicol {

/// Value of `channel` for the plain mean of the Stokes vectors of all channels (Stokes vectors of incoherent
/// light add). Functions of a single value per pixel take `channel`: a colour channel, or kMeanChannel.
/// Angles are in radians, counter-clockwise as displayed from image right (the x of the Stokes frame). All
/// functions throw Error(invalid_argument) for an image that is empty or inconsistent and for arguments out
/// of range. Values that are not finite count as 0.
inline constexpr int kMeanChannel = -1;

/// Image of 8-bit RGB, rgb[y][x][3], row 0 at the top, with its description.
struct Observation {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    /// Keyword and text of PNG tEXt chunks: Title, Nicol:Observer, Nicol:Scale, Nicol:Frame ...
    std::vector<std::pair<std::string, std::string>> text;
    /// Whether the values are sRGB-encoded (tone-mapped radiance, DoLP, AoLP); else they encode data
    /// linearly.
    bool srgb = false;
};

/// Image of one float per pixel, values[y][x], row 0 at the top.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;
};

/// Returns s0 times 2^exposure, clipped to 0..1, through the sRGB curve. One channel is grey, three are R G
/// B; other numbers of channels are refused.
[[nodiscard]] Observation tone_mapped(const StokesImage& image, double exposure = 0);

/// Returns s_p (component p = 0..3) as red for negative and green for positive values, linear, without any
/// gamma: code = round(255 min(|s_p| / scale, 1)). scale = 0 selects the largest |s_p| of the image (1 if all
/// are zero). The text of the observation records the scale.
[[nodiscard]] Observation signed_component(const StokesImage& image, int component, double scale = 0,
                                           int channel = kMeanChannel);

/// Returns the degree of linear polarization sqrt(s1^2 + s2^2) / s0, clipped to 0..1; 0 where s0 <= 0.
[[nodiscard]] Plane dolp(const StokesImage& image, int channel = kMeanChannel);
/// Returns dolp() as grey with the sRGB curve, so that weak polarization shows; 255 = 1.
[[nodiscard]] Observation dolp_image(const StokesImage& image, int channel = kMeanChannel);

/// Returns the angle of linear polarization atan2(s2, s1) / 2 in (-pi/2, pi/2]; 0 where s1 = s2 = 0 or s0 <=
/// 0.
[[nodiscard]] Plane aolp(const StokesImage& image, int channel = kMeanChannel);

/// Encoding of the DoLP in an AoLP image. Hue is AoLP / pi: horizontal red, +45 degrees yellow-green,
/// vertical cyan, -45 degrees violet.
enum class AolpStyle : std::int32_t {
    light = 0,  ///< saturation: unpolarized is white
    dark = 1,   ///< value, with the sRGB curve: unpolarized is black
    full = 2,   ///< no encoding: full colour wherever DoLP >= 1e-6, black elsewhere
};
[[nodiscard]] Observation aolp_image(const StokesImage& image, AolpStyle style = AolpStyle::light,
                                     int channel = kMeanChannel);

/// Returns s0 of through_polarizer() for one channel.
[[nodiscard]] Plane behind_polarizer(const StokesImage& image, double angle, int channel = kMeanChannel);
/// Returns the light behind an ideal linear polarizer whose transmission axis is at `angle`:
/// s0' = (s0 + s1 cos 2a + s2 sin 2a) / 2, fully polarized along the axis.
[[nodiscard]] StokesImage through_polarizer(const StokesImage& image, double angle);

/// Returns the luminance of BT.709's red, green and blue for each Stokes component. Because Stokes vectors of
/// incoherent light add, the result is the light that a grey sensor with the eye's sensitivity measures. The
/// image must have three channels.
[[nodiscard]] StokesImage luminance(const StokesImage& rgb);

/// Returns the observation as write_png() and encode_png() take it, with its text as tEXt chunks. The
/// observation must outlive the result.
[[nodiscard]] PngImage png_of(const Observation& observation);

}  // namespace nicol
