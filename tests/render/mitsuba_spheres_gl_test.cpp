// SPDX-License-Identifier: MIT
// Spheres under a surface that shines, a point light and an environment, against Mitsuba's references of its
// own render tests.
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

/// RMSE of s0 over the RMS of the reference, whose own noise is about 0.01.
struct Limits {
    const char* name;
    double reference_method;
    /// The default method: one sample a pixel, whose outlines are jagged and normals a mean. 0: not rendered,
    /// as its environment takes long.
    double pixels;
    double samples;  ///< the same with 5 x 5 pixels in place of one
};

template <class Context>
void check_spheres(const Context& context, const std::filesystem::path& folder, const Limits& limits) {
    CAPTURES(limits.name);
    const std::string name = limits.name;
    const LoadedScene loaded = load_scene(folder / ("test_" + name + "_path.xml"), {});
    const StokesImage expected =
        unpolarized_image(read_exr_colors(folder / "refs" / ("test_" + name + "_ref_rgb.exr")));
    REQUIRE(loaded.width == expected.width);
    REQUIRE(loaded.height == expected.height);
    Studio render(context);
    const auto error = [&](const RenderOptions& options, int side) {
        render.width = side * loaded.width;
        render.height = side * loaded.height;
        return rms(minus(coarser(render(loaded.scene, options, loaded.camera), side), expected)) /
               rms(expected);
    };
    CHECK(error({.method = Method::reference}, 1) < limits.reference_method);
    if (limits.pixels == 0) return;
    const RenderOptions automatic{.shade_at = ShadeAt::automatic, .choose_orders = true, .physical = true};
    CHECK(error(automatic, 1) < limits.pixels);
    CHECK(error(automatic, 5) < limits.samples);
}

}  // namespace

GL_TEST_CASE("spheres with textures look as in Mitsuba's references") {
    const std::filesystem::path folder = test_data(kFolder);
    if (folder.empty()) return;
    for (const Limits& limits :
         {Limits{"textured_diffuse", 0.012, 0.055, 0.02}, Limits{"normalmap", 0.025, 0.095, 0.04},
          Limits{"bumpmap", 0.025, 0.09, 0.035}, Limits{"textured_roughconductor", 0.03, 0.4, 0.08},
          // Squares smaller than a pixel, and a highlight of a few.
          Limits{"texturedprincipled1", 0.02, 0.4, 0.045}, Limits{"texturedprincipled2", 0.02, 0.37, 0.045},
          // Of a normal map under a point light the mean normal of a pixel has one highlight or none.
          Limits{"normalmap_identity_roughconductor", 0.02, 0.15, 0.07},
          Limits{"normalmap_roughconductor", 0.06, 1.3, 0.26}})
        check_spheres(context, folder, limits);
}

GL_TEST_CASE("spheres of plastic, glass, metal and cut-out leaves look as in Mitsuba's references") {
    const std::filesystem::path folder = test_data(kFolder);
    if (folder.empty()) return;
    for (const Limits& limits :
         {Limits{"pointlight", 0.025, 0.15, 0.025}, Limits{"constant", 0.008, 0.08, 0.012},
          Limits{"roughplastic_nonlinear", 0.02, 0, 0}, Limits{"roughdielectric", 0.03, 0, 0}})
        check_spheres(context, folder, limits);
}
