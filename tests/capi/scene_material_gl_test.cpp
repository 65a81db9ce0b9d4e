// SPDX-License-Identifier: MIT
// Tests of scene files with every kind of material and light against the reference method.
#include "capi.hpp"
#include "image/stokes_image.hpp"
#include "material/material_projection.hpp"
#include "material/pbsdf_file.hpp"
#include "material/psh_matrix_file.hpp"

using namespace capi_test;
using doctest::Approx;

namespace {

const std::string sky =
    "<emitter type='sky'><vector name='sun_direction' x='0.3' y='0.8' z='0.5'/>"
    "<rgb name='radiance' value='1,0.8,0.6'/></emitter>";

// Returns a scene of one flat square that fills the image, so that nothing is interpolated or hidden.
std::string scene_text(const std::string& bsdf, const std::string& emitter = sky,
                       const std::string& film = "", const std::string& rotation = "") {
    return "<scene version='3.0.0'><sensor type='perspective'><float name='fov' value='30'/>"
           "<transform name='to_world'><lookat origin='1,0.5,2' target='0,0,0' up='0,1,0'/></transform>"
           "<film type='hdrfilm'><integer name='width' value='6'/><integer name='height' value='5'/>" +
           film + "</film></sensor>" + emitter + "<shape type='rectangle'><transform name='to_world'>" +
           rotation + "<scale value='3'/></transform>" + bsdf + "</shape></scene>";
}

nicol_render_options options_of(nicol_method method, std::uint32_t order, std::uint32_t samples = 1) {
    nicol_render_options options = plain_options();
    options.method = method;
    options.order_low = options.order_high = order;
    options.samples = samples;
    options.shade_at = NICOL_SHADE_AT_PIXELS;  // the surface has only two triangles
    return options;
}

// Compares the factored method with the reference method. The sky has no order above 2, so the factored
// method loses nothing.
std::vector<float> check_against_reference(nicol_context context, const std::string& path, double tolerance) {
    const LoadedScene scene(context, path);
    const std::vector<float> factored = scene.image(options_of(NICOL_METHOD_FACTORED, 2));
    const Distance apart(factored, scene.image(options_of(NICOL_METHOD_REFERENCE, 2, 1024)));
    for (std::size_t p = 0; p < 4; ++p) CHECK(apart.error[p] < tolerance * apart.size[0]);
    return factored;
}

nicol::test::SFrameMueller retarder() {
    // The field is brighter in red and converts s2 into s3.
    return [](std::size_t wavelength, const glm::dvec3&, const glm::dvec3&) {
        nicol::Mueller m;
        m(0, 0) = m(1, 1) = (0.2 + 0.2 * static_cast<double>(wavelength)) / pi;
        m(2, 3) = 0.5 * m(0, 0);
        m(3, 2) = -m(2, 3);
        m(0, 1) = m(1, 0) = 0.3 * m(0, 0);
        return m;
    };
}

}  // namespace

TEST_CASE("materials of scene files agree with the reference method") {
    const TemporaryFolder folder;
    const auto angles = nicol::test::even_angles(17, 0, pi / 2);
    write_bytes(folder.file("table.pbsdf"),
                nicol::test::make_pbsdf(nicol::test::even_angles(9, -pi, pi), angles, angles, {460, 550, 610},
                                        retarder())
                    .bytes());
    const nicol::MaterialPtr rough = nicol::pplastic({.alpha = 0.5});
    nicol::write_psh_matrix(folder.file("matrix.npz"), std::vector{nicol::project_material(*rough, 0, 6)});
    on_every_backend([&](nicol_context context) {
        for (const auto& [bsdf, tolerance] : std::vector<std::pair<std::string, double>>{
                 {"<bsdf type='conductor'><string name='material' value='Cu'/></bsdf>", 4e-3},
                 {"<bsdf type='conductor'><rgb name='eta' value='0.2,0.5,1.2'/><float name='k' "
                  "value='3'/></bsdf>",
                  4e-3},
                 {"<bsdf type='roughconductor'><string name='material' value='Al'/><float name='alpha' "
                  "value='0.4'/><string name='distribution' value='ggx'/></bsdf>",
                  4e-3},
                 {"<bsdf type='conductor'><spectrum name='eta' value='400:1.6, 500:0.9, 700:0.2'/>"
                  "<spectrum name='k' value='400:1.9, 700:3.8'/></bsdf>",
                  4e-3},
                 {"<bsdf type='diffuse'><spectrum name='reflectance' value='400:0.1, 700:0.9'/></bsdf>",
                  2e-3},
                 {"<bsdf type='measured_polarized'><string name='filename' value='table.pbsdf'/></bsdf>",
                  8e-3},
                 {"<bsdf type='measured_polarized'><string name='filename' value='table.pbsdf'/>"
                  "<float name='wavelength' value='600'/></bsdf>",
                  8e-3},
                 {"<bsdf type='psh'><string name='filename' value='matrix.npz'/>"
                  "<rgb name='scale' value='1,0.5,0.25'/></bsdf>",
                  8e-3},
             }) {
            const std::string text = scene_text(bsdf);
            CAPTURE(text);
            const std::string path = folder.write("scene.xml", text);
            const std::vector<float> front = check_against_reference(context, path, tolerance);
            CHECK(front[0] > 0.02F);
            // The back is visible only with a two-sided material.
            const std::string rotated = "<rotate y='1' angle='180'/>";
            const LoadedScene one(context, folder.write("one.xml", scene_text(bsdf, sky, "", rotated)));
            CHECK(largest(one.image(options_of(NICOL_METHOD_FACTORED, 2))) == 0);
            const std::string both = folder.write(
                "both.xml", scene_text("<bsdf type='twosided'>" + bsdf + "</bsdf>", sky, "", rotated));
            const std::vector<float> back = check_against_reference(context, both, tolerance);
            CHECK(largest_difference(back, front) < 2e-3);
        }
    });
}

