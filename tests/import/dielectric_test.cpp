// SPDX-License-Identifier: MIT
// Tests of plastic, dielectric and null materials: results and refusals.
#include "material/dielectric.hpp"
#include "import/described_material.hpp"
#include "import/load_scene.hpp"
#include "import/scene_file.hpp"
#include "material/material.hpp"
#include "material/matrix_at.hpp"
#include "material/mixture.hpp"

using namespace nicol;

namespace {

const std::string once = "<integrator type='path'><integer name='max_depth' value='2'/></integrator>\n";

MaterialDescription material(const std::string& bsdf, const std::string& integrator = "") {
    const SceneDescription s = read(shape_with(bsdf) + integrator);
    REQUIRE(s.materials.size() == 1);
    return s.materials[0];
}

bool has_notice(const std::vector<std::string>& notices, const std::string& part) {
    return std::ranges::count_if(
               notices, [&](const std::string& n) { return n.find(part) != std::string::npos; }) == 1;
}

/// Checks that reading fails with every part. `content` begins on line 2.
void refused(const std::string& content, ErrorCode code, int line, const std::vector<std::string>& parts) {
    const SceneFile file(::scene(content));
    CAPTURE(content);
    check_refused(file, code, file.scene().string() + ":" + std::to_string(line) + ": ", parts);
}

/// Returns m00 of a scene's material in the first channel, for the mirror direction at 45 degrees.
double mirrored(const std::string& bsdf, bool* smooth = nullptr) {
    const LoadedScene loaded = load_scene(SceneFile(::scene(shape_with(bsdf) + once)).scene(), {});
    const Material& made = *loaded.scene.instances().front().material;
    if (smooth != nullptr) *smooth = made.smooth(made.terms() - 1);
    const double half = std::sqrt(0.5);
    return evaluate(made, 0, {half, 0, half}, {-half, 0, half})(0, 0);
}

}  // namespace

TEST_CASE("plastic and roughplastic: Mitsuba's defaults and parameters") {
    using P = PlasticParameters;
    const auto smooth = as<PlasticModel>(material("<bsdf type='plastic'/>"));
    CHECK(smooth.parameters.alpha.value == 0);
    CHECK(smooth.parameters.int_ior == 1.49);
    CHECK(smooth.parameters.ext_ior == 1.000277);
    CHECK(color(smooth, &P::diffuse_reflectance).rgb == glm::dvec3(0.5));
    CHECK(color(smooth, &P::specular_reflectance).rgb == glm::dvec3(1));
    CHECK_FALSE(smooth.parameters.nonlinear);
    const auto rough = as<PlasticModel>(material(
        "<bsdf type='roughplastic'><boolean name='nonlinear' value='true'/><float name='alpha' value='0.4'/>"
        "<string name='distribution' value='ggx'/><string name='int_ior' value='diamond'/>"
        "<texture type='checkerboard' name='diffuse_reflectance'/>"
        "<boolean name='sample_visible' value='true'/></bsdf>"));
    CHECK(rough.parameters.alpha.value == 0.4);
    CHECK(rough.parameters.distribution == Distribution::ggx);
    CHECK(rough.parameters.int_ior == 2.419);
    CHECK(rough.parameters.nonlinear);
    CHECK(color(rough, &P::diffuse_reflectance).texture != nullptr);
    CHECK(as<PlasticModel>(material("<bsdf type='roughplastic'/>")).parameters.alpha.value == 0.1);

    // Both shapes share one notice.
    const SceneDescription both =
        read(shape_with("<bsdf type='plastic'/>") + "<shape type='cube'><bsdf type='roughplastic'/></shape>");
    CHECK(both.notices.size() == 1);
    CHECK(has_notice(both.notices, "scene.xml:4: plastic and roughplastic depolarize; pplastic"));
    refused("<bsdf type='plastic'>\n<float name='alpha' value='0.1'/></bsdf>", ErrorCode::invalid_file, 3,
            {"bsdf \"plastic\": parameter \"alpha\" is unknown", "nonlinear"});
    refused("<bsdf type='plastic'><float name='int_ior' value='1.000277'/></bsdf>", ErrorCode::invalid_file,
            2, {"must differ"});
}

