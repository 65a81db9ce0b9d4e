// SPDX-License-Identifier: MIT
// Distant light: radiance by direction, images, and PSH coefficients.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "files/load_budget.hpp"
#include "harmonics/psh.hpp"
#include "image/stokes_image.hpp"

namespace nicol {

/// Equirectangular image of light, stored over the directions the light comes FROM, y up. The direction
/// towards the light at (u, v) is (sin 2 pi u sin pi v, cos pi v, -cos 2 pi u sin pi v), so u = atan2(x, -z)
/// / (2 pi) (negative values wrap) and v = acos(y) / pi, as in Mitsuba's envmap. Columns are pixel-centred, u
/// = (x + 1/2) / width; rows are vertex-centred, v = y / (height - 1), so row 0 is the zenith. The light is
/// bilinear between pixels and periodic in u.
///
/// Stokes frame of a pixel: z = propagation (towards the scene), x = the horizontal direction of increasing u
/// seen from the scene's centre, y = z cross x (up in the image). The frame is the theta-phi frame of the
/// propagation direction about the y axis, rotated by +90 degrees, so s1 and s2 change sign between the two
/// frames.
struct EquirectImage : StokesImage {
    using StokesImage::StokesImage;
};

/// Equirectangular image in the caller's memory, in any order of pixels and channels: component p of channel
/// c at (x, y) is values[c * channel_stride + y * row_stride + x * pixel_stride + p].
struct EquirectView {
    int width = 0;
    int height = 0;
    int channels = 0;
    int components = 4;  ///< 1 (only s0) or 4
    const float* values = nullptr;
    std::size_t channel_stride = 0;
    std::size_t row_stride = 0;
    std::size_t pixel_stride = 0;
};

/// Distant light in world axes. Callers rotate the light: coefficients by rotated(), look-ups by the inverse
/// rotation. Immutable and thread-safe.
class Environment {
public:
    virtual ~Environment() = default;
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

    [[nodiscard]] virtual int channels() const noexcept = 0;
    /// Returns whether some s1, s2 or s3 is not zero. If the result is false, callers may skip s1, s2, s3.
    [[nodiscard]] virtual bool polarized() const noexcept = 0;
    /// Returns whether some s3 is not zero.
    [[nodiscard]] virtual bool circular() const noexcept = 0;
    /// Returns true only if the light is 0 in all directions.
    [[nodiscard]] virtual bool dark() const noexcept { return false; }
    /// Returns the wavelengths of spectral light in nanometres, one per channel. Empty for colours.
    [[nodiscard]] virtual const std::vector<double>& wavelengths() const noexcept;

    /// Returns, for an image, the negative radiance that was set to 0, divided by the positive radiance. Both
    /// are weighted by solid angle. The result is the largest of all channels.
    [[nodiscard]] virtual double negative_share() const noexcept { return 0; }

    /// Returns the radiance from the unit direction `towards_light`, in the theta-phi frame (about the
    /// world's z) of the propagation direction -towards_light: theta_phi_frame(-towards_light). Throws
    /// Error(invalid_argument) for a channel out of range or a direction that is not of unit length.
    [[nodiscard]] virtual Stokes radiance(int channel, const glm::dvec3& towards_light) const = 0;

    /// Returns coefficients over PROPAGATION directions in the world's axes (a light source on the +z side
    /// gives s0 at theta = pi). The coefficients of an image are those of the bilinear function that
    /// radiance() returns. Throws Error(invalid_argument) unless 0 <= order <= kMaxOrder.
    [[nodiscard]] virtual PshVector project(int order) const = 0;

    /// Returns the background. For an image: its own pixels times the scale.
    [[nodiscard]] virtual EquirectImage image() const = 0;

    /// Returns, for an image, the pixels of image(), which radiance() interpolates; they are valid as long as
    /// the light exists. For other light, `values` is null.
    [[nodiscard]] virtual EquirectView pixels() const noexcept { return {}; }

