// SPDX-License-Identifier: MIT
// A request for an image of a scene, as numbers; used by the front process and the workers.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "query.hpp"

enum class Format : std::uint32_t { png, exr, stokes_exr, stokes_planes, stokes_f16, stokes_f32 };
enum class Observer : std::uint32_t { s0, s1, s2, s3, dolp, aolp, polarizer };
/// Whether the format is an image of an observer, not Stokes vectors.
constexpr bool has_observer(Format format) {
    return format == Format::png || format == Format::exr;
}
enum class CameraKind : std::uint32_t { scene, orbit, matrix };

/// A camera that looks at a target from an azimuth and an elevation in degrees. Azimuth 0 is the axis after
/// the vertical one in x, y, z, x: z for scenes with y up.
struct Orbit {
    double azimuth = 0, elevation = 0, distance = 1;
    std::array<double, 3> target{};

    bool operator==(const Orbit&) const = default;
};

/// The part of a request that determines the rendering; images of equal views differ only in the observer.
/// Plain data.
struct View {
    CameraKind camera = CameraKind::scene;
    std::uint32_t scene = 0;  ///< index
    std::uint32_t width = 0, height = 0;
    Orbit orbit;                      ///< of CameraKind::orbit
    std::array<double, 16> matrix{};  ///< of CameraKind::matrix
    double fov = 0;                   ///< degrees; 0: the scene's
    double light = 0,
           light_tilt = 0;  ///< degrees about the vertical, then about azimuth 90's horizontal axis
    std::int32_t order_low = -1, order_high = -1;  ///< -1: the library's default
    double tolerance = 0;                          ///< 0: the library's default

    bool operator==(const View&) const = default;
};

struct ImageRequest {
    View view;
    Format format = Format::png;
    Observer observer = Observer::s0;  ///< of png and exr
    double polarizer = 0;              ///< degrees in [0, 180)
    double exposure = 0;               ///< stops; of s0 and polarizer
    double scale = 0;                  ///< of s1, s2, s3; 0: the largest of the image
    std::uint32_t bits = 0;            ///< of stokes_planes: how finely they are rounded; 0: not at all
    bool deflate = false;              ///< of stokes_planes: compressed
};

/// A scene as its worker found it.
struct SceneInfo {
    std::string id;  ///< of the URL: the file's name without .xml
    /// Of its files, hexadecimal; empty where they cannot be loaded, and then the rest means nothing.
    std::string digest;
    std::uint32_t channels = 1;
    std::uint32_t width = 1, height = 1;  ///< of its film
    std::uint32_t up = 1;                 ///< the vertical axis: 0 is x, 1 is y, 2 is z
    double fov = 45;
    Orbit orbit;  ///< of its camera

    bool operator==(const SceneInfo&) const = default;
};

/// Set by flags.
struct Limits {
    std::uint32_t max_side = 2048;
    std::uint32_t max_pixels = 2048 * 1024;
    std::int32_t max_order = 16;
};

/// "png" and so on for the end of a path; nothing else is known there.
struct Resource {
    Format format;
    std::string_view name;  ///< "image.png"
    std::string_view type;  ///< of its content
};
extern const std::array<Resource, 6> resources;
const Resource& resource_of(Format format);

/// Throws Refusal (400) naming the parameter and its range; a parameter that is not known is refused too.
ImageRequest parse_image(const Target& target, Format format, std::uint32_t scene, const SceneInfo& info,
                         const Limits& limits);

/// The size in bytes that the answer to the request is at most.
std::size_t most_bytes(const ImageRequest& request, const SceneInfo& info);

/// One text for all requests that have the same answer, and another for each other one.
std::string canonical(const ImageRequest& request, const SceneInfo& info);
