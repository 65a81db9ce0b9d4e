// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

#include "comparison.hpp"
#include "temporary_folder.hpp"

namespace {

struct Parts {
    const char* name;
    bool albedo, alpha;
    double tilt;  // largest tilt of normals, in degrees
};

constexpr Parts kRows[] = {{"no texture", false, false, 0}, {"albedo", true, false, 0},
                           {"alpha", false, true, 0},       {"normals", false, false, 20},
                           {"all three", true, true, 20},   {"steep normals", false, false, 40}};

struct View {
    const char* name;
    bool floor;
};

// Returns a wave of `count` crests across an image, -1 to 1.
double wave(double at, int count, double phase) {
    return std::sin(2 * std::numbers::pi * (count * at + phase));
}

// Returns a texture of value(u, v), so smooth that the filter does not matter.
template <std::size_t Channels, class Value>
nicol::Texture texture(nicol_context context, const Value& value) {
    constexpr std::uint32_t width = 512, height = 256;
    std::vector<float> pixels;
    for (std::uint32_t row = 0; row < height; ++row) {
        for (std::uint32_t column = 0; column < width; ++column) {
            const std::array<double, Channels> texel = value((column + 0.5) / width, (row + 0.5) / height);
            for (const double channel : texel) pixels.push_back(static_cast<float>(channel));
        }
    }
    nicol_texture_image image = NICOL_TEXTURE_IMAGE_INIT;
    image.type = NICOL_TEXEL_FLOAT32;
    image.width = width;
    image.height = height;
    image.channels = Channels;
    image.pixels = pixels.data();
    image.byte_size = pixels.size() * sizeof(float);
    nicol_texture out = nullptr;
    check(nicol_texture_create_image(context, &image, nullptr, &out));
    return nicol::Texture(out);
}

nicol::Texture albedo(nicol_context context) {
    return texture<3>(context, [](double u, double v) {
        const double w = 0.5 * wave(u, 5, 0) * wave(v, 3, 0.1);
        return std::array{0.45 + 0.6 * w, 0.4 + 0.3 * w, 0.35 - 0.5 * w};
    });
}

nicol::Texture alpha(nicol_context context) {
    return texture<1>(
        context, [](double u, double v) { return std::array{0.3 + 0.2 * wave(u, 4, 0.2) * wave(v, 3, 0)}; });
}

// Returns normals tilted by up to `tilt` degrees, reached where both slopes are largest.
nicol::Texture normals(nicol_context context, double tilt) {
    const double most = std::tan(tilt * std::numbers::pi / 180) / std::numbers::sqrt2;
    return texture<3>(context, [most](double u, double v) {
        const double x = most * wave(u, 7, 0.3), y = most * wave(v, 4, 0.4);
        const double length = std::sqrt(x * x + y * y + 1);
        return std::array{0.5 + 0.5 * x / length, 0.5 + 0.5 * y / length, 0.5 + 0.5 / length};
    });
}

Material plastic(nicol_context context, const Parts& parts) {
    nicol::Texture colours, roughness;
    nicol_pplastic parameters = NICOL_PPLASTIC_INIT;
    parameters.distribution = NICOL_DISTRIBUTION_GGX;
    parameters.alpha = 0.3F;
    parameters.diffuse_reflectance.count = 3;
    for (int c = 0; c < 3; ++c)
        parameters.diffuse_reflectance.values[c] = 0.45F - 0.05F * static_cast<float>(c);
    if (parts.albedo) {
        colours = albedo(context);
        parameters.diffuse_reflectance_texture = colours.get();
    }
    if (parts.alpha) {
        roughness = alpha(context);
        parameters.alpha_texture = roughness.get();
    }
    nicol_material handle = nullptr;
    check(nicol_material_create_pplastic(context, &parameters, &handle));
    Material out(handle);
    if (parts.tilt == 0) return out;
    check(
        nicol_material_create_normal_map(context, out.get(), normals(context, parts.tilt).get(), 0, &handle));
    return Material(handle);
}

// Writes a floor of so many squares that the part hidden by the sphere changes little between squares.
void write_floor(const std::filesystem::path& path) {
    constexpr int squares = 96;
    constexpr double half = 3;
    std::ofstream out(path);
    for (int row = 0; row <= squares; ++row) {
        for (int column = 0; column <= squares; ++column) {
            const double u = static_cast<double>(column) / squares, v = static_cast<double>(row) / squares;
            out << "v " << half * (2 * u - 1) << " -1 " << half * (1 - 2 * v) << "\nvt " << u << ' ' << v
                << '\n';
        }
    }
    out << "vn 0 1 0\n";
    const auto corner = [&](int number) { out << ' ' << number << '/' << number << "/1"; };
    for (int row = 0; row < squares; ++row) {
        for (int column = 0; column < squares; ++column) {
            const int a = 1 + row * (squares + 1) + column, b = a + squares + 1;
            for (const auto& triangle : {std::array{a, a + 1, b + 1}, std::array{a, b + 1, b}}) {
                out << 'f';
                for (const int number : triangle) corner(number);
                out << '\n';
            }
        }
    }
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

// Writes a scene whose light and materials are placeholders.
void write_scene(const std::filesystem::path& path, bool floor) {
    std::ofstream out(path);
    out << R"(<scene version="3.0.0"><sensor type="perspective"><float name="fov" value=")"
        << (floor ? 40 : 24) << R"("/><transform name="to_world"><lookat origin="1.5,2.5,4.5" target="0,)"
        << (floor ? -0.4 : 0)
        << R"(,0" up="0,1,0"/></transform></sensor><emitter type="constant"/>)"
           R"(<shape type="sphere"><transform name="to_world"><rotate x="1" angle="-90"/></transform></shape>)";
    if (floor) out << R"(<shape type="obj"><string name="filename" value="floor.obj"/></shape>)";
    out << "</scene>\n";
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace

Report bench_textures(const Options& given) {
    const std::uint32_t size = given.size == 0 ? 192 : given.size;
    const std::uint32_t samples = given.samples == 0 ? 1024 : given.samples;
    const int low = given.first_order < 0 ? 9 : given.first_order;
    const int high = given.last_order < 0 ? 64 : given.last_order;
    const TemporaryFolder folder;
    write_floor(folder.path() / "floor.obj");
    Options options = given;
    options.scene = (folder.path() / "scene.xml").string();
    if (options.light.empty()) options.light = NICOL_BENCH_ASSETS "/forest.exr";

    Report report({"relative RMSE", "s0", "s1", "s2", "DoLP, mean"});
    for (const View& view : {View{"sphere", false}, View{"sphere on a floor", true}}) {
        write_scene(options.scene, view.floor);
        SceneSource source(options);
        for (const Parts& parts : kRows) {
            source.set_material(plastic(source.context(), parts));
            const Comparison comparison(source, size, samples, true);
            const std::string name = std::string(view.name) + ", " + parts.name + ": ";
            const StokesErrors noise = comparison.truth().noise();
            report.add(name + "reference, its noise", {noise[0], noise[1], noise[2]});
            for (const Recipe& recipe :
                 {Recipe{.low = low, .high = High::split, .top = high, .shade_at = NICOL_SHADE_AT_PIXELS},
                  Recipe{.defaults = true, .shade_at = NICOL_SHADE_AT_PIXELS}}) {
                const Comparison::Measured m = comparison.measure(recipe);
                report.add(name + recipe.name(),
                           {m.errors[0], m.errors[1], m.errors[2], m.polarization.dolp});
            }
        }
    }
    report.note(
        "Plastic of alpha 0.3, by its texture 0.1 to 0.5; normals tilted by up to 20 degrees, steep ones "
        "40; " +
        std::to_string(size) + " x " + std::to_string(size) +
        " pixels; relative to the RMS of s0; the noise of the reference, of " + std::to_string(samples) +
        " samples twice, is taken out of the errors.");
    return report;
}
