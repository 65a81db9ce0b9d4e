// SPDX-License-Identifier: MIT
#include "start_scenes.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "scene_file.hpp"

namespace {

using std::filesystem::path;

// Writes the surface z = height(x, y) over a square of side 2 at the origin, as PLY.
template <class Height>
std::string grid(const path& file, std::uint32_t cells, const Height& height) {
    std::ofstream out(file, std::ios::binary);
    const std::uint32_t side = cells + 1;
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << side * side
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << 2 * cells * cells
        << "\nproperty list uchar uint vertex_indices\nend_header\n";
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t j = 0; j < side; ++j) {
            const double x = 2.0 * j / cells - 1, y = 2.0 * i / cells - 1;
            const std::array place{static_cast<float>(x), static_cast<float>(y),
                                   static_cast<float>(height(x, y))};
            out.write(reinterpret_cast<const char*>(place.data()), sizeof place);
        }
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const std::array corners{a, b, c};
        out.put(3).write(reinterpret_cast<const char*>(corners.data()), sizeof corners);
    };
    for (std::uint32_t i = 0; i < cells; ++i)
        for (std::uint32_t j = 0; j < cells; ++j) {
            const std::uint32_t at = i * side + j;
            triangle(at, at + 1, at + side + 1);
            triangle(at, at + side + 1, at + side);
        }
    if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
    return R"(<shape type="ply"><string name="filename" value=")" + file.filename().string() + R"("/>)";
}

constexpr const char* kSky = R"(<emitter type="sky"><vector name="sun_direction" value="1,1,1"/></emitter>)";

std::string colored(std::uint32_t i) {
    return R"(<bsdf type="diffuse"><rgb name="reflectance" value="0.)" + std::to_string(2 + i % 6) + ",0." +
           std::to_string(2 + i * 5 % 7) + R"(,0.5"/></bsdf>)";
}

std::string placed(double x, double y, double z, double scale) {
    return R"(<transform name="to_world"><scale value=")" + std::to_string(scale) + R"("/><translate x=")" +
           std::to_string(x) + R"(" y=")" + std::to_string(y) + R"(" z=")" + std::to_string(z) +
           R"("/></transform>)";
}

std::string thirty_on_a_floor() {
    std::string shapes = R"(<shape type="rectangle">)" + placed(0, 0, 0, 8) + "</shape>";
    for (std::uint32_t i = 0; i < 30; ++i) {
        const double angle = 0.35 * i, radius = 0.5 + 0.12 * i;
        shapes += (i % 2 == 0 ? R"(<shape type="sphere">)" : R"(<shape type="cube">)") +
                  placed(radius * std::cos(angle), radius * std::sin(angle), 0.3, 0.3) + colored(i) +
                  "</shape>";
    }
    return shapes;
}

constexpr const char* kImage =
    R"( type="checkerboard"><float name="color0" value="0.2"/><float name="color1" value="0.6"/></texture>)";

}  // namespace

std::vector<StartScene> write_start_scenes(const path& folder) {
    constexpr double turn = 2 * std::numbers::pi;
    const std::string near = "0,-4,1.5", far = "0,-9,5";
    const std::string image(kImage);
    const std::array<std::array<std::string, 2>, 4> materials{
        {{"pplastic", R"(<bsdf type="pplastic"><float name="alpha" value="0.2"/></bsdf>)"},
         {"rough gold",
          R"(<bsdf type="roughconductor"><string name="material" value="Au"/><float name="alpha" value="0.3"/></bsdf>)"},
         {"principled",
          R"(<bsdf type="principled"><float name="metallic" value="0.5"/><float name="roughness" value="0.4"/>)"
          R"(<float name="clearcoat" value="0.5"/></bsdf>)"},
         {"principled with three textures", R"(<bsdf type="principled"><texture name="base_color")" + image +
                                                R"(<texture name="metallic")" + image +
                                                R"(<texture name="roughness")" + image + "</bsdf>"}}};
    const Recipe split{
        .low = 16, .high = High::split, .top = 64, .directions = 1024, .shade_at = NICOL_SHADE_AT_AUTOMATIC};
    const Recipe plain{.defaults = true, .shade_at = NICOL_SHADE_AT_AUTOMATIC};
    std::vector<StartScene> out;
    const auto add = [&](std::string name, const std::string& eye, const std::string& shapes,
                         std::uint32_t size, const Recipe& recipe) {
        const path file = folder / (std::to_string(out.size()) + ".xml");
        write_scene(file, eye, "0,0,0", kSky + shapes, "0,0,1");
        out.push_back({std::move(name), file.string(), size, recipe});
    };
    for (const auto& [name, material] : materials)
        add(name, near, R"(<shape type="sphere">)" + material + "</shape>", 192, split);
    add("cloth of 120,000 vertices", near,
        grid(folder / "cloth.ply", 346,
             [](double x, double y) {
                 return 0.1 * std::sin(2.2 * turn * x + 2 * std::sin(turn * y)) +
                        0.05 * std::sin(3 * turn * y + x);
             }) +
            colored(0) + "</shape>",
        192, plain);
    add("thirty spheres and cubes on a floor", far, thirty_on_a_floor(), 224, plain);
    add("a million triangles", near,
        grid(folder / "million.ply", 707,
             [](double x, double y) { return 0.2 * std::sin(2 * turn * x) * std::cos(2 * turn * y); }) +
            colored(3) + "</shape>",
        192, plain);
    return out;
}
