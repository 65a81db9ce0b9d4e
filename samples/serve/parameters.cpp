// SPDX-License-Identifier: MIT
#include "parameters.hpp"

#include <charconv>
#include <cmath>

#include "json.hpp"
#include "problem.hpp"

namespace {

using Kind = Parameter::Kind;
using Of = Parameter::Of;

constexpr double kFarthest = 1e6;

}  // namespace

bool Parameter::applies_to(Format format) const {
    if (of == Of::planes) return format == Format::stokes_planes;
    return of == Of::every || has_observer(format);
}

std::string Parameter::range() const {
    std::string span = json_number(least) + " to " + json_number(most);
    switch (kind) {
        case Kind::number:
            return span;
        case Kind::whole:
            return "whole numbers from " + span;
        case Kind::numbers:
            return std::to_string(count) + " numbers from " + span + ", separated by commas";
        case Kind::size:
            return "WIDTHxHEIGHT, each " + span;
        default: {
            std::string text;
            for (const std::string& choice : choices) text += (text.empty() ? "" : ", ") + choice;
            return text;
        }
    }
}

std::vector<Parameter> parameters(const Limits& limits) {
    std::vector<Parameter> table = {
        {.name = "size",
         .kind = Kind::size,
         .least = 1,
         .most = static_cast<double>(limits.max_side),
         .description = "Pixels; at most " + std::to_string(limits.max_pixels) +
                        " in all. Without it the scene's film, made smaller where it is too large."},
        {.name = "azimuth",
         .least = -360,
         .most = 360,
         .description = "Of an orbiting camera, degrees about the vertical."},
        {.name = "elevation",
         .least = -89,
         .most = 89,
         .description = "Of an orbiting camera, degrees above the horizon."},
        {.name = "distance",
         .least = 1e-3,
         .most = kFarthest,
         .description = "Of an orbiting camera from its target, in units of the scene."},
        {.name = "target",
         .kind = Kind::numbers,
         .least = -kFarthest,
         .most = kFarthest,
         .count = 3,
         .description = "The point x,y,z around which the camera orbits."},
        {.name = "matrix",
         .kind = Kind::numbers,
         .least = -kFarthest,
         .most = kFarthest,
         .count = 16,
         .description = "Camera to world, row by row, instead of an orbit: x to the image's left, y up, z "
                        "forward."},
        {.name = "fov", .least = 1, .most = 170, .description = "The horizontal field of view in degrees."},
        {.name = "light",
         .least = -360,
         .most = 360,
         .description = "Rotates the light about the vertical, degrees."},
        {.name = "light_tilt",
         .least = -180,
         .most = 180,
         .description = "Then tilts it about a horizontal axis, degrees."},
        {.name = "order_low",
         .kind = Kind::whole,
         .least = 0,
         .most = static_cast<double>(limits.max_order),
         .description = "Order of the light that meets the material's full detail."},
        {.name = "order_high",
         .kind = Kind::whole,
         .least = 0,
         .most = static_cast<double>(limits.max_order),
         .description = "Order of the light that is rendered at all."},
        {.name = "tolerance",
         .least = 1e-4,
         .most = 1,
         .description = "Instead of orders: the error that those left out may cause, relative RMSE."},
        {.name = "samples",
         .kind = Kind::whole,
         .least = 1,
         .most = 64,
         .description = "Samples per pixel: more make smoother edges and take longer. Without it 1."},
        {.name = "observer",
         .kind = Kind::choice,
         .choices = {"s0", "s1", "s2", "s3", "dolp", "aolp", "polarizer"},
         .description = "What is looked at.",
         .of = Of::images},
        {.name = "polarizer",
         .least = -360,
         .most = 360,
         .description =
             "The light behind a linear polarizer at this angle, degrees counter-clockwise from the "
             "image's right.",
         .of = Of::images},
        {.name = "exposure",
         .least = -20,
         .most = 20,
         .description = "Stops; of s0 and polarizer.",
         .of = Of::images},
        {.name = "scale",
         .least = 1e-6,
         .most = kFarthest,
         .description = "Of s1, s2 and s3 as PNG: the value at full colour. Without it the largest of the "
                        "image.",
         .of = Of::images},
        {.name = "bits",
         .kind = Kind::whole,
         .least = 1,
         .most = 10,
         .description =
             "Rounds each Stokes vector to multiples of this power of 1/2, times the power of two at or "
             "below s0. Without it nothing is rounded.",
         .of = Of::planes},
    };
    return table;
}

void refuse_parameter(const Parameter& parameter, const std::string& detail) {
    throw Refusal({.status = 400, .detail = detail, .parameter = parameter.name, .range = parameter.range()});
}

double parse_number(const Parameter& parameter, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool number = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
    if (!number || (parameter.kind == Kind::whole && value != std::floor(value)))
        refuse_parameter(
            parameter,
            "The value is not a " + std::string(parameter.kind == Kind::whole ? "whole number." : "number."));
    if (value < parameter.least || value > parameter.most)
        refuse_parameter(parameter, "The value lies outside its range.");
    return value;
}

std::vector<double> parse_numbers(const Parameter& parameter, std::string_view text) {
    std::vector<double> values;
    for (;;) {
        const std::size_t comma = text.find(',');
        values.push_back(parse_number(parameter, text.substr(0, comma)));
        if (comma == std::string_view::npos) break;
        text = text.substr(comma + 1);
    }
    if (values.size() != static_cast<std::size_t>(parameter.count))
        refuse_parameter(parameter, "There are " + std::to_string(values.size()) + " numbers.");
    return values;
}

std::pair<std::uint32_t, std::uint32_t> parse_size(const Parameter& parameter, std::string_view text,
                                                   const Limits& limits) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) refuse_parameter(parameter, "The value is not a size.");
    const auto side = [&](std::string_view part) {
        std::uint32_t value = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (error != std::errc() || end != part.data() + part.size())
            refuse_parameter(parameter, "The value is not a size.");
        if (value < 1 || value > limits.max_side)
            refuse_parameter(parameter, "The value lies outside its range.");
        return value;
    };
    const std::uint32_t width = side(text.substr(0, cross)), height = side(text.substr(cross + 1));
    if (std::uint64_t{width} * height > limits.max_pixels)
        throw Refusal({.status = 400,
                       .detail = "The image has too many pixels.",
                       .parameter = parameter.name,
                       .range = "at most " + std::to_string(limits.max_pixels) + " pixels"});
    return {width, height};
}

std::size_t parse_choice(const Parameter& parameter, std::string_view text) {
    for (std::size_t i = 0; i < parameter.choices.size(); ++i)
        if (parameter.choices[i] == text) return i;
    refuse_parameter(parameter, "The value is none of those that are known.");
}
