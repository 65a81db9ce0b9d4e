// SPDX-License-Identifier: MIT
// Polarized cube maps unfolded into a cross, with one file per Stokes component.
#pragma once

#include <filesystem>
#include <optional>

#include "light/environment.hpp"

namespace nicol {

/// Cube map as a cross of 4 edge x 3 edge pixels, stored over the directions the light comes FROM, z up:
///
///              Up +z
///     Left -x  Front +y  Right +x  Back -y
///              Down -z
///
/// Each face is the image of a camera at the centre, right and up as displayed; Up and Down join Front. The
/// six cells without a face are ignored. Pixel centres of a face are at (i + 1/2) / edge of its square on the
/// cube.
///
/// Stokes frame of a pixel: z = propagation (towards the centre), y = the component of the face's image up
/// that is perpendicular to z, x = y cross z, which is image right. The files `NAME_s0.exr` .. `NAME_s3.exr`
/// of the Python package polarsh have this frame: with this frame, and with no other candidate, the spin-2
/// coefficients of the package's 64-pixel cube maps agree with the coefficients that it ships for the same
/// light.
struct CubeCross : StokesImage {
    using StokesImage::StokesImage;
    /// Throws what StokesImage::check() throws, and Error(invalid_argument) that names `what` unless width :
    /// height = 4 : 3 and an edge has at least 2 pixels.
    void check(const char* what) const;
};

/// Unit direction towards the light, in the world, and Stokes frame at column x, row y of a cross, in pixels;
/// x = 0.5 is the centre of the first column. cube_point() throws Error(invalid_argument) for a cell without
/// a face.
struct CubePoint {
    glm::dvec3 towards_light;
    Frame frame;
};
[[nodiscard]] CubePoint cube_point(int edge, double x, double y);

/// Returns "NAME" for "NAME_s0.exr" .. "NAME_s3.exr"; nothing for other paths.
[[nodiscard]] std::optional<std::filesystem::path> cube_cross_stem(const std::filesystem::path& file);

/// Returns "NAME_s<component>.exr".
[[nodiscard]] std::filesystem::path cube_cross_file(const std::filesystem::path& stem, int component);

/// Reads the four files, given the path of one of them, `NAME_s0.exr` .. `NAME_s3.exr`, or `NAME`. Each file
/// has R G B, Y or S0 channels. Throws what read_exr() throws; Error(file_not_found) that names the missing
/// file; Error(invalid_file) that names the file whose size or channels differ from the file of s0, or that
/// is no 4 : 3 cross.
[[nodiscard]] CubeCross read_cube_cross(const std::filesystem::path& path, const LoadBudget& budget = {});

/// Returns the light of a cross as an equirectangular image of the world, y up, of 8 edge columns (4 edge if
/// edge is above 256). The interpolation is bilinear on the cube, also across its edges. Parallel transport
/// rotates each pixel into the frame of the interpolated direction.
[[nodiscard]] EquirectImage equirect_from_cross(const CubeCross& cross, const LoadBudget& budget = {});

/// Writes `NAME_s0.exr` .. `NAME_s3.exr` with faces of `edge` pixels. Each file has float channels R G B (or
/// those that write_exr() writes for other numbers of channels). Throws Error(invalid_argument) unless 2 <=
/// edge <= 4096, and what write_exr() throws.
void write_cube_cross(const std::filesystem::path& name, const Environment& environment, int edge);

}  // namespace nicol
