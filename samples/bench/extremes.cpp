// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lamp_room.hpp"
#include "median.hpp"
#include "scene_file.hpp"
#include "temporary_folder.hpp"
#include "truth.hpp"
#include "wavy_torus.hpp"

namespace {

const std::string kEvenSky = R"(<emitter type="constant"/>)";

std::string number(const char* name, const std::string& value) {
    return std::string(R"(<float name=")") + name + R"(" value=")" + value + R"("/>)";
}

std::string metal(const std::string& along_u, const std::string& along_v) {
    return R"(<bsdf type="roughconductor"><string name="material" value="Al"/>)" +
           number("alpha_u", along_u) + number("alpha_v", along_v) + "</bsdf>";
}

std::string plastic(const std::string& alpha) {
    return R"(<bsdf type="pplastic"><rgb name="diffuse_reflectance" value="0.1,0.27,0.36"/>)" +
           number("alpha", alpha) + "</bsdf>";
}

const std::string kMatt = R"(<bsdf type="diffuse"><rgb name="reflectance" value="0.5,0.4,0.3"/></bsdf>)";

// A square of edge 2 with its normal up, moved and scaled.
std::string square(const std::string& transform, const std::string& inside) {
    return R"(<shape type="rectangle"><transform name="to_world"><rotate x="1" angle="-90"/>)" + transform +
           "</transform>" + inside + "</shape>";
}

// Brushed metal that polarizes strongly, whose lobes see both the bright and the dark of the forest.
std::string polarizing_square() {
    return kForestLight +
           square("", R"(<bsdf type="roughconductor"><string name="distribution" value="ggx"/>)" +
                          number("eta", "1.95") + number("k", "2.6") + number("alpha_u", "0.1") +
                          number("alpha_v", "0.24") + "</bsdf>");
}

std::string ball(const std::string& bsdf, const std::string& light) {
    return light + R"(<shape type="sphere">)" + bsdf + "</shape>";
}

// Two sheets of edge 2 under an even sky, matt on both sides.
std::string sheets(const std::string& apart) {
    const std::string matt = R"(<bsdf type="twosided">)" + kMatt + "</bsdf>";
    return kEvenSky + square("", matt) + square(R"(<translate y=")" + apart + R"("/>)", matt);
}

// A box of edge 2 whose roof is two strips beside an open one, under an even sky; the camera is inside.
std::string open_box() {
    std::string out = kEvenSky;
    for (const char* turn : {R"(<rotate z="1" angle="90"/>)", R"(<rotate z="1" angle="-90"/>)",
                             R"(<rotate x="1" angle="90"/>)", R"(<rotate x="1" angle="-90"/>)", ""})
        out += square(std::string(R"(<translate y="-1"/>)") + turn, kMatt);
    for (const char* side : {"-0.625", "0.625"})
        out += square(std::string(R"(<scale x="0.375"/><rotate x="1" angle="180"/><translate x=")") + side +
                          R"(" y="1"/>)",
                      kMatt);
    return out;
}

std::string light_above_floor(const std::string& height) {
    return square(R"(<scale value="5"/>)", kMatt) +
           square(R"(<scale value="0.5"/><rotate x="1" angle="180"/><translate y=")" + height + R"("/>)",
                  R"(<emitter type="area"><rgb name="radiance" value="10,9,8"/></emitter>)");
}

// A ball on a floor under a distant sphere of light, whose angular radius has this sine.
std::string disc_of_sky(const std::string& sine) {
    return ball(plastic("0.2"), "") + square(R"(<scale value="4"/><translate y="-1"/>)", plastic("0.2")) +
           R"(<shape type="sphere"><transform name="to_world"><scale value=")" + sine +
           R"("/><translate x="0.4" y="0.8" z="0.447"/><scale value="100"/></transform>)" +
           R"(<emitter type="area"><rgb name="radiance" value="1,0.9,0.8"/></emitter></shape>)";
}

std::string checkered_floor() {
    return kEvenSky +
           square(
               R"(<scale value="20"/>)",
               R"(<bsdf type="diffuse"><texture name="reflectance" type="checkerboard"><transform name="to_uv">)"
               R"(<scale value="50"/></transform></texture></bsdf>)");
}

constexpr const char* kCoarse = "mesh of 1,440 vertices before a lamp";

// A mesh that the scene's folder holds, as the light with its lamp.
std::string coarse_on_floor() {
    return R"(<emitter type="envmap"><string name="filename" value="lamp.exr"/></emitter>)"
           R"(<shape type="obj"><string name="filename" value="mesh.obj"/>)" +
           plastic("0.2") + "</shape>" + square(R"(<scale value="4"/><translate y="-0.6"/>)", plastic("0.2"));
}

struct Row {
    std::string name;
    std::string content;
    std::string origin = "0,1,4";
    std::string target = "0,0,0";
};