TEST_CASE("glass is what its boundary reflects, where light is reflected once") {
    const std::string direct = "<integrator type='stokes'><integrator type='direct'/></integrator>";
    for (const std::string& integrator : {once, direct}) {
        const auto smooth = as<MetalModel>(
            material("<bsdf type='dielectric'><float name='int_ior' value='3'/>"
                     "<float name='ext_ior' value='2'/><float name='specular_transmittance' value='0.5'/>"
                     "<float name='specular_reflectance' value='0.25'/></bsdf>",
                     integrator));
        CHECK(smooth.parameters.alpha.value == 0);
        CHECK(smooth.eta.rgb == glm::dvec3(1.5));
        CHECK(smooth.k.rgb == glm::dvec3(0));
        CHECK(color(smooth, &RoughConductorParameters::specular_reflectance).rgb == glm::dvec3(0.25));
    }
    const auto rough = as<MetalModel>(
        material("<bsdf type='roughdielectric'><float name='alpha' value='0.3'/></bsdf>", once));
    CHECK(rough.parameters.alpha.value == 0.3);
    CHECK(rough.eta.rgb.x == doctest::Approx(1.5046 / 1.000277));
    const SceneDescription both = read(shape_with("<bsdf type='dielectric'/>") + once +
                                       "<shape type='cube'><bsdf type='roughdielectric'/></shape>");
    CHECK(both.notices.size() == 2);
    CHECK(has_notice(both.notices, "scene.xml:4: of dielectric and roughdielectric what passes through"));
}

TEST_CASE("light passes glass where it is to be reflected often, wherever the integrator stands") {
    const std::string often = "<integrator type='path'/>\n";
    const std::string coloured =
        "<float name='int_ior' value='3'/><float name='ext_ior' value='2'/>"
        "<rgb name='specular_transmittance' value='0.5, 0.25, 1'/>"
        "<float name='specular_reflectance' value='0.75'/></bsdf>";
    const auto boundary = [](const std::string& content) {
        const LoadedScene loaded = load_scene(SceneFile(::scene(content)).scene(), {});
        REQUIRE(loaded.scene.instances().front().material->smooth_boundary() != nullptr);
        return *loaded.scene.instances().front().material->smooth_boundary();
    };
    const std::string body = shape_with("<bsdf type='dielectric'>" + coloured);
    const std::string from_lamps = "<integrator type='ptracer'/>\n";
    // Without an integrator, Mitsuba reflects repeatedly.
    for (const std::string& content : {body + often, often + body, body + from_lamps, body}) {
        const SmoothBoundary made = boundary(content);
        CHECK(made.behind == SmoothBoundary::Behind::body);
        CHECK(made.eta == 1.5);
        CHECK(made.reflectance.front() == 0.75);
        CHECK(made.transmittance == std::vector{0.5, 0.25, 1.0});
    }
    CHECK(
        boundary(shape_with("<bsdf type='dielectric'><string name='int_ior' value='diamond'/></bsdf>")).eta ==
        doctest::Approx(2.419 / 1.000277));
    CHECK(boundary(shape_with("<bsdf type='dielectric'/>")).eta == doctest::Approx(1.5046 / 1.000277));
    // Light goes straight through a thin plate, so it passes with any integrator.
    for (const std::string& integrator : {often, once})
        CHECK(boundary(shape_with("<bsdf type='thindielectric'/>") + integrator).behind ==
              SmoothBoundary::Behind::slab);
}

