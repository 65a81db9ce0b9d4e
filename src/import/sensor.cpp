// SPDX-License-Identifier: MIT
// <sensor> and its <film>.
#include <charconv>
#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>

#include "import/plugin.hpp"
#include "import/readers.hpp"
#include "import/values.hpp"

namespace nicol {

namespace scene {
namespace {

constexpr int kMaxSize = 32768;

/// Reads the part of the film that is rendered.
void read_crop(Plugin& film, SensorDescription& sensor) {
    struct Axis {
        const char* offset;
        const char* size;
        int whole;
    };
    SensorDescription::Crop crop;
    glm::length_t i = 0;
    for (const Axis& axis : {Axis{"crop_offset_x", "crop_width", sensor.width},
                             Axis{"crop_offset_y", "crop_height", sensor.height}}) {
        crop.offset[i] = film.integer(axis.offset, 0, 0, axis.whole - 1);
        const int left = axis.whole - crop.offset[i];
        crop.size[i] = film.integer(axis.size, left, 1, left);
        ++i;
    }
    if (crop.size != glm::ivec2(sensor.width, sensor.height)) sensor.crop = crop;
}

/// Images are EXR files of 32-bit floats.
void read_format(Plugin& film, pugi::xml_node node, SensorDescription& sensor, Notices& notices) {
    enum { luminance, luminance_alpha, rgb, rgba, xyz, xyza };
    const std::vector<std::string> formats = {"luminance", "luminance_alpha", "rgb", "rgba", "xyz", "xyza"};
    const std::size_t format = film.choice("pixel_format", rgb, formats);
    if (format == xyz || format == xyza)
        film.fail("pixel_format", "is " + formats[format] + "; supported are rgb and luminance",
                  ErrorCode::unsupported);
    sensor.luminance = format == luminance || format == luminance_alpha;
    if (format == luminance_alpha || format == rgba)
        notices.add(node, "pixel_format " + formats[format] + ": images have no alpha channel");
    const std::vector<std::string> components = {"float32", "float16", "uint32"};
    const std::size_t component = film.choice("component_format", 0, components);
    if (component != 0)
        notices.add(node, "component_format " + components[component] + ": images are written as float32");
    if (film.choice("file_format", 0, {"openexr", "exr", "rgbe", "pfm"}) > 1)
        film.fail("file_format", "is not openexr, the only one that is written", ErrorCode::unsupported);
}

ReconstructionFilter read_filter(const XmlDocument& document, pugi::xml_node node) {
    using Kind = ReconstructionFilter::Kind;
    Plugin plugin(document, node);
    ReconstructionFilter filter;
    constexpr double most = ReconstructionFilter::kMostRadius;
    if (plugin.type() == "box") {
        filter.kind = Kind::box;
    } else if (plugin.type() == "gaussian") {
        filter = {.kind = Kind::gaussian, .size = plugin.number("stddev", 0.5, 0.125, most / 4)};
    } else if (plugin.type() == "tent") {
        filter = {.kind = Kind::tent,
                  .size = plugin.number("radius", 1, ReconstructionFilter::kLeastRadius, most)};
    } else if (plugin.type() == "mitchell") {
        filter.kind = Kind::mitchell;
        filter.b = plugin.number("B", filter.b, 0, 1);
        filter.c = plugin.number("C", filter.c, 0, 1);
    } else if (plugin.type() == "catmullrom") {
        filter.kind = Kind::catmullrom;
    } else if (plugin.type() == "lanczos") {
        filter = {.kind = Kind::lanczos,
                  .size = static_cast<double>(plugin.integer("lobes", 3, 1, static_cast<int>(most)))};
    } else {
        plugin.fail_type("box, gaussian, tent, mitchell, catmullrom, lanczos");
    }
    plugin.finish();
    return filter;
}

void read_film(const XmlDocument& document, pugi::xml_node node, SensorDescription& sensor,
               Notices& notices) {
    Plugin film(document, node);
    if (film.type() != "hdrfilm") film.fail_type("hdrfilm");
    sensor.width = film.integer("width", sensor.width, 1, kMaxSize);
    sensor.height = film.integer("height", sensor.height, 1, kMaxSize);
    read_crop(film, sensor);
    read_format(film, node, sensor, notices);
    if (film.boolean("sample_border", false)) notices.add_unfollowed(node, "sample_border");
    // Steer Mitsuba's summing, or belong to older versions.
    film.pass_over({"compensate", "banner"});
    film.finish();
    for (const NestedObject& filter : film.single_objects({"rfilter"}))
        sensor.filter = read_filter(document, filter.node);
}

bool is_rigid(const glm::dmat4& m) {
    for (glm::length_t column = 0; column < 3; ++column)
        if (std::abs(glm::length(glm::dvec3(m[column])) - 1.0) > 1e-3) return false;
    return true;
}

/// Returns the number of samples of a pixel. The kind of sampler has no effect.
std::uint32_t sample_count_of(pugi::xml_node sampler, Notices& notices) {
    constexpr std::uint32_t otherwise = 4;  // as in Mitsuba
    constexpr std::uint32_t most = 1 << 30;
    const pugi::xml_node node = sampler.find_child_by_attribute("integer", "name", "sample_count");
    if (!node) return otherwise;
    const std::string_view text = node.attribute("value").value();
    std::uint32_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error == std::errc() && end == text.data() + text.size() && count >= 1 && count <= most) return count;
    notices.add(node, "sample_count is " + in_quotes(std::string(text)) + ", no whole number from 1 to " +
                          std::to_string(most) + "; " + std::to_string(otherwise) + " is taken");
    return otherwise;
}

}  // namespace

/// Without `fov`, the diagonal of 35 mm film behind a lens of this focal length.
void read_field_of_view(Plugin& plugin, double& fov, SensorDescription::FovAxis& axis) {
    const bool has_fov = plugin.has("fov");
    if (has_fov && plugin.has("focal_length"))
        plugin.fail("focal_length", "is given beside fov; expected one of them");
    if (has_fov) {
        fov = plugin.number("fov", 0.0, 0.0, 180.0, true);
        axis = static_cast<SensorDescription::FovAxis>(
            plugin.choice("fov_axis", 0, {"x", "y", "diagonal", "smaller", "larger"}));
        return;
    }
    plugin.pass_over({"fov"});
    std::string text = plugin.string("focal_length", "50mm");
    if (text.ends_with("mm")) text.resize(text.size() - 2);
    const auto millimetres = parsed_number(text);
    if (!millimetres || !(*millimetres > 0.0))
        plugin.fail("focal_length",
                    "is " + in_quotes(text) + "; expected a positive number of millimetres, as 50mm");
    fov = 360.0 / std::numbers::pi * std::atan(std::hypot(36.0, 24.0) / (2.0 * *millimetres));
    axis = SensorDescription::FovAxis::diagonal;
}

SensorDescription read_sensor(const XmlDocument& document, pugi::xml_node node, Notices& notices) {
    Plugin plugin(document, node);
    SensorDescription sensor;
    sensor.filter = {.kind = ReconstructionFilter::Kind::gaussian, .size = 0.5};  // as in Mitsuba
    sensor.to_world = plugin.transform("to_world");
    const bool thin_lens = plugin.type() == "thinlens";
    if (plugin.type() == "perspective" || thin_lens) {
        read_field_of_view(plugin, sensor.fov, sensor.fov_axis);
        constexpr double most = 1e4;
        sensor.principal_point_offset = {plugin.number("principal_point_offset_x", 0.0, -most, most),
                                         plugin.number("principal_point_offset_y", 0.0, -most, most)};
        if (!is_rigid(sensor.to_world))
            plugin.fail("to_world", "scales; a perspective sensor may only be rotated and moved");
    } else if (plugin.type() == "orthographic") {
        sensor.kind = SensorDescription::Kind::orthographic;
    } else {
        plugin.fail_type("perspective, thinlens, orthographic",
                         plugin.type() == "batch" ? "one image is rendered at a time" : "");
    }
    if (thin_lens) {
        if (!plugin.has("aperture_radius"))
            plugin.fail("aperture_radius", "is missing; expected a positive <float>");
        static_cast<void>(plugin.number("aperture_radius", 0.0, 0.0, kNoLimit, true));
        notices.add(node, "a thinlens is read as a pinhole: all is in focus");
    }
    if (glm::determinant(glm::dmat3(sensor.to_world)) < 0.0)
        plugin.fail("to_world", "mirrors; a sensor may not", ErrorCode::unsupported);
    sensor.near_clip = plugin.number("near_clip", sensor.near_clip, 0.0, kNoLimit, true);
    sensor.far_clip = plugin.number("far_clip", sensor.far_clip, 0.0, kNoLimit, true);
    if (sensor.near_clip >= sensor.far_clip) plugin.fail("near_clip", "must be smaller than far_clip");
    // Nothing is out of focus or moves.
    plugin.pass_over({"focus_distance", "shutter_open", "shutter_close"});
    plugin.finish();
    for (const NestedObject& object : plugin.single_objects({"film", "sampler"})) {
        if (std::string_view(object.node.name()) == "film")
            read_film(document, object.node, sensor, notices);
        else
            sensor.sample_count = sample_count_of(object.node, notices);
    }
    if (sensor.kind == SensorDescription::Kind::perspective) {
        const double horizontal = horizontal_fov(sensor);
        if (!(horizontal > 0.0 && horizontal < 179.99))
            plugin.fail(
                "fov", "makes the image " + std::to_string(horizontal) + " degrees wide; expected below 180");
    }
    return sensor;
}

}  // namespace scene

double horizontal_fov(const SensorDescription& sensor) {
    return horizontal_fov(sensor.fov, sensor.fov_axis, static_cast<double>(sensor.width) / sensor.height);
}

double horizontal_fov(double fov, SensorDescription::FovAxis axis, double aspect) {
    using Axis = SensorDescription::FovAxis;
    if (axis == Axis::smaller) axis = aspect > 1.0 ? Axis::y : Axis::x;
    if (axis == Axis::larger) axis = aspect > 1.0 ? Axis::x : Axis::y;
    // Half the extent along the axis at distance 1, then that of x.
    double extent = std::tan(fov * std::numbers::pi / 360.0);
    if (axis == Axis::y) extent *= aspect;
    if (axis == Axis::diagonal) extent *= aspect / std::hypot(aspect, 1.0);
    return std::atan(extent) * 360.0 / std::numbers::pi;
}

}  // namespace nicol