TEST_CASE("a film of luminance has one channel, the sum of the colours") {
    const TemporaryFolder folder;
    const std::string bsdf =
        "<bsdf type='pplastic'><rgb name='diffuse_reflectance' value='0.8,0.4,0.1'/></bsdf>";
    const std::string rgb = folder.write("rgb.xml", scene_text(bsdf));
    const std::string grey =
        folder.write("grey.xml", scene_text(bsdf, sky, "<string name='pixel_format' value='luminance'/>"));
    on_every_backend([&](nicol_context context) {
        const LoadedScene colours(context, rgb), luminance(context, grey);
        CHECK((colours.channels == 3 && luminance.channels == 1));
        const auto options = options_of(NICOL_METHOD_FACTORED, 2);
        check_luminance(luminance.image(options), colours.image(options), 1e-4);
    });
}

TEST_CASE("what a scene names and is not there or of the wrong colours is refused by name") {
    const TemporaryFolder folder;
    nicol::StokesImage spectral(4, 3, 5);
    spectral.wavelengths = {450, 500, 550, 600, 650};
    for (std::size_t i = 0; i < spectral.data.size(); i += 4) spectral.data[i] = 1;
    nicol::write_exr(folder.file("spectral.exr"), spectral, {.components = 0});
    const std::string light =
        "<emitter type='envmap'><string name='filename' value='spectral.exr'/></emitter>";
    on_every_backend([&](nicol_context context) {
        nicol_scene scene = marker<nicol_scene>();
        const auto load = [&](const std::string& bsdf, const std::string& emitter = sky) {
            const std::string path = folder.write("bad.xml", scene_text(bsdf, emitter));
            return nicol_scene_load(context, path.c_str(), nullptr, 0, &scene);
        };
        folder.write("text.npz", "no archive");
        const auto named = [](const std::string& what, const std::string& file) {
            return "<" + what + "><string name='filename' value='" + file + "'/></" +
                   what.substr(0, what.find(' ')) + ">";
        };
        const std::string psh = "bsdf type='psh' id='it'", emitter = "emitter type='psh'",
                          red = "<bsdf type='diffuse'><rgb name='reflectance' value='1,0,0'/></bsdf>";
        const auto absent = NICOL_ERROR_FILE_NOT_FOUND, bad = NICOL_ERROR_INVALID_FILE;
        check_refused({
            {"absent.npz", [&] { return load(named(psh, "absent.npz")); }, absent},
            {"bsdf \"it\"", [&] { return load(named(psh, "absent.npz")); }, absent},
            {"a.pbsdf", [&] { return load(named("bsdf type='measured_polarized'", "a.pbsdf")); }, absent},
            {"absent.npz", [&] { return load("", named(emitter, "absent.npz")); }, absent},
            {"text.npz", [&] { return load(named(psh, "text.npz")); }, bad},
            {"text.npz", [&] { return load("", named(emitter, "text.npz")); }, bad},
            {"red, green and blue", [&] { return load(red, light); }, NICOL_ERROR_UNSUPPORTED},
        });
        CHECK(scene == marker<nicol_scene>());

        // Grey, tabulated and named-metal materials work with light of any wavelengths.
        for (const char* bsdf :
             {"<bsdf type='diffuse'/>", "<bsdf type='conductor'><string name='material' value='Au'/></bsdf>",
              "<bsdf type='diffuse'><spectrum name='reflectance' value='400:0, 800:0.8'/></bsdf>"}) {
            const LoadedScene loaded(context, folder.write("good.xml", scene_text(bsdf, light)));
            CHECK(loaded.channels == 5);
            const std::vector<float> all = loaded.image(options_of(NICOL_METHOD_FACTORED, 2));
            CHECK(all[0] > 0);
            if (std::string(bsdf).find("spectrum") == std::string::npos) continue;
            for (std::size_t c = 0; c < 5; ++c)
                CHECK(all[c * all.size() / 5] == Approx((spectral.wavelengths[c] - 400) / 500).epsilon(0.01));
        }
    });
}
