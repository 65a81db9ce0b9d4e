// SPDX-License-Identifier: MIT
// A request for an image of a scene, as numbers, used by the front process and the workers.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "query.hpp"

enum class Format : std::uint32_t { png, exr, stokes_exr, stokes_planes, stokes_f16, stokes_f32 };
enum class Observer : std::uint32_t { s0, s1, s2, s3, dolp, aolp, polarizer };
/// Returns whether the format is an image of an observer, not Stokes vectors.
constexpr bool has_observer(Format format) {
    return format == Format::png || format == Format::exr;
}
enum class CameraKind : std::uint32_t { scene, orbit, matrix };

/// A camera that looks at a target from an azimuth and an elevation in degrees. Azimuth 0 is the axis after
/// the vertical axis in x, y, z, x: z for scenes with y up.
struct Orbit {
    double azimuth = 0, elevation = 0, distance = 1;
    std::array<double, 3> target{};

    bool operator==(const Orbit&) const = default;
};

/// The part of a request that determines the rendering, as plain data. Images of equal views differ only in
/// the observer.
struct View {
    CameraKind camera = CameraKind::scene;
    std::uint32_t scene = 0;  ///< index in the folder
    std::uint32_t width = 0, height = 0;
    Orbit orbit;                      ///< used by CameraKind::orbit
    std::array<double, 16> matrix{};  ///< used by CameraKind::matrix
    double fov = 0;                   ///< in degrees; 0: the scene's
    double light = 0,
           light_tilt = 0;  ///< in degrees, about the vertical, then about azimuth 90's horizontal axis
    std::int32_t order_low = -1, order_high = -1;  ///< -1: the library's default
    double tolerance = 0;                          ///< 0: the library's default
    std::uint32_t samples = 1;                     ///< per pixel

    bool operator==(const View&) const = default;
};

struct ImageRequest {
    View view;
    Format format = Format::png;
    Observer observer = Observer::s0;  ///< for png and exr
    double polarizer = 0;              ///< degrees in [0, 180)
    double exposure = 0;               ///< in stops, for s0 and polarizer
    double scale = 0;                  ///< for s1, s2, s3; 0: the largest value of the image
    std::uint32_t bits = 0;            ///< precision of rounding for stokes_planes; 0: not rounded
    bool deflate = false;              ///< compression of stokes_planes
};

/// Description of a scene by the worker that loaded it.
struct SceneInfo {
    std::string id;  ///< part of the URL: the file's name without .xml
    /// Digest of the files, hexadecimal. Empty if they cannot be loaded; the remaining fields are then
    /// undefined.
    std::string digest;
    std::uint32_t channels = 1;
    std::uint32_t width = 1, height = 1;  ///< size of the film, in pixels
    std::uint32_t up = 1;                 ///< vertical axis: 0 is x, 1 is y, 2 is z
    double fov = 45;
    Orbit orbit;  ///< orbit of the scene's camera

    bool operator==(const SceneInfo&) const = default;
};

/// Limits of requests, set by flags.
struct Limits {
    std::uint32_t max_side = 2048;
    std::uint32_t max_pixels = 2048 * 1024;
    std::int32_t max_order = 16;
};

/// A kind of image. Paths end in one of these names only.
struct Resource {
    Format format;
    std::string_view name;  ///< such as "image.png"
    std::string_view type;  ///< media type of the content
};
extern const std::array<Resource, 6> resources;
const Resource& resource_of(Format format);

/// Parses a request. Throws Refusal (400) naming the parameter and its range; unknown parameters are refused,
/// too.
ImageRequest parse_image(const Target& target, Format format, std::uint32_t scene, const SceneInfo& info,
                         const Limits& limits);

/// Returns an upper bound of the answer's size in bytes.
std::size_t most_bytes(const ImageRequest& request, const SceneInfo& info);

/// Returns a text that is equal exactly for requests with equal answers.
std::string canonical(const ImageRequest& request, const SceneInfo& info);