    /// Returns equal light with a fast radiance(), see psh_environment(); null if radiance() is fast already.
    [[nodiscard]] virtual std::unique_ptr<const Environment> tabulated() const { return nullptr; }

protected:
    Environment() = default;
};

using EnvironmentPtr = std::shared_ptr<const Environment>;

/// Returns the files that load_environment() reads for this path: the file itself, or the four files of a
/// cube map.
[[nodiscard]] std::vector<std::filesystem::path> environment_files(const std::filesystem::path& path,
                                                                   const FileSource& files = file_system());

/// Loads light from a file and multiplies its values by `scale`:
/// - `.npz`: coefficients, see read_psh_vector() and psh_environment();
/// - any of `NAME_s0.exr` ... `NAME_s3.exr`, or `NAME` if no file has that name: see read_cube_cross();
/// - a bitmap, see read_bitmap(): Radiance HDR, or PNG, JPEG, BMP, TGA as 0 to 1, decoded from sRGB;
/// - else an OpenEXR file in the layout of EquirectImage (see read_exr() for the channels): R G B or Y is
///   unpolarized light, S1 .. S3 make it polarized. `wavelengths` selects channels of spectral files.
/// Throws Error(invalid_argument) unless scale is finite and >= 0, or for `wavelengths` with a file that is
/// not spectral; what the readers throw; and what image_environment() throws, as Error(invalid_file) that
/// names the file. Takes the memory of the image from `budget`, which is checked during reading.
[[nodiscard]] EnvironmentPtr load_environment(const std::filesystem::path& path, double scale = 1,
                                              std::span<const double> wavelengths = {},
                                              const LoadBudget& budget = {});

/// Returns a notice about light whose radiance was negative somewhere, as in resampled images; "" if none
/// was.
[[nodiscard]] std::string notice_of_negative(const Environment& environment, const std::string& name);

/// Largest coefficient of light times its scale. Radiance is stored in single precision, which can hold the
/// products with materials and the sums of light up to this brightness.
inline constexpr double kBrightestLight = 1e30;
/// Throws Error(invalid_argument) unless all coefficients times `scale` are finite and within
/// kBrightestLight.
void check_brightness(const PshVector& light, double scale);

/// Writes image() as OpenEXR in the layout of EquirectImage, see write_exr(). Unpolarized light is written
/// without S1 .. S3. Throws what write_exr() throws.
void write_environment(const std::filesystem::path& path, const Environment& environment);

/// Returns the light of an equirectangular image, its values multiplied by `scale`. Throws
/// Error(invalid_argument) unless the image is at least 2 x 2, all values are finite, s0 is not negative, and
/// the polarized part is physically realizable up to rounding and compression: sqrt(s1^2 + s2^2 + s3^2) <=
/// 1.01 s0 + 1e-3 times the largest s0 of the channel.
///
/// Colours outside a file's gamut and the overshoot of lossy compression make pixels negative, in images of
/// the sun as far below zero as a seventh of the largest value. Unpolarized pixels with s0 < 0 are therefore
/// set to 0, which makes the light slightly brighter. A channel is refused if its negative pixels, weighted
/// by solid angle, exceed a quarter of its positive pixels.
[[nodiscard]] EnvironmentPtr image_environment(const EquirectImage& image, double scale = 1);
/// Copies the view. Throws what image_environment(image) throws, and Error(invalid_argument) for sizes that
/// StokesImage refuses, components other than 1 and 4, and values == nullptr.
[[nodiscard]] EnvironmentPtr image_environment(const EquirectView& view, double scale = 1);

/// Returns image_environment(view)->project(order), without a copy if no pixel is negative. Throws what
/// image_environment(view) and Environment::project() throw.
[[nodiscard]] PshVector project_image(const EquirectView& view, int order);

/// Returns the light of coefficients in the world's axes. radiance() evaluates them, project() truncates them
/// or pads them with zeros, image() synthesizes (without orders above 1023). tabulated() is an image of 16
/// columns per order, 512 to 4096 in all, interpolated bilinearly, with an RMS error of 0.8 % for random
/// light up to order 255 and less for smoother light. Truncated light rings: s0 may be negative and Eq. 70
/// violated. Throws Error(invalid_argument) unless all coefficients are finite, there is a channel, p = 1, 2
/// vanish below l = 2, and `wavelengths` is empty or has one value per channel.
[[nodiscard]] EnvironmentPtr psh_environment(PshVector coefficients, std::vector<double> wavelengths = {});

/// Returns unpolarized light of one radiance in all directions. `radiance` has one value per channel, finite
/// and >= 0; at least one.
[[nodiscard]] EnvironmentPtr constant_environment(std::vector<double> radiance);

/// Clear sky without the sun's own disc. With g the angle between the view and the sun, its degree of linear
/// polarization is dop_max sin^2 g / (1 + cos^2 g), its electric field is along sun x view, and its s3 is 0.
///
/// turbidity 0: light scattered once by small particles, s0 = radiance 3/4 (1 + cos^2 g), so that `radiance`
/// is the mean over the sphere. The formula is also used below the horizon, so that the light has no order
/// above 2 and projects exactly. A ground has to be part of the scene's geometry.
///
/// turbidity 1.7 (very clear) to 10 (hazy): luminance and colour by Perez's formula with the coefficients of
/// Preetham et al. (1999), scaled so that the mean luminance over the upper half is 1, times `radiance`.
/// Three channels get linear sRGB (clipped below 0); with any other number, each channel gets the luminance.
/// Up is +y. Below the horizon is a ground that reflects ground_albedo of each channel's irradiance,
/// unpolarized and uniform. The sky is an image_environment() of 1024 x 513 pixels.
struct RayleighSky {
    glm::dvec3 sun_direction{0, 1, 0};      ///< towards the sun, any length but 0; y >= 0 with turbidity
    double dop_max = 0.8;                   ///< 0..1, reached 90 degrees from the sun
    std::vector<double> radiance{1, 1, 1};  ///< one per channel, finite and >= 0
    double turbidity = 0;                   ///< 0, or 1.7 to 10
    /// Albedo of the ground, used with turbidity: 0..1, one for all channels or one per channel.
    std::vector<double> ground_albedo{0.2};
};
/// Returns the unit vector to the sun. Throws Error(invalid_argument) that names the member that is out of
/// range.
[[nodiscard]] glm::dvec3 unit_sun(const RayleighSky& sky);
/// Throws what unit_sun() throws.
[[nodiscard]] EnvironmentPtr rayleigh_sky(const RayleighSky& sky);

}  // namespace nicol
