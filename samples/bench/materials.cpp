// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparison.hpp"
#include "temporary_folder.hpp"

namespace {

// Returns two rings of vertices per row of pixels, but no more than 40,021 vertices, 0.8 degrees apart, which
// take 2 GB at order 32.
int rings(std::uint32_t size) {
    return static_cast<int>(std::min(2 * size, 115U));
}

struct Named {
    const char* name;
    std::string bsdf;
    std::uint32_t sample_share = 1;  // divisor of the number of samples
};

std::string plastic(const char* alpha) {
    return std::string(R"(<bsdf type="pplastic"><rgb name="diffuse_reflectance" value="0.6,0.35,0.1"/>)"
                       R"(<string name="distribution" value="ggx"/><float name="alpha" value=")") +
           alpha + R"("/></bsdf>)";
}

// Returns the path of the matrix that polarsh computed from the KAIST measurements.
std::optional<std::filesystem::path> measured_gold() {
    const char* data = std::getenv("NICOL_TEST_DATA");
    const auto path =
        std::filesystem::path(data == nullptr ? "" : data) / "polarsh/SHMat_6_gold_ds1_L20_ISOBI2.npz";
    if (!std::filesystem::exists(path)) return std::nullopt;
    return std::filesystem::absolute(path);
}

std::vector<Named> materials(Report& report) {
    std::vector<Named> list;
    list.push_back({"pplastic 0.1", plastic("0.1")});
    list.push_back({"pplastic 0.2", plastic("0.2")});
    list.push_back({"pplastic 0.3", plastic("0.3")});
    list.push_back({"rough gold 0.2", R"(<bsdf type="roughconductor"><string name="material" value="Au"/>)"
                                      R"(<float name="alpha" value="0.2"/></bsdf>)"});
    if (const auto gold = measured_gold()) {
        // A lookup in the measured matrix costs as much as a hundred of another material.
        list.push_back(
            {"measured gold",
             R"(<bsdf type="psh"><string name="filename" value=")" + gold->string() + R"("/></bsdf>)", 4});
    } else {
        report.note(
            "Measured gold is left out: NICOL_TEST_DATA has no polarsh/SHMat_6_gold_ds1_L20_ISOBI2.npz.");
    }
    return list;
}

/// Writes the half of the unit sphere that faces an orthographic camera, z >= 0, as OBJ: a vertex at the top
/// and `rings` circles of 6, 12, 18 ... vertices around it, with the sphere's normals; all triangles have
/// about the same size.
void write_sphere_cap(const std::filesystem::path& path, int rings) {
    std::ofstream out(path);
    out.precision(9);
    for (int ring = 0; ring <= rings; ++ring) {
        const double theta = std::numbers::pi / 2 * ring / rings;
        for (int i = 0; i < std::max(1, 6 * ring); ++i) {
            const double phi = 2 * std::numbers::pi * i / std::max(1, 6 * ring);
            const double x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi);
            out << "v " << x << ' ' << y << ' ' << std::cos(theta) << "\nvn " << x << ' ' << y << ' '
                << std::cos(theta) << '\n';
        }
    }
    // Vertices are numbered from 1; ring r begins after the rings inside it.
    const auto at = [](int ring, int i) {
        return ring == 0 ? 1 : 2 + 3 * ring * (ring - 1) + i % (6 * ring);
    };
    const auto triangle = [&](int a, int b, int c) {
        out << "f " << a << "//" << a << ' ' << b << "//" << b << ' ' << c << "//" << c << '\n';
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int sector = 0; sector < 6; ++sector) {
            for (int i = 0; i <= ring; ++i) {
                const int inner = sector * ring + i, outer = sector * (ring + 1) + i;
                triangle(at(ring, inner), at(ring + 1, outer), at(ring + 1, outer + 1));
                if (i < ring) triangle(at(ring, inner), at(ring + 1, outer + 1), at(ring, inner + 1));
            }
        }
    }
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

// Writes a scene whose light is a placeholder, which --light or the forest replaces.
void write_scene(const std::filesystem::path& path, const std::string& bsdf) {
    std::ofstream out(path);
    out << R"(<scene version="3.0.0"><sensor type="orthographic"><transform name="to_world"><scale value="1.03"/>)"
           R"(<lookat origin="0,0,4" target="0,0,0" up="0,1,0"/></transform></sensor><emitter type="constant"/>)"
           R"(<shape type="obj"><string name="filename" value="sphere.obj"/>)"
        << bsdf << "</shape></scene>\n";
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

std::string ratios(const char* material, const StokesErrors& split, int split_top,
                   const StokesErrors& convolution, int convolution_top) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "%s: split to %d errs %.2f, %.2f, %.2f of what convolution to %d does in s0, s1, s2.",
                  material, split_top, split[0] / convolution[0], split[1] / convolution[1],
                  split[2] / convolution[2], convolution_top);
    return text;
}

}  // namespace

Report bench_materials(const Options& given) {
    const std::uint32_t size = given.size == 0 ? 64 : given.size;
    const std::uint32_t samples = given.samples == 0 ? 2048 : given.samples;
    const int low = given.first_order < 0 ? 4 : given.first_order;
    const int last = given.last_order < 0 ? 64 : given.last_order;
    const int middle = std::clamp(9, low, last);  // top order in the paper
    const TemporaryFolder folder;
    write_sphere_cap(folder.path() / "sphere.obj", rings(size));
    Options options = given;
    options.scene = (folder.path() / "scene.xml").string();
    if (options.light.empty()) options.light = NICOL_BENCH_ASSETS "/forest.exr";

    Report report({"relative RMSE", "s0", "s1", "s2"});
    for (const auto& [material, bsdf, share] : materials(report)) {
        const auto& name = material;  // lambdas cannot capture structured bindings
        write_scene(options.scene, bsdf);
        const SceneSource source(options);
        const Comparison comparison(source, size, std::max(samples / share, 2U), false);
        const auto add = [&](const std::string& what, const StokesErrors& e) {
            report.add(std::string(name) + ": " + what, {e[0], e[1], e[2]});
            return e;
        };
        const auto measured = [&](const std::string& what, const Recipe& recipe) {
            return add(what, comparison.errors(recipe));
        };
        add("reference, its noise", comparison.truth().noise());
        const auto full = [&](int order) { measured("0.." + std::to_string(order), {.low = order}); };
        const auto beyond = [&](High high, int top) {
            const Recipe recipe{.low = low, .high = high, .top = top};
            return measured("0.." + recipe.name().substr(9), recipe);  // without "factored "
        };
        full(low);
        full(low + 1);
        const StokesErrors convolution = beyond(High::convolution, middle);
        StokesErrors split = beyond(High::split, middle);
        if (last > middle) {
            beyond(High::convolution, last);
            if (last > 32) beyond(High::split, 32);
            split = beyond(High::split, last);
            full(middle);
        }
        full(std::min(last, 32));
        report.note(ratios(name, split, last, convolution, middle));
    }
    report.note(
        "A sphere without shadows, all orders of the light in the reference. " + std::to_string(size) +
        " x " + std::to_string(size) + " pixels; relative to the RMS of s0; the noise of the reference, of " +
        std::to_string(samples) + " samples twice (measured gold: a quarter), is taken out of the errors.");
    return report;
}
