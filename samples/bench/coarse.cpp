// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

#include "comparison.hpp"
#include "lamp_room.hpp"
#include "temporary_folder.hpp"
#include "wavy_torus.hpp"

namespace {

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
    const Triangles coarse = wavy_torus(48, 30);
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