TEST_CASE("rough glass and what principled materials transmit") {
    const auto boundary = [](const std::string& bsdf, const std::string& integrator = {}) {
        const LoadedScene loaded = load_scene(SceneFile(::scene(shape_with(bsdf) + integrator)).scene(), {});
        const SmoothBoundary* const found = loaded.scene.instances().front().material->smooth_boundary();
        return found != nullptr ? *found : SmoothBoundary{.eta = 0};
    };
    const SmoothBoundary rough = boundary(
        "<bsdf type='roughdielectric'><float name='alpha' value='0.3'/>"
        "<string name='distribution' value='ggx'/><float name='specular_transmittance' value='0.5'/></bsdf>");
    CHECK(rough.alpha == 0.3);
    CHECK(rough.distribution == Distribution::ggx);
    CHECK(rough.transmittance.front() == 0.5);
    CHECK(rough.eta == doctest::Approx(1.5046 / 1.000277));
    CHECK(boundary("<bsdf type='roughdielectric'/>").alpha == 0.1);
    // A texture's mean transmits.
    CHECK(boundary("<bsdf type='roughdielectric'><texture type='checkerboard' name='alpha'>"
                   "<float name='color0' value='0.1'/><float name='color1' value='0.3'/></texture></bsdf>")
              .alpha == doctest::Approx(0.2));

    const std::string clear =
        "<float name='spec_trans' value='0.5'/><float name='roughness' value='0.4'/>"
        "<rgb name='base_color' value='0.25, 1, 0.16'/></bsdf>";
    const SmoothBoundary body = boundary("<bsdf type='principled'>" + clear);
    CHECK(body.behind == SmoothBoundary::Behind::body);
    CHECK(body.alpha == doctest::Approx(0.16));
    CHECK(body.reflectance == std::vector{0.5});
    CHECK(body.transmittance[0] == doctest::Approx(0.25));
    CHECK(body.transmittance[2] == doctest::Approx(0.2));
    CHECK(boundary("<bsdf type='principled'>" + clear, once).eta == 0);
    CHECK(boundary("<bsdf type='principled'/>").eta == 0);
    const SmoothBoundary sheet = boundary("<bsdf type='principledthin'>" + clear);
    CHECK(sheet.behind == SmoothBoundary::Behind::slab);
    CHECK(sheet.transmittance[0] == doctest::Approx(0.125));
    CHECK(sheet.eta == 1.5);
}

TEST_CASE("films of metals, glass and pplastic colour what they reflect") {
    const std::string film = "<float name='film_thickness' value='350'/><float name='film_eta' value='2.2'/>";
    for (const std::string& bsdf :
         {"<bsdf type='conductor'><string name='material' value='Cr'/>" + film,
          "<bsdf type='roughconductor'><string name='material' value='Cr'/><float name='film_k' "
          "value='0.1'/>" +
              film,
          "<bsdf type='pplastic'>" + film}) {
        CAPTURE(bsdf);
        const LoadedScene loaded =
            load_scene(SceneFile(::scene(shape_with(bsdf + "</bsdf>") + once)).scene(), {});
        const Material& made = *loaded.scene.instances().front().material;
        const double half = std::sqrt(0.5);
        const auto seen = [&](int c) { return evaluate(made, c, {half, 0, half}, {-half, 0, half})(0, 0); };
        CHECK(made.channels() == 3);
        CHECK(std::abs(seen(0) - seen(2)) > 0.05 * seen(0));
    }
    const auto glass = [&](const std::string& type, const std::string& more = "") {
        const LoadedScene loaded = load_scene(
            SceneFile(::scene(shape_with("<bsdf type='" + type + "'>" + film + more + "</bsdf>"))).scene(),
            {});
        return *loaded.scene.instances().front().material->smooth_boundary();
    };
    for (const char* const type : {"dielectric", "roughdielectric", "thindielectric"}) {
        const SmoothBoundary coated = glass(type);
        REQUIRE(coated.film != nullptr);
        CHECK(coated.channels() == 3);
    }
    // A soap film in air bounds no other medium.
    const std::string air = "<float name='int_ior' value='1'/><float name='ext_ior' value='1'/>";
    CHECK(glass("dielectric", air).eta == 1);
    refused("<bsdf type='dielectric'>" + air + "</bsdf>", ErrorCode::invalid_file, 2, {"must differ"});
    refused("<bsdf type='conductor'><float name='film_thickness' value='-1'/></bsdf>",
            ErrorCode::invalid_file, 2, {"film_thickness"});
}

