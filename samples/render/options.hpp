// SPDX-License-Identifier: MIT
// The command line of nicol-render.
#pragma once

#include <nicol.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/failure.hpp"

/// Name of the standard output for --output and --stats.
inline constexpr const char* kStandardOutput = "-";

struct Options {
    enum class Action { render, help, version, list_devices };
    Action action = Action::render;
    std::string scene;
    std::string output;                    ///< file or kStandardOutput
    std::vector<std::string> definitions;  ///< "name=value"
    struct Shutter {
        double open = 0, close = 0;  ///< times of the scene's animation, seconds
        std::uint32_t samples = 16;  ///< number of pictures

        /// Returns the time of a picture, counted from 0.
        [[nodiscard]] double time_of(std::uint32_t picture) const {
            return open + (close - open) * (picture + 0.5) / samples;
        }
    };
    std::optional<Shutter> shutter;  ///< none: a picture of one moment
    std::string environment;         ///< file; empty: the environment of the scene
    double rotate_environment = 0;   ///< degrees about the world's y, counter-clockwise seen from above
    std::vector<double> look_at;     ///< empty, or place and target of the camera, and its fov in degrees
    double exposure = 0;             ///< exposure of --images, stops
    std::string images;              ///< folder; empty: none
    std::vector<double> polarizers;  ///< angles of polarizer images in that folder, degrees
    std::string mosaic;              ///< file of the raw image; empty: none
    std::string sensor;              ///< file; empty: the library's default
    std::uint64_t frame = 0;         ///< number of the raw image's noise
    std::string stats;               ///< file or kStandardOutput; empty: none
    nicol_backend backend = NICOL_BACKEND_AUTOMATIC;
    std::uint32_t device = 0;  ///< number in the library's list; 0: any
    std::uint32_t aovs = 0;    ///< NICOL_AOV_...
    std::optional<nicol_quality> quality;
    nicol_method method = NICOL_METHOD_FACTORED;
    nicol_executor executor = NICOL_EXECUTOR_AUTOMATIC;
    std::optional<std::uint32_t> order_low, order_high;
    nicol_high_orders high_orders = NICOL_HIGH_ORDERS_SPLIT;
    nicol_shade_at shade_at = NICOL_SHADE_AT_AUTOMATIC;
    std::optional<std::uint32_t> pixel_samples;  ///< none: by quality, or as the scene asks
    std::optional<nicol_filter_kind> filter;     ///< none: as the scene asks
    std::optional<double> tolerance;
    nicol_components components = NICOL_COMPONENTS_ALL;
    bool frame_all = false;
    bool shadows = true;
    bool physical = true;
    double dering = 0;
    std::optional<std::uint32_t> bake_directions;
    std::optional<double> refine_tolerance;
    std::uint32_t max_vertices = 0;  ///< 0: the library's default
    std::int32_t split_lights = NICOL_SPLIT_AUTOMATIC;
    std::optional<std::uint32_t> light_samples;
    std::optional<std::uint32_t> bsdf_samples;
    std::optional<std::uint32_t> samples;                            ///< number for the reference method
    std::optional<std::int32_t> max_depth;                           ///< none: as the scene asks
    std::uint64_t seed = 0;                                          ///< seed for the reference method
    nicol_context_options load_limits = NICOL_CONTEXT_OPTIONS_INIT;  ///< only its limits of loading are used
    std::string cache;                           ///< folder; empty: NICOL_CACHE or the user's
    std::optional<std::uint32_t> width, height;  ///< both or neither
};

/// Text of --help.
extern const char* const usage;

/// Parses the command line. Throws Failure naming the argument and the valid values.
Options parse_options(int argc, const char* const* argv);