std::vector<Row> rows() {
    std::vector<Row> out;
    for (const auto& [u, v] : {std::pair{"0.2", "0.2"}, {"0.1", "0.4"}, {"0.4", "0.1"}, {"0.05", "0.5"}})
        out.push_back({std::string("aluminium, alpha ") + u + " and " + v, ball(metal(u, v), kForestLight)});
    out.push_back({"square of polarizing metal, alpha 0.1 and 0.24", polarizing_square(), "0.4,1.2,1.6"});
    for (const char* anisotropic : {"0", "0.8"})
        out.push_back({std::string("principled, anisotropic ") + anisotropic,
                       ball(R"(<bsdf type="principled"><rgb name="base_color" value="0.9,0.6,0.3"/>)" +
                                number("metallic", "1") + number("roughness", "0.4") +
                                number("anisotropic", anisotropic) + "</bsdf>",
                            kForestLight)});
    for (const char* alpha : {"0.005", "0.01", "0.02", "0.03"})
        out.push_back({std::string("aluminium, alpha ") + alpha, ball(metal(alpha, alpha), kForestLight)});
    for (const char* alpha : {"0.005", "0.02", "0.05"})
        out.push_back({std::string("plastic, alpha ") + alpha, ball(plastic(alpha), kForestLight)});
    for (const char* apart : {"0.2", "0.5", "1"})
        out.push_back({std::string("sheets ") + apart + " apart", sheets(apart), "0.3,0.1,1.6", "0,0.1,0"});
    out.push_back({"box with a slit in its roof", open_box(), "0,-0.5,0.9", "0,-0.2,0"});
    for (const char* height : {"0.5", "0.1", "0.02"})
        out.push_back({std::string("square light ") + height + " above a floor", light_above_floor(height),
                       "1.1,0.4,1.3", "0.4,0,0.5"});
    out.push_back({"disc of the sky of 60 degrees", disc_of_sky("0.5"), "0,1,5"});
    out.push_back({"disc of the sky of 90 degrees", disc_of_sky("0.707"), "0,1,5"});
    out.push_back({kCoarse, coarse_on_floor(), "0,2.2,4.6"});
    out.push_back({"checkerboard of 100 x 100 squares", checkered_floor(), "0,4,20"});
    return out;
}

constexpr std::uint32_t kFrameSize = 512;

// Returns the processor time, in milliseconds and of all threads, of a frame of kFrameSize x kFrameSize
// pixels whose camera moved: the median of nine.
double frame_ms(const SceneSource& source) {
    Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(kFrameSize, kFrameSize);
    const nicol_render_options options = default_recipe().options();
    stage.render(options, framebuffer.get());
    std::vector<double> times;
    for (int frame = 0; frame < 9; ++frame) {
        stage.orbit(1);
        const std::clock_t before = std::clock();
        stage.render(options, framebuffer.get());
        times.push_back(1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    }
    return median(times);
}

struct Measured {
    DefaultErrors errors;
    double frame_ms;
};

// Measures one row, and names it in errors.
Measured measured(const SceneSource& source, const Row& row, std::uint32_t size, std::uint32_t samples) {
    try {
        return {default_errors(source, size, samples), frame_ms(source)};
    } catch (const std::exception& error) {
        throw std::runtime_error(row.name + ": " + error.what());
    }
}

}  // namespace

Report bench_extremes(const Options& given) {
    const std::uint32_t size = given.size == 0 ? 128 : given.size;
    const std::uint32_t samples = given.samples == 0 ? 256 : given.samples;
    const TemporaryFolder folder;
    Options options = given;
    const std::filesystem::path file = folder.path() / "scene.xml";
    write_lamp_behind(folder.path() / "lamp.exr", given.backend);
    write_obj(folder.path() / "mesh.obj", wavy_torus(48, 30));
    options.scene = file.string();

    Report report({"relative RMSE", "s0", "s1", "s2", "s0 inside", "predicted", "frame ms"});
    std::map<std::string, double> frames;
    for (const Row& row : rows()) {
        if (row.name.find(options.only) == std::string::npos) continue;
        write_scene(file, row.origin, row.target, row.content);
        const auto [found, frame] = measured(SceneSource(options), row, size, samples);
        report.add(row.name, {found.errors[0], found.errors[1], found.errors[2], found.inside,
                              found.statistics.predicted_error, frame});
        frames[row.name] = frame;
    }
    for (const auto& [brushed, round] :
         {std::pair{"aluminium, alpha 0.1 and 0.4", "aluminium, alpha 0.2 and 0.2"},
          {"aluminium, alpha 0.4 and 0.1", "aluminium, alpha 0.2 and 0.2"},
          {"aluminium, alpha 0.05 and 0.5", "aluminium, alpha 0.2 and 0.2"},
          {"principled, anisotropic 0.8", "principled, anisotropic 0"}}) {
        if (!frames.contains(brushed) || !frames.contains(round)) continue;
        char text[200];
        std::snprintf(text, sizeof text, "%s / %s, frame: %.3g times.", brushed, round,
                      frames[brushed] / frames[round]);
        report.note(text);
    }
    report.note("Relative RMSE by default with 8 samples a pixel, " + std::to_string(size) + " x " +
                std::to_string(size) + " pixels, against rays of " + std::to_string(samples) +
                " samples twice, without their noise; inside: away from the outlines of all objects, "
                "which pixels of few samples show jagged and no prediction holds. Balls are in the forest. "
                "Frames: processor time after "
                "a move of the camera, " +
                std::to_string(kFrameSize) + " x " + std::to_string(kFrameSize) + " pixels.");
    return report;
}
