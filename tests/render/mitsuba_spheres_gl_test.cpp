// SPDX-License-Identifier: MIT
// Tests of spheres under an emissive surface, a point light and an environment, and of magnified textures,
// against reference images of Mitsuba's own render tests.
#include "gl/contexts.hpp"
#include "image/exr_colors.hpp"
#include "image_difference.hpp"
#include "import/load_scene.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using test::minus;
using test::rms;
using test::Studio;

namespace {

constexpr const char* kFolder = "mitsuba_scenes/tests/scenes/bsdf_spheres";

/// Limits of the RMSE of s0 divided by the RMS of the reference, whose own noise is about 0.01.
struct Limits {
    const char* name;
    double reference_method;
    /// Limit of the default method with one sample per pixel, whose outlines are jagged and normals averaged.
    /// 0: not rendered, because its environment takes long.
    double pixels;
    double samples;  ///< limit of the default method with 25 samples per pixel
};

void check_spheres(const std::filesystem::path& folder, const Limits& limits) {
    CAPTURES(limits.name);
    const std::string name = limits.name;
    const LoadedScene loaded = load_scene(folder / ("test_" + name + "_path.xml"), {});
    const StokesImage expected =
        unpolarized_image(read_exr_colors(folder / "refs" / ("test_" + name + "_ref_rgb.exr")));
    REQUIRE(loaded.width == expected.width);
    REQUIRE(loaded.height == expected.height);
    // One backend is enough, because the image does not depend on it.
    Studio render(gl::make_context(gl::Backend::osmesa), loaded.width, loaded.height);
    const auto error = [&](const RenderOptions& options) {
        StokesImage image = render(loaded.scene, options, loaded.camera);
        // The references have only s0.
        for (std::size_t i = 0; i < image.data.size(); ++i)
            if (i % 4 != 0) image.data[i] = 0;
        return rms(minus(image, expected)) / rms(expected);
    };
    CHECK(error({.method = Method::reference, .samples = 192}) < limits.reference_method);
    if (limits.pixels == 0) return;
    // Few directions are enough, because spheres apart hide little light from each other.
    RenderOptions automatic{
        .bake_directions = 256, .shade_at = ShadeAt::automatic, .choose_orders = true, .physical = true};
    CHECK(error(automatic) < limits.pixels);
    automatic.pixel_samples = 25;
    CHECK(error(automatic) < limits.samples);
}

}  // namespace

TEST_CASE("spheres with textures look as in Mitsuba's references") {
    const std::filesystem::path folder = test_data(kFolder);
    if (folder.empty()) return;
    for (const Limits& limits :
         {Limits{"textured_diffuse", 0.012, 0.055, 0.02}, Limits{"normalmap", 0.025, 0.095, 0.04},
          Limits{"bumpmap", 0.025, 0.09, 0.035}, Limits{"textured_roughconductor", 0.03, 0.4, 0.1},
          // The squares are smaller than a pixel, and the highlight covers a few pixels.
          Limits{"texturedprincipled1", 0.02, 0.4, 0.18}, Limits{"texturedprincipled2", 0.02, 0.37, 0.12},
          // Under a point light the mean of a pixel's mapped normals has one highlight or none.
          Limits{"normalmap_identity_roughconductor", 0.02, 0.15, 0.09},
          Limits{"normalmap_roughconductor", 0.06, 1.3, 0.26}})
        check_spheres(folder, limits);
}

TEST_CASE("spheres of plastic, glass, metal and cut-out leaves look as in Mitsuba's references") {
    const std::filesystem::path folder = test_data(kFolder);
    if (folder.empty()) return;
    for (const Limits& limits :
         // One highlight smaller than a pixel causes nearly all of the first error. Glass shows what is
         // behind it, which these references of direct light do not.
         {Limits{"pointlight", 0.025, 0.17, 0.15}, Limits{"constant", 0.008, 0.08, 0.018},
          // The mirrored lamps are a pixel wide, and a single sample hits them or not.
          Limits{"arealight", 0.12, 1.4, 0.2}, Limits{"roughplastic_nonlinear", 0.02, 0, 0},
          Limits{"roughdielectric", 0.03, 0, 0}})
        check_spheres(folder, limits);
}

TEST_CASE("magnified textures look as in Mitsuba's reference, however they are wrapped and interpolated") {
    const std::filesystem::path folder = test_data("mitsuba_scenes/tests/scenes/texture_interp");
    if (folder.empty()) return;
    const LoadedScene loaded = load_scene(folder / "test_texture_interp_direct.xml", {});
    const StokesImage expected =
        unpolarized_image(read_exr_colors(folder / "refs" / "test_texture_interp_ref_rgb.exr"));
    Studio render(gl::make_context(gl::Backend::osmesa), loaded.width, loaded.height);
    const auto error = [&](const ReconstructionFilter& filter) {
        const RenderOptions options{.shade_at = ShadeAt::automatic, .pixel_samples = 64, .filter = filter};
        return rms(minus(render(loaded.scene, options, loaded.camera), expected)) / rms(expected);
    };
    // The border between texels is as wide as the film's filter, which is not a box.
    CHECK(error(loaded.filter) < 0.01);
    CHECK(error({}) > 0.05);
}
