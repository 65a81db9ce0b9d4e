// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "scene_file.hpp"
#include "temporary_folder.hpp"
#include "truth.hpp"

namespace {

constexpr std::array kLights{"environment", "lamp", "point"};

/// Ball of radius 1 on a square floor, moved by the same distance along each axis.
struct Place {
    double floor = 10;  ///< half its edge
    double offset = 0;
    std::string light = "environment";
};

// Returns a number with all its digits, because far places need them.
std::string exact(double number) {
    std::ostringstream out;
    out.precision(17);
    out << number;
    return out.str();
}

std::string at(const Place& place, double x, double y, double z) {
    return exact(place.offset + x) + "," + exact(place.offset + y) + "," + exact(place.offset + z);
}

std::string light_of(const Place& place) {
    if (place.light == "environment") return kForestLight;
    if (place.light == "point")
        return R"(<emitter type="point"><point name="position" value=")" + at(place, 2, 4, 3) +
               R"("/><rgb name="intensity" value="30,25,20"/></emitter>)";
    return R"(<shape type="rectangle"><transform name="to_world"><lookat origin=")" + at(place, 2, 4, 3) +
           R"(" target=")" + at(place, 0, 0, 0) +
           R"(" up="0,1,0"/></transform><emitter type="area"><rgb name="radiance" value="10,9,8"/></emitter></shape>)";
}

void write_ball(const std::filesystem::path& path, const Place& place) {
    write_scene(
        path, at(place, 0, 3, 6), at(place, 0, 0.7, 0),
        light_of(place) +
            R"(<bsdf type="pplastic" id="m"><rgb name="diffuse_reflectance" value="0.4,0.2,0.1"/><float name="alpha" value="0.2"/></bsdf>)"
            R"(<shape type="sphere"><transform name="to_world"><translate value=")" +
            at(place, 0, 1, 0) +
            R"("/></transform><ref id="m"/></shape><shape type="rectangle"><transform name="to_world"><scale value=")" +
            exact(place.floor) + R"("/><rotate x="1" angle="-90"/><translate value=")" + at(place, 0, 0, 0) +
            R"("/></transform><ref id="m"/></shape>)");
}

// Writes two walls, the farther of which is white.
void write_walls(const std::filesystem::path& path, double near, double far) {
    std::string walls = R"(<emitter type="constant"/>)";
    for (const auto& [distance, reflectance] : {std::pair{near, "0.1"}, {far, "0.9"}})
        walls +=
            R"(<shape type="rectangle"><transform name="to_world"><scale value="5000"/><rotate x="1" angle="180"/><translate value="0,0,)" +
            exact(distance) + R"("/></transform><bsdf type="diffuse"><spectrum name="reflectance" value=")" +
            reflectance + R"("/></bsdf></shape>)";
    write_scene(path, "0,0,0", "0.3,0.2,1", walls);
}

Image rendered(const Options& options, const nicol_render_options& wanted, std::uint32_t size) {
    const SceneSource source(options);
    const Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(size, size);
    stage.render(wanted, framebuffer.get());
    return read_image(framebuffer.get());
}

std::vector<double> difference(const Image& moved, const Image& still) {
    const Truth truth{
        .first = still, .second = still, .mask = Mask(std::size_t{still.width} * still.height, 1)};
    const StokesErrors errors = truth.errors(moved);
    return {errors[0], errors[1], errors[2]};
}

std::string shortest(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", number);
    return text;
}

void add_walls(Report& report, Options options, const std::filesystem::path& file, std::uint32_t size) {
    for (const double apart : {0.2, 1.0}) {
        write_walls(file, 1000, 1000 + apart);
        options.scene = file.string();
        const Image image = rendered(options, Recipe{.low = 0, .shadows = false}.options(), size);
        std::size_t hidden = 0;
        const std::size_t pixels = std::size_t{size} * size;
        for (std::size_t i = 0; i < pixels; ++i) hidden += image.stokes[4 * i] > 0.5F ? 1 : 0;
        report.note("Walls 1,000 and " + shortest(1000 + apart) + " away: " + std::to_string(hidden) +
                    " of " + std::to_string(pixels) + " pixels show the hidden one.");
    }
}

}  // namespace

Report bench_places(const Options& given) {
    const std::uint32_t size = given.size == 0 ? 96 : given.size;
    const std::uint32_t samples = given.samples == 0 ? 1024 : given.samples;
    const TemporaryFolder folder;
    Options options = given;
    const std::filesystem::path file = folder.path() / "scene.xml";
    options.scene = file.string();

    Report report({"relative RMSE", "s0", "s1", "s2"});
    for (const char* light : kLights) {
        const auto add = [&](const char* method, const nicol_render_options& wanted) {
            write_ball(file, {.light = light});
            const Image still = rendered(options, wanted, size);
            for (const double offset : {1e4, 1e6, 1e9}) {
                write_ball(file, {.offset = offset, .light = light});
                report.add(
                    std::string(light) + ", moved by " + shortest(offset) + ", " + method + " against itself",
                    difference(rendered(options, wanted, size), still));
            }
        };
        add("by default", default_recipe().options());
        add("by rays", reference_options(16, 1, true));
    }
    for (const char* light : kLights) {
        for (const double floor : {1e2, 3e4, 1e6}) {
            write_ball(file, {.floor = floor, .light = light});
            const StokesErrors errors = default_errors(SceneSource(options), size, samples).errors;
            report.add(
                std::string(light) + ", a floor of " + shortest(floor) + " times the ball, against rays",
                {errors[0], errors[1], errors[2]});
        }
    }
    add_walls(report, options, file, size);
    report.note("A ball on a floor, both of plastic (alpha 0.2), by default with 8 samples a pixel, " +
                std::to_string(size) + " x " + std::to_string(size) + " pixels; against rays of " +
                std::to_string(samples) + " samples twice, without their noise.");
    return report;
}
