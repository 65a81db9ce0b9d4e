// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "comparison.hpp"
#include "frame_times.hpp"
#include "lamp_room.hpp"
#include "stage.hpp"
#include "temporary_folder.hpp"

namespace {

const char* const kDark = R"(<emitter type="constant"><rgb name="radiance" value="0"/></emitter>)";

// Writes a snail on its plinth, lit by `emitters`.
void write_scene(const std::filesystem::path& path, const std::string& emitters) {
    std::ofstream out(path);
    out << R"(<scene version="3.0.0"><path value=")" << NICOL_BENCH_ASSETS << R"("/>)"
        << R"(<sensor type="perspective"><float name="fov" value="42"/><transform name="to_world">)"
           R"(<lookat origin="-1.9,1.9,4.7" target="-0.05,0.95,0" up="0,1,0"/></transform></sensor>)"
        << emitters;
    for (const auto& [file, color, alpha] :
         {std::tuple{"snail.ply", "0.26,0.07,0.03", "0.2"}, {"plinth.ply", "0.2,0.22,0.24", "0.3"}}) {
        out << R"(<shape type="ply"><string name="filename" value=")" << file
            << R"("/><bsdf type="pplastic"><string name="distribution" value="ggx"/><float name="alpha" value=")"
            << alpha << R"("/><rgb name="diffuse_reflectance" value=")" << color << R"("/></bsdf></shape>)";
    }
    out << "</scene>";
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

struct Light {
    const char* name;
    std::string emitter;
};

// Returns lights that each light the snail from above, on its right.
std::vector<Light> lights() {
    const std::string aimed =
        R"(<transform name="to_world"><lookat origin="2.5,4,2" target="0,0.8,0" up="0,1,0.1"/></transform>)";
    const auto shining = [](const std::string& shape, const std::string& to_world) {
        return R"(<shape type=")" + shape + R"("><transform name="to_world">)" + to_world +
               R"(</transform><emitter type="area"><rgb name="radiance" value="14,12,10"/></emitter></shape>)";
    };
    const std::string facing = R"(<lookat origin="2.5,4,2" target="0,0.8,0" up="0,1,0.1"/>)";
    return {
        {"directional",
         R"(<emitter type="directional"><rgb name="irradiance" value="4,3,2"/>)" + aimed + "</emitter>"},
        {"sun, 0.27 degrees, polarized",
         R"(<emitter type="directional"><rgb name="irradiance" value="4,3,2"/><float name="angular_radius" value="0.27"/>)"
         R"(<float name="dolp" value="1"/>)" +
             aimed + "</emitter>"},
        {"point",
         R"(<emitter type="point"><point name="position" value="2.5,4,2"/><rgb name="intensity" value="60"/></emitter>)"},
        {"spot", R"(<emitter type="spot"><rgb name="intensity" value="80"/>)" + aimed + "</emitter>"},
        {"rectangle, 1.6 wide", shining("rectangle", R"(<scale value="0.8"/>)" + facing)},
        {"disk of 5,580 triangles", shining("disk", R"(<scale value="0.8"/>)" + facing)},
    };
}

Recipe at_pixels() {
    return {.defaults = true, .shade_at = NICOL_SHADE_AT_PIXELS};
}

// Adds errors against the reference method: the lamps of an environment, then lights in the dark.
void add_errors(Report& report, const Options& given, const TemporaryFolder& folder) {
    const double none = std::nan("");
    const std::uint32_t size = given.size == 0 ? 192 : given.size;
    const std::uint32_t samples = given.samples == 0 ? 1024 : given.samples;
    Options options = given;
    options.scene = (folder.path() / "scene.xml").string();
    const auto add = [&](const std::string& name, const Comparison& comparison, const Recipe& recipe) {
        const Comparison::Measured m = comparison.measure(recipe);
        report.add(name, {m.errors[0], m.errors[1], m.errors[2], m.polarization.dolp,
                          static_cast<double>(m.statistics.local_lights), none});
    };
    const auto add_noise = [&](const Comparison& comparison) {
        const StokesErrors noise = comparison.truth().noise();
        report.add("  reference, its noise", {noise[0], noise[1], noise[2], none, none, none});
    };
    {
        const std::filesystem::path lamps = folder.path() / "lamps.exr";
        write_lamp_room(lamps, given.backend);
        write_scene(options.scene, R"(<emitter type="constant"/>)");
        options.light = lamps.string();
        const SceneSource source(options);
        const Comparison room(source, size, samples, true);
        Recipe orders{.low = 4, .high = High::split, .top = 9};
        add("room with lamps, orders 4 and 9, at vertices", room, orders);
        orders = {.low = 16, .high = High::split, .top = 64, .shade_at = NICOL_SHADE_AT_PIXELS};
        add("room with lamps, orders 16 and 64, at pixels", room, orders);
        add("room with lamps, by default", room, at_pixels());
        add_noise(room);
        options.light.clear();
    }
    for (const Light& light : lights()) {
        write_scene(options.scene, kDark + light.emitter);
        const SceneSource source(options);
        const Comparison comparison(source, size, samples, true);
        add(light.name, comparison, at_pixels());
        add_noise(comparison);
    }
}

constexpr std::uint32_t kSquareSize = 256;
constexpr double kSquareHeight = 1.5;
constexpr double kSquareHalf = 0.5;  // half side of the light
constexpr double kSquareRadiance = 10;
constexpr double kFloorReflectance = 0.5;

