// SPDX-License-Identifier: MIT
// Polarized cube maps unfolded into a cross, one file for each Stokes component.
#pragma once

#include <filesystem>
#include <optional>

#include "light/environment.hpp"

namespace nicol {

/// A cube map as a cross of 4 edge x 3 edge pixels, stored over the directions the light comes FROM, z up:
///
///              Up +z
///     Left -x  Front +y  Right +x  Back -y
///              Down -z
///
/// Each face is the image of a camera at the centre, right and up as displayed; Up and Down join Front. The
/// other six cells are ignored. Pixel centres of a face are at (i + 1/2) / edge of its square on the cube.
///
/// Stokes frame of a pixel: z = propagation (towards the centre), y = the face's image up as far as it is
/// perpendicular to z, x = y cross z: image right. This is the frame of the files `NAME_s0.exr` ..
/// `NAME_s3.exr` of the Python package polarsh: with it, and with no other of the candidates, the spin-2
/// coefficients of its 64-pixel cube maps agree with those it ships of the same light.
struct CubeCross : StokesImage {
    using StokesImage::StokesImage;
    /// Throws as StokesImage::check(), and Error(invalid_argument) naming `what` unless width : height = 4 :
    /// 3 and an edge has at least 2 pixels.
    void check(const char* what) const;
};

/// The world direction (unit length) towards the light and the Stokes frame at column x, row y of a cross, in
/// pixels; x = 0.5 is the centre of the first. Throws Error(invalid_argument) for a cell without a face.
struct CubePoint {
    glm::dvec3 towards_light;
    Frame frame;
};
[[nodiscard]] CubePoint cube_point(int edge, double x, double y);

/// "NAME" of "NAME_s0.exr" .. "NAME_s3.exr"; none for other paths.
[[nodiscard]] std::optional<std::filesystem::path> cube_cross_stem(const std::filesystem::path& file);

/// "NAME_s<component>.exr".
[[nodiscard]] std::filesystem::path cube_cross_file(const std::filesystem::path& stem, int component);

/// The four files, given the path of one of them, `NAME_s0.exr` .. `NAME_s3.exr`, or `NAME`. Each has R G B,
/// Y or S0 channels. Throws what read_exr() throws; Error(file_not_found) naming the file that is missing;
/// Error(invalid_file) naming the file whose size or channels differ from those of s0, or that is no 4 : 3
/// cross.
[[nodiscard]] CubeCross read_cube_cross(const std::filesystem::path& path, const LoadBudget& budget = {});

/// The same light as an equirectangular image of the world, y up, of 8 edge columns (4 edge above edge
/// 256): bilinear on the cube, across its edges too, each pixel rotated by parallel transport into the frame
/// where it is needed.
[[nodiscard]] EquirectImage equirect_from_cross(const CubeCross& cross, const LoadBudget& budget = {});

/// Writes `NAME_s0.exr` .. `NAME_s3.exr` with faces of `edge` pixels, each file float R G B (or as
/// write_exr() does for other numbers of channels). Throws Error(invalid_argument) unless 2 <= edge <= 4096,
/// and as write_exr().
void write_cube_cross(const std::filesystem::path& name, const Environment& environment, int edge);

}  // namespace nicol
