// SPDX-License-Identifier: MIT
#include "textured_frame.hpp"

#include <cmath>
#include <numbers>

#include "frame_times.hpp"
#include "scene_file.hpp"

namespace {

constexpr float kAlpha = 0.3F;

// Returns the light and the shapes: a ball on a floor.
std::string ball_on_floor() {
    return R"(<emitter type="constant"/><bsdf type="pplastic" id="plastic">)"
           R"(<rgb name="diffuse_reflectance" value="0.6,0.3,0.1"/><float name="alpha" value=")" +
           std::to_string(kAlpha) +
           R"("/></bsdf><shape type="sphere"><ref id="plastic"/></shape><shape type="rectangle">)"
           R"(<transform name="to_world"><rotate x="1" angle="-90"/><scale value="2.5"/>)"
           R"(<translate y="-1"/></transform><ref id="plastic"/></shape>)";
}

// Returns a texture of value(u, v, channel), 0 to 1.
template <class Value>
nicol::Texture image(nicol_context context, std::uint32_t channels, nicol_texture_options options,
                     const Value& value) {
    constexpr std::uint32_t side = 1024;
    std::vector<std::uint8_t> texels;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            for (std::uint32_t c = 0; c < channels; ++c)
                texels.push_back(static_cast<std::uint8_t>(
                    std::lround(255 * value((x + 0.5) / side, (y + 0.5) / side, c))));
    nicol_texture_image wanted = NICOL_TEXTURE_IMAGE_INIT;
    wanted.type = NICOL_TEXEL_UINT8;
    wanted.width = wanted.height = side;
    wanted.channels = channels;
    wanted.pixels = texels.data();
    wanted.byte_size = texels.size();
    nicol_texture handle = nullptr;
    check(nicol_texture_create_image(context, &wanted, &options, &handle));
    return nicol::Texture(handle);
}

// Returns the plastic with images of albedo, roughness and normals.
Material textured(nicol_context context, nicol_texture_filter filter) {
    constexpr double turn = 2 * std::numbers::pi;
    nicol_texture_options options = NICOL_TEXTURE_OPTIONS_INIT;
    options.filter = filter;
    const nicol::Texture albedo = image(context, 3, options, [](double u, double v, std::uint32_t c) {
        return 0.5 + 0.4 * std::sin(5 * turn * u + c) * std::cos(5 * turn * v);
    });
    options.raw = 1;
    const nicol::Texture alpha = image(context, 1, options, [](double u, double v, std::uint32_t) {
        return kAlpha + 0.2 * std::sin(2 * turn * u) * std::cos(2 * turn * v);
    });
    const nicol::Texture normals = image(context, 3, options, [](double u, double v, std::uint32_t c) {
        const double x = 0.3 * std::sin(8 * turn * u), y = 0.3 * std::cos(8 * turn * v);
        const double normal[3] = {x, y, 1};
        return 0.5 + 0.5 * normal[c] / std::sqrt(x * x + y * y + 1);
    });
    nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
    plastic.diffuse_reflectance_texture = albedo.get();
    plastic.alpha_texture = alpha.get();
    nicol_material handle = nullptr;
    check(nicol_material_create_pplastic(context, &plastic, &handle));
    const Material flat(handle);
    check(nicol_material_create_normal_map(context, flat.get(), normals.get(), 0, &handle));
    return Material(handle);
}

}  // namespace

TextureCost texture_cost(const Options& given, const Recipe& recipe, std::uint32_t size) {
    const TemporaryFolder folder;
    Options options = given;
    options.scene = (folder.path() / "scene.xml").string();
    options.definitions.clear();
    if (options.light.empty()) options.light = NICOL_BENCH_ASSETS "/forest.exr";
    write_scene(options.scene, "2,3,4", "0,0,0", ball_on_floor());
    const SceneSource source(options);
    std::vector<Contestant> contestants;
    for (int i = 0; i < 3; ++i) contestants.emplace_back(source, recipe, size);
    contestants[1].set_material(textured(source.context(), NICOL_TEXTURE_FILTER_BILINEAR).get());
    contestants[2].set_material(textured(source.context(), NICOL_TEXTURE_FILTER_MIPMAP).get());
    const std::vector<FrameTimes> times = time_frames(contestants, options.seconds);
    return {.bilinear = times[1].camera / times[0].camera, .mipmap = times[2].camera / times[0].camera};
}