// Writes a square light above a floor. The camera is between them.
void write_square(const std::filesystem::path& path) {
    std::ofstream out(path);
    out << R"(<scene version="3.0.0"><sensor type="orthographic"><transform name="to_world"><scale value="2"/>)"
        << R"(<lookat origin="0,0,1" target="0,0,0" up="0,1,0"/></transform></sensor>)"
        << R"(<emitter type="constant"><float name="radiance" value="0"/></emitter>)"
        << R"(<shape type="rectangle"><transform name="to_world"><scale value="3"/></transform><bsdf type="diffuse">)"
        << R"(<float name="reflectance" value=")" << kFloorReflectance << R"("/></bsdf></shape>)"
        << R"(<shape type="rectangle"><transform name="to_world"><scale value=")" << kSquareHalf
        << R"("/><rotate x="1" angle="180"/><translate z=")" << kSquareHeight << R"("/></transform>)"
        << R"(<emitter type="area"><float name="radiance" value=")" << kSquareRadiance
        << R"("/></emitter></shape></scene>)";
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

// Returns the irradiance by a square that faces the floor, from the angles of its edges (Lambert 1760).
double irradiance(double x, double y) {
    std::array<std::array<double, 3>, 4> corner{};
    for (std::size_t i = 0; i < 4; ++i) {
        const double cx = (i == 0 || i == 3 ? -kSquareHalf : kSquareHalf) - x,
                     cy = (i < 2 ? -kSquareHalf : kSquareHalf) - y;
        const double length = std::sqrt(cx * cx + cy * cy + kSquareHeight * kSquareHeight);
        corner[i] = {cx / length, cy / length, kSquareHeight / length};
    }
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& a = corner[i];
        const auto& b = corner[(i + 1) % 4];
        const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        const double up = a[0] * b[1] - a[1] * b[0];  // z of the cross product
        sum += std::acos(cosine) / std::sqrt(1 - cosine * cosine) * up;
    }
    return kSquareRadiance * sum / 2;
}

std::vector<float> plane(nicol_framebuffer framebuffer, nicol_plane which, std::size_t components) {
    std::vector<float> out(std::size_t{kSquareSize} * kSquareSize * components);
    check(nicol_framebuffer_read(framebuffer, which, 0, out.data(), 0, out.size() * sizeof(float)));
    return out;
}

/// Compares a square light by light samples with its closed form on a diffuse floor under it, without
/// shadows: errors of some sample counts, and their time beside that of Lambert's formula for the same
/// pixels.
void add_polygon(Report& report, const Options& given, const TemporaryFolder& folder) {
    const double none = std::nan("");
    Options options = given;
    options.scene = (folder.path() / "polygon.xml").string();
    options.light.clear();
    write_square(options.scene);
    const SceneSource source(options);
    const Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(kSquareSize, kSquareSize);

    nicol_render_options wanted = NICOL_RENDER_OPTIONS_INIT;
    wanted.shadows = 0;
    wanted.shade_at = NICOL_SHADE_AT_PIXELS;
    wanted.aovs = NICOL_AOV_POSITION;
    std::vector<double> truth(std::size_t{kSquareSize} * kSquareSize);
    double closed_ms = 0;
    for (const std::uint32_t places : {4U, 16U, 64U}) {
        wanted.light_samples = places;
        const nicol_statistics statistics = stage.render(wanted, framebuffer.get());
        if (closed_ms == 0) {
            const std::vector<float> points = plane(framebuffer.get(), NICOL_PLANE_POSITION, 3);
            const auto begin = std::chrono::steady_clock::now();
            for (std::size_t i = 0; i < truth.size(); ++i)
                truth[i] = kFloorReflectance / std::numbers::pi *
                           irradiance(double{points[3 * i]}, double{points[3 * i + 1]});
            closed_ms =
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        }
        const std::vector<float> s0 = plane(framebuffer.get(), NICOL_PLANE_STOKES, 4);
        double error = 0, power = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            error += std::pow(double{s0[4 * i]} - truth[i], 2);
            power += truth[i] * truth[i];
        }
        report.add("square above a matt floor, " + std::to_string(places) + " places",
                   {std::sqrt(error / power), none, none, none, none, none});
        report.add("  their time, on all threads / the closed form's, on one",
                   {none, none, none, none, none, statistics.light_ms / closed_ms});
    }
}

// Adds frame times relative to the same picture without the light.
void add_times(Report& report, const Options& given, const TemporaryFolder& folder) {
    const double none = std::nan("");
    const std::uint32_t size = given.size == 0 ? 1024 : given.size;
    Options options = given;
    options.scene = (folder.path() / "scene.xml").string();
    options.light = NICOL_BENCH_ASSETS "/forest_blurred.exr";
    const std::vector<Light> all = lights();
    write_scene(options.scene, R"(<emitter type="constant"/>)");
    const SceneSource dark(options);
    std::vector<Contestant> contestants;
    contestants.emplace_back(dark, at_pixels(), size);
    for (const Light& light : all) {
        write_scene(options.scene, R"(<emitter type="constant"/>)" + light.emitter);
        const SceneSource source(options);
        contestants.emplace_back(source, at_pixels(), size);
    }
    const std::vector<FrameTimes> times = time_frames(contestants, options.seconds);
    for (std::size_t i = 0; i < all.size(); ++i)
        report.add("frame with " + std::string(all[i].name) + " / without",
                   {none, none, none, none, none, times[i + 1].camera / times[0].camera});
}

}  // namespace

Report bench_lights(const Options& given) {
    const TemporaryFolder folder;
    Report report({"relative RMSE", "s0", "s1", "s2", "DoLP, mean", "local lights", "frame"});
    add_errors(report, given, folder);
    add_polygon(report, given, folder);
    add_times(report, given, folder);
    report.note(
        "A snail of plastic on a plinth, at pixels; errors against the reference method, relative to the RMS "
        "of "
        "s0, its noise taken out. Frames: after a move of the camera, in the forest, with the light and its "
        "shadow, over those without it. The square: against the closed form, without shadows; its last "
        "column is what the row says.");
    return report;
}
