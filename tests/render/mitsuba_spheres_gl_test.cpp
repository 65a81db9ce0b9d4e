// SPDX-License-Identifier: MIT
// Textured spheres under a surface that shines, a point light and an environment, against Mitsuba's
// references of its own render tests.
#include "gl/contexts.hpp"
#include "image/exr_colors.hpp"
#include "image_difference.hpp"
#include "render/scenes.hpp"
#include "scene/load_scene.hpp"

using namespace nicol;
using test::minus;
using test::rms;
using test::Studio;

namespace {

constexpr const char* kFolder = "mitsuba_scenes/tests/scenes/bsdf_spheres";

/// s0 of an image whose pixels are side x side pixels of this one.
StokesImage coarser(const StokesImage& image, int side) {
    StokesImage out(image.width / side, image.height / side, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                out.at(c, y / side, x / side)[0] +=
                    image.at(c, y, x)[0] / static_cast<float>(side) / static_cast<float>(side);
    return out;
}

}  // namespace

GL_TEST_CASE("spheres with textures look as in Mitsuba's references") {
    const std::filesystem::path folder = test_data(kFolder);
    if (folder.empty()) return;
    // RMSE of s0 over the RMS of the reference, whose own noise is about 0.01.
    struct Case {
        const char* name;
        double reference_method;
        double
            pixels;  ///< the default method: one sample a pixel, whose outlines are jagged and normals a mean
        double samples;  ///< the same with 5 x 5 pixels in place of one
    };
    for (const auto& [name, reference_method, pixels, samples] :
         {Case{"textured_diffuse", 0.012, 0.055, 0.02}, Case{"normalmap", 0.025, 0.095, 0.04},
          Case{"bumpmap", 0.025, 0.09, 0.035}}) {
        CAPTURES(name);
        const LoadedScene loaded = load_scene(folder / ("test_" + std::string(name) + "_path.xml"), {});
        const StokesImage expected = unpolarized_image(
            read_exr_colors(folder / "refs" / ("test_" + std::string(name) + "_ref_rgb.exr")));
        REQUIRE(loaded.width == expected.width);
        REQUIRE(loaded.height == expected.height);
        Studio render(context);
        const auto error = [&](const RenderOptions& options, int side) {
            render.width = side * loaded.width;
            render.height = side * loaded.height;
            return rms(minus(coarser(render(loaded.scene, options, loaded.camera), side), expected)) /
                   rms(expected);
        };
        CHECK(error({.method = Method::reference}, 1) < reference_method);
        const RenderOptions automatic{
            .shade_at = ShadeAt::automatic, .choose_orders = true, .physical = true};
        CHECK(error(automatic, 1) < pixels);
        CHECK(error(automatic, 5) < samples);
    }
}
