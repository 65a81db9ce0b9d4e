// SPDX-License-Identifier: MIT
#include "polygon.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "stage.hpp"

namespace {

constexpr std::uint32_t kSize = 256;
constexpr double kHeight = 1.5;
constexpr double kHalf = 0.5;  // of the light's side
constexpr double kRadiance = 10;
constexpr double kReflectance = 0.5;

// From between the light and the floor.
void write_scene(const std::filesystem::path& path) {
    std::ofstream out(path);
    out << R"(<scene version="3.0.0"><sensor type="orthographic"><transform name="to_world"><scale value="2"/>)"
        << R"(<lookat origin="0,0,1" target="0,0,0" up="0,1,0"/></transform></sensor>)"
        << R"(<emitter type="constant"><float name="radiance" value="0"/></emitter>)"
        << R"(<shape type="rectangle"><transform name="to_world"><scale value="3"/></transform><bsdf type="diffuse">)"
        << R"(<float name="reflectance" value=")" << kReflectance << R"("/></bsdf></shape>)"
        << R"(<shape type="rectangle"><transform name="to_world"><scale value=")" << kHalf
        << R"("/><rotate x="1" angle="180"/><translate z=")" << kHeight << R"("/></transform>)"
        << R"(<emitter type="area"><float name="radiance" value=")" << kRadiance
        << R"("/></emitter></shape></scene>)";
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

// Irradiance by a square that faces the floor, by the angles of its edges (Lambert 1760).
double irradiance(double x, double y) {
    std::array<std::array<double, 3>, 4> corner{};
    for (std::size_t i = 0; i < 4; ++i) {
        const double cx = (i == 0 || i == 3 ? -kHalf : kHalf) - x, cy = (i < 2 ? -kHalf : kHalf) - y;
        const double length = std::sqrt(cx * cx + cy * cy + kHeight * kHeight);
        corner[i] = {cx / length, cy / length, kHeight / length};
    }
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& a = corner[i];
        const auto& b = corner[(i + 1) % 4];
        const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        const double up = a[0] * b[1] - a[1] * b[0];  // of their cross product
        sum += std::acos(cosine) / std::sqrt(1 - cosine * cosine) * up;
    }
    return kRadiance * sum / 2;
}

std::vector<float> plane(nicol_framebuffer framebuffer, nicol_plane which, std::size_t components) {
    std::vector<float> out(std::size_t{kSize} * kSize * components);
    check(nicol_framebuffer_read(framebuffer, which, 0, out.data(), 0, out.size() * sizeof(float)));
    return out;
}

}  // namespace

void add_polygon(Report& report, const Options& given, const TemporaryFolder& folder) {
    const double none = std::nan("");
    Options options = given;
    options.scene = (folder.path() / "polygon.xml").string();
    options.light.clear();
    write_scene(options.scene);
    const SceneSource source(options);
    const Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(kSize, kSize);

    nicol_render_options wanted = NICOL_RENDER_OPTIONS_INIT;
    wanted.shadows = 0;
    wanted.shade_at = NICOL_SHADE_AT_PIXELS;
    wanted.aovs = NICOL_AOV_POSITION;
    std::vector<double> truth(std::size_t{kSize} * kSize);
    double closed_ms = 0;
    for (const std::uint32_t places : {4U, 16U, 64U}) {
        wanted.light_samples = places;
        const nicol_statistics statistics = stage.render(wanted, framebuffer.get());
        if (closed_ms == 0) {
            const std::vector<float> points = plane(framebuffer.get(), NICOL_PLANE_POSITION, 3);
            const auto begin = std::chrono::steady_clock::now();
            for (std::size_t i = 0; i < truth.size(); ++i)
                truth[i] = kReflectance / std::numbers::pi *
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
