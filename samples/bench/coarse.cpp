// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "comparison.hpp"
#include "lamp_room.hpp"
#include "temporary_folder.hpp"

namespace {

using Vector = std::array<double, 3>;

Vector sum(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector scaled(const Vector& a, double factor) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

Vector unit(const Vector& a) {
    return scaled(a, 1 / std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]));
}

struct Triangles {
    std::vector<Vector> positions, normals;
    std::vector<std::array<std::size_t, 3>> corners;
};

// Makes a torus with waves, so that it shadows itself.
Triangles torus(std::size_t rows, std::size_t columns) {
    const auto place = [](double u, double v) {
        const double tube = 0.42 + 0.06 * std::sin(5 * u) * std::cos(3 * v);
        const double ring = 1 + tube * std::cos(v);
        return Vector{ring * std::cos(u), tube * std::sin(v), ring * std::sin(u)};
    };
    const auto at = [&](std::size_t row, std::size_t column) {
        return row % rows * columns + column % columns;
    };
    Triangles mesh;
    for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            constexpr double turn = 2 * std::numbers::pi;
            const double u = turn * static_cast<double>(r) / static_cast<double>(rows);
            const double v = turn * static_cast<double>(c) / static_cast<double>(columns);
            constexpr double h = 1e-4;
            const Vector a = sum(place(u + h, v), scaled(place(u - h, v), -1));
            const Vector b = sum(place(u, v + h), scaled(place(u, v - h), -1));
            mesh.positions.push_back(place(u, v));
            mesh.normals.push_back(
                unit({b[1] * a[2] - b[2] * a[1], b[2] * a[0] - b[0] * a[2], b[0] * a[1] - b[1] * a[0]}));
            mesh.corners.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
            mesh.corners.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
        }
    }
    return mesh;
}

// Splits each triangle into four in the same plane, with normals as shading interpolates them.
Triangles split(const Triangles& mesh) {
    Triangles out{mesh.positions, mesh.normals, {}};
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
        const auto [found, added] = middles.try_emplace(std::minmax(a, b), out.positions.size());
        if (added) {
            out.positions.push_back(scaled(sum(mesh.positions[a], mesh.positions[b]), 0.5));
            out.normals.push_back(unit(sum(mesh.normals[a], mesh.normals[b])));
        }
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.corners) {
        const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        out.corners.insert(out.corners.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return out;
}

void write_obj(const std::filesystem::path& path, const Triangles& mesh) {
    std::ofstream out(path);
    out.precision(9);
    for (const Vector& p : mesh.positions) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const Vector& n : mesh.normals) out << "vn " << n[0] << ' ' << n[1] << ' ' << n[2] << '\n';
    for (const auto& triangle : mesh.corners) {
        out << 'f';
        for (const std::size_t corner : triangle) out << ' ' << corner + 1 << "//" << corner + 1;
        out << '\n';
    }
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

// Writes a scene whose light is a placeholder.
void write_scene(const std::filesystem::path& path) {
    std::ofstream out(path);
    out << R"(<scene version="3.0.0"><sensor type="perspective"><float name="fov" value="40"/>)"
           R"(<transform name="to_world"><lookat origin="1.5,3,3" target="0,0,0" up="0,1,0"/></transform></sensor>)"
           R"(<emitter type="constant"/><shape type="obj"><string name="filename" value="mesh.obj"/>)"
           R"(<bsdf type="pplastic"><rgb name="diffuse_reflectance" value="0.4,0.2,0.1"/>)"
           R"(<string name="distribution" value="ggx"/><float name="alpha" value="0.15"/></bsdf></shape></scene>)";
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

std::string ratio(double coarse, double fine) {
    if (!(fine > 0)) return " (below the noise)";
    char text[32];
    std::snprintf(text, sizeof text, " %.2f", coarse / fine);
    return text;
}

}  // namespace

Report bench_coarse(const Options& given) {
    const std::uint32_t size = given.size == 0 ? 192 : given.size;
    const std::uint32_t samples = given.samples == 0 ? 1024 : given.samples;
    const int low = given.first_order < 0 ? 16 : given.first_order;
    const int high = given.last_order < 0 ? 64 : given.last_order;
    const TemporaryFolder folder;
    Options options = given;
    options.scene = (folder.path() / "scene.xml").string();
    write_scene(options.scene);
    std::vector<std::pair<std::string, std::string>> lights{{"light", given.light}};
    if (given.light.empty()) {
        const std::filesystem::path lamps = folder.path() / "lamps.exr";
        write_lamp_room(lamps, given.backend);
        lights = {{"lamps", lamps.string()}, {"forest", NICOL_BENCH_ASSETS "/forest.exr"}};
    }
    const Triangles coarse = torus(48, 30);
    const Triangles fine = split(split(coarse));

    Report report({"relative RMSE", "s0", "s1", "s2", "DoLP, mean"});
    for (const auto& [light, file] : lights) {
        options.light = file;
        std::array<StokesErrors, 2> at_pixels{};
        for (const bool is_fine : {false, true}) {
            const Triangles& mesh = is_fine ? fine : coarse;
            write_obj(folder.path() / "mesh.obj", mesh);
            const SceneSource source(options);
            const Comparison comparison(source, size, samples, true);
            if (!is_fine) {
                const StokesErrors noise = comparison.truth().noise();
                report.add(light + ": reference, its noise",
                           {noise[0], noise[1], noise[2], std::numeric_limits<double>::quiet_NaN()});
            }
            for (const nicol_shade_at at : {NICOL_SHADE_AT_VERTICES, NICOL_SHADE_AT_PIXELS}) {
                const bool pixels = at == NICOL_SHADE_AT_PIXELS;
                const Comparison::Measured m =
                    comparison.measure({.low = low, .high = High::split, .top = high, .shade_at = at});
                report.add(light + ", " + std::to_string(mesh.positions.size()) + " vertices, shaded at " +
                               (pixels ? "pixels" : "vertices"),
                           {m.errors[0], m.errors[1], m.errors[2], m.polarization.dolp});
                if (pixels) at_pixels[is_fine ? 1 : 0] = m.errors;
            }
        }
        std::string text = light + ": at pixels the coarse mesh errs";
        for (std::size_t p = 0; p < 3; ++p) text += ratio(at_pixels[0][p], at_pixels[1][p]);
        report.note(text + " times what the fine one does in s0, s1, s2.");
    }
    report.note("A wavy torus of plastic (alpha 0.15), orders " + std::to_string(low) + " and " +
                std::to_string(high) + ", " + std::to_string(size) + " x " + std::to_string(size) +
                " pixels; relative to the RMS of s0; the noise of the reference, of " +
                std::to_string(samples) + " samples twice, is taken out of the errors.");
    return report;
}
