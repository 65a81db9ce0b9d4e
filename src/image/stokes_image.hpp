// SPDX-License-Identifier: MIT
// Images whose pixels are Stokes vectors, and their OpenEXR files.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "files/load_budget.hpp"
#include "image/aovs.hpp"
#include "polarization/stokes.hpp"

namespace nicol {

/// Limits of an image: pixels (width times height), sides, and pixels times channels (8 GiB). A file that
/// claims more is refused before memory is allocated.
inline constexpr std::size_t kMaxImagePixels = std::size_t{3} << 26;  // 1.5 times 16384 x 8192
inline constexpr int kMaxImageSide = 32768;
inline constexpr std::size_t kMaxImageVectors = std::size_t{1} << 29;

/// Largest number of colour channels of a file.
inline constexpr int kMaxFileChannels = 16;

/// Image of Stokes vectors as 32-bit floats, data[channel][y][x][p] with p = 0..3 for s0..s3. Row 0 is the
/// top. The frame depends on the image's origin; for a rendered image x points right, y up and z from the
/// scene to the camera, so s2 > 0 at +45 degrees counter-clockwise as displayed.
struct StokesImage {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> data;
    /// Wavelengths of a spectral image in nanometres, one per channel. Empty for colours.
    std::vector<double> wavelengths;

    StokesImage() = default;
    /// Makes an image of zeros. Throws Error(invalid_argument) unless channels >= 1, 1 <= width, height <=
    /// kMaxImageSide, width * height <= kMaxImagePixels and width * height * channels <= kMaxImageVectors.
    StokesImage(int width, int height, int channels);

    /// Returns the four components of one pixel. Throws Error(invalid_argument) outside the image.
    [[nodiscard]] std::span<float, 4> at(int channel, int y, int x);
    [[nodiscard]] std::span<const float, 4> at(int channel, int y, int x) const;
    /// Returns the four components of one pixel as doubles. Throws Error(invalid_argument) outside the image.
    [[nodiscard]] Stokes stokes(int channel, int y, int x) const;

    /// Throws Error(invalid_argument) that names `what` unless the sizes are in range, `data` has channels *
    /// height * width * 4 elements, and `wavelengths` is empty or has one finite value > 0 per channel. Every
    /// function of the library that takes an image calls check().
    void check(const char* what) const;
};

/// Set of all Stokes components, as bits: 1 << p for s_p.
inline constexpr unsigned kStokesAll = 0b1111;

/// Options of write_exr().
struct ExrOptions {
    /// Components that get channels `S<p>.<colour>`, bits 1 << p. s0 is written in any case.
    unsigned components = kStokesAll;
    /// String attribute `stokesFrame`: the frame of the components. The default is right for rendered images.
    std::string frame =
        "x image right, y image up, z from the scene to the camera; s2 > 0 at +45 degrees "
        "counter-clockwise from x; s3 > 0 right circular";
    /// String attribute `comments`; none if empty.
    std::string comment{};
    /// AOVs of the image's size that are written as well; null: none. Depth is written as Z, normals as N.X
    /// N.Y N.Z, positions as P.X P.Y P.Z, instances as the uint channel id, coverage as A, the variance of
    /// each S<p>.<colour> as variance.S<p>.<colour>.
    const Aovs* aovs = nullptr;
};

/// Writes float32 channels, p = 0..3:
/// - three colour channels as Mitsuba 3 does, R G B (= s0) and S<p>.R S<p>.G S<p>.B; one channel as Y and
///   S<p>.Y;
/// - channels with increasing wavelengths in the layout of Fichet et al. (2021): S<p>.550,000000nm with the
///   attributes spectralLayoutVersion "1.0", emissiveUnits and polarisationHandedness "right";
/// - any other number of channels up to kMaxFileChannels as S<p>.0 S<p>.1 ...
/// `file` is open for writing and positioned; messages call it `name`. Throws Error(invalid_argument) for
/// more channels, unordered wavelengths or an empty image, and Error(write_failed).
void encode_exr(std::FILE* file, const std::string& name, const StokesImage& image,
                const ExrOptions& options = {});

/// Writes what encode_exr() writes. The file appears under its name only when it is complete; a failure
/// leaves the previous file. Throws what encode_exr() throws.
void write_exr(const std::filesystem::path& path, const StokesImage& image, const ExrOptions& options = {});

/// Reads the channels that write_exr() writes, as float, half or uint, in scan lines or tiles, in any
/// compression; from a multi-part file the first part. The image is the display window; its pixels outside
/// the data window are 0. s0 comes from S0.<colour>, or from R G B / Y if S0.<colour> is absent. Components
/// without channels are zero, but a file with any of S1..S3 must have S1 and S2 in every colour. Other
/// channels, such as A, are ignored.
///
/// A file with spectral channels is read as a spectral image, by increasing wavelength (names in m or Hz with
/// any prefix); its R G B are a preview. polarisationHandedness "left" means that s3 > 0 is left circular in
/// the file, so the sign of s3 is reversed. `wavelengths` (nm) selects, in this order, the nearest channels
/// of a spectral file and must lie within the file's range. Without `wavelengths` a file may have at most
/// kMaxFileChannels.
///
/// Throws Error(file_not_found); Error(unsupported) for deep or subsampled data, reflectances (T channels)
/// and too many wavelengths; Error(invalid_argument) for `wavelengths` that are out of range or given for a
/// file without wavelengths; Error(invalid_file) that names the missing, truncated or too large part, or the
/// first channel and pixel (x, y from the top left) that is not finite. Takes the memory of the image from
/// `budget` before it is allocated.
[[nodiscard]] StokesImage read_exr(const std::filesystem::path& path,
                                   std::span<const double> wavelengths = {}, const LoadBudget& budget = {});

}  // namespace nicol