TEST_CASE("films of metals and pplastic vary by a texture of their thickness") {
    const std::string ends =
        "<float name='film_thickness_least' value='100'/><float name='film_thickness_most' value='500'/>";
    const auto made = [](const std::string& type, const std::string& film) {
        const std::string bsdf =
            "<bsdf type='" + type + "'>" + film + "<float name='film_eta' value='2.2'/></bsdf>";
        return load_scene(SceneFile(::scene(shape_with(bsdf) + once)).scene(), {})
            .scene.instances()
            .front()
            .material;
    };
    const auto board = [](double first, double second) {
        return "<texture type='checkerboard' name='film_thickness'><float name='color1' value='" +
               std::to_string(first) + "'/><float name='color0' value='" + std::to_string(second) +
               "'/></texture>";
    };
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.5, 0, 0.8)), viewer(-light.x, 0, light.z);
    for (const char* const type : {"conductor", "roughconductor", "pplastic"}) {
        CAPTURE(type);
        const MaterialPtr varying = made(type, board(0.25, 1) + ends);
        REQUIRE(varying->variation() != nullptr);
        const struct {
            float u;
            const char* thickness;
        } squares[] = {{0.1F, "200"}, {0.6F, "500"}};
        for (const auto& [u, thickness] : squares) {
            const MaterialPtr even =
                made(type, std::string("<float name='film_thickness' value='") + thickness + "'/>");
            for (int c = 0; c < 3; ++c)
                CHECK(test::matrix_at(*varying, c, {u, 0.1F}, light, viewer)(0, 0) ==
                      doctest::Approx(evaluate(*even, c, light, viewer)(0, 0)).epsilon(1e-5));
        }
    }
    refused("<bsdf type='pplastic'>" + board(0, 1) + "</bsdf>", ErrorCode::invalid_file, 2,
            {"film_thickness_most", "is missing"});
    refused(
        "<bsdf type='pplastic'>" + board(0, 1) + "<float name='film_thickness_most' value='10001'/></bsdf>",
        ErrorCode::invalid_file, 2, {"film_thickness_most", "10000"});
    refused("<bsdf type='pplastic'><float name='film_thickness' value='100'/>" + ends + "</bsdf>",
            ErrorCode::invalid_file, 2, {"film_thickness_"});
    refused(
        "<bsdf type='conductor'><texture type='mesh_attribute' name='film_thickness'><string name='name' "
        "value='vertex_color'/></texture>" +
            ends + "</bsdf>",
        ErrorCode::unsupported, 2, {"film_thickness", "colours of a mesh"});
    refused("<bsdf type='dielectric'>" + board(0, 1) + ends + "</bsdf>", ErrorCode::unsupported, 2,
            {"film_thickness", "one thickness"});
}

TEST_CASE("glass that no method follows is refused") {
    refused("<bsdf type='thindielectric'><texture type='checkerboard' name='specular_transmittance'/></bsdf>",
            ErrorCode::unsupported, 2, {"specular_transmittance", "constant colours"});
}

TEST_CASE("materials of boundaries are made as they are described") {
    bool smooth = false;
    const double glass = mirrored("<bsdf type='dielectric'/>", &smooth);
    CHECK(smooth);
    CHECK(glass > 0);
    CHECK(mirrored("<bsdf type='roughdielectric'><float name='alpha' value='0.01'/></bsdf>", &smooth) ==
          doctest::Approx(glass));
    CHECK_FALSE(smooth);
    CHECK(mirrored("<bsdf type='plastic'><float name='diffuse_reflectance' value='0'/>"
                   "<string name='int_ior' value='bk7'/></bsdf>",
                   &smooth) == doctest::Approx(glass));
    CHECK(smooth);
    CHECK(mirrored("<bsdf type='roughplastic'><float name='diffuse_reflectance' value='0'/>"
                   "<string name='int_ior' value='bk7'/><float name='alpha' value='0.02'/></bsdf>",
                   &smooth) < glass);
    CHECK_FALSE(smooth);
}

TEST_CASE("a null bsdf is a surface that is not there, but it may emit light") {
    CHECK(as<MaskModel>(material("<bsdf type='null'/>")).texture->color0.rgb == glm::dvec3(0));
    const LoadedScene loaded = load_scene(SceneFile(::scene(shape_with("<bsdf type='null'/>"))).scene(), {});
    const TexturePtr opacity = opacity_of(*loaded.scene.instances().front().material);
    REQUIRE(opacity != nullptr);
    CHECK(opacity->mean().x == 0);

    const SceneDescription shining = read_shape("<bsdf type='null'/><emitter type='area'/>");
    CHECK(shining.shapes.at(0).emission.has_value());
    CHECK(has_notice(shining.notices, "it is not seen through"));
    CHECK(as<DiffuseModel>(shining.materials.at(0)).reflectance.rgb == glm::dvec3(0));
}
