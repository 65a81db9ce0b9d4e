// SPDX-License-Identifier: MIT
// Tests of materials, instances, skies and films: results and refusals.
#include "image/aovs.hpp"
#include "import/described_material.hpp"
#include "import/scene_file.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr auto invalid = ErrorCode::invalid_file;
constexpr auto unsupported = ErrorCode::unsupported;

using P = RoughConductorParameters;

MaterialDescription material(const std::string& bsdf) {
    const SceneDescription s = read_shape(bsdf);
    REQUIRE(s.materials.size() == 1);
    return s.materials[0];
}

MetalModel metal(const std::string& bsdf) {
    return as<MetalModel>(material(bsdf));
}

EnvironmentDescription emitter(const std::string& xml) {
    return read(a_sensor + a_shape + xml).environment.value();
}

SensorDescription film(const std::string& parameters, std::vector<std::string>& notices) {
    const SceneDescription s =
        read(a_shape + an_emitter +
             "<sensor type='orthographic'><film type='hdrfilm'><integer name='width' value='40'/>" +
             parameters + "</film></sensor>");
    notices = s.notices;
    return s.sensor;
}

/// Checks that content from line 2 on is refused on `line` with every part.
void refused(const std::string& content, ErrorCode code, int line, const std::vector<std::string>& parts) {
    const SceneFile file(::scene(content));
    CAPTURE(content);
    check_refused(file, code, file.scene().string() + ":" + std::to_string(line) + ": ", parts);
}

void invalid_bsdf(const std::string& type, const std::string& inside, const std::vector<std::string>& parts) {
    refused("<bsdf type='" + type + "'>\n" + inside + "</bsdf>", invalid, 3, parts);
}

}  // namespace

TEST_CASE("conductors: defaults, metals, an index in numbers, colours and tables") {
    CHECK_FALSE(material("<bsdf type='conductor'/>").twosided);
    const MetalModel mirror = metal("<bsdf type='conductor'/>");
    CHECK(mirror.parameters.alpha.value == 0);
    CHECK(mirror.metal.empty());
    CHECK(mirror.eta.rgb == glm::dvec3(0.0));
    CHECK(mirror.k.rgb == glm::dvec3(1.0));
    CHECK(color(mirror, &P::specular_reflectance).rgb == glm::dvec3(1.0));
    for (const auto& [name, known] : {std::pair{"none", ""},
                                      {"Au", "Au"},
                                      {"gold", "gold"},
                                      {"au", "Au"},
                                      {"Aluminum", "aluminum"},
                                      {"TiN_palik", "TiN_palik"},
                                      {"a-C", "a-C"},
                                      {"W", "W"}})
        CHECK(
            metal(std::string("<bsdf type='conductor'><string name='material' value='") + name + "'/></bsdf>")
                .metal == known);
    const MetalModel rough = metal(
        "<bsdf type='roughconductor'><rgb name='eta' value='0.2, 0.9, 1.1'/><spectrum name='k' value='3.5'/>"
        "<rgb name='specular_reflectance' value='0.5'/><float name='alpha' value='0.3'/>"
        "<string name='distribution' value='GGX'/><boolean name='sample_visible' value='false'/></bsdf>");
    CHECK(rough.eta.rgb == glm::dvec3(0.2, 0.9, 1.1));
    CHECK(rough.k.rgb == glm::dvec3(3.5));
    CHECK(color(rough, &P::specular_reflectance).rgb == glm::dvec3(0.5));
    CHECK(rough.parameters.alpha.value == 0.3);
    CHECK(rough.parameters.distribution == Distribution::ggx);
    const MetalModel defaults = metal("<bsdf type='roughconductor'/>");
    CHECK(defaults.parameters.alpha.value == 0.1);
    CHECK(defaults.parameters.distribution == Distribution::beckmann);
    CHECK(metal("<bsdf type='roughconductor'><float name='alpha_u' value='0.2'/>"
                "<float name='alpha_v' value='0.2'/></bsdf>")
              .parameters.alpha.value == 0.2);
    const MetalModel table =
        metal("<bsdf type='conductor'><spectrum name='eta' value='400:1.5, 500.5:1.25 700:0.125'/></bsdf>");
    REQUIRE(table.eta.spectrum.size() == 3);
    CHECK(table.eta.spectrum[1].wavelength == 500.5);
    CHECK(table.eta.spectrum[1].value == 1.25);
    CHECK(table.eta.spectrum[2].wavelength == 700.0);
    CHECK(table.k.spectrum.empty());
}

TEST_CASE("conductors that are refused") {
    const std::string gold = "<string name='material' value='Au'/>";
    invalid_bsdf(
        "conductor", "<string name='material' value='Unobtainium'/>",
        {"bsdf \"conductor\": parameter \"material\" is \"Unobtainium\"", "expected none", "a-C, Ag, Al"});
    invalid_bsdf("conductor", "<float name='eta' value='1'/>" + gold, {"\"eta\" is given beside material"});
    invalid_bsdf("conductor", "<float name='k' value='1'/>" + gold, {"\"k\" is given beside material"});
    invalid_bsdf("conductor", "<rgb name='k' value='1, 0, 1'/>", {"\"k\"", "both 0"});
    invalid_bsdf("conductor", "<float name='eta' value='1e-6'/><float name='k' value='1e-6'/>",
                 {"\"k\"", "both 0 or close to it"});
    invalid_bsdf("conductor", "<float name='eta' value='100.5'/>", {"\"eta\"", "from 0 to 100"});
    invalid_bsdf("conductor", "<float name='k' value='-1'/>", {"\"k\"", "from 0 to 100"});
    invalid_bsdf("conductor", "<spectrum name='k' value='400:1 500:101'/>", {"\"k\"", "from 0 to 100"});
    invalid_bsdf("conductor", "<float name='alpha' value='0.1'/>", {"\"alpha\" is unknown"});
    invalid_bsdf("roughconductor", "<float name='alpha' value='1.5'/>",
                 {"\"alpha\" is 1.5", "from 0.001 to 1"});
    invalid_bsdf("roughconductor", "<float name='alpha_u' value='0.1'/>", {"\"alpha_u\" is given alone"});
    invalid_bsdf("roughconductor", "<float name='alpha_v' value='0.1'/>", {"\"alpha_v\" is given alone"});
    invalid_bsdf("roughconductor",
                 "<float name='alpha' value='.1'/><float name='alpha_u' value='.1'/><float name='alpha_v' "
                 "value='.1'/>",
                 {"\"alpha\" is given beside"});
}

TEST_CASE("tables over the wavelength are kept in every colour") {
    CHECK(as<DiffuseModel>(
              material("<bsdf type='diffuse'><spectrum name='reflectance' value='400:0, 700:1'/></bsdf>"))
              .reflectance.spectrum.size() == 2);
    CHECK(emitter("<emitter type='constant'><spectrum name='radiance' value='400:5 500:6 700:7'/></emitter>")
              .radiance.spectrum.size() == 3);
}

TEST_CASE("the scale of a matrix material is no table") {
    refused(
        "<bsdf type='psh'><string name='filename' value='a.npz'/>\n"
        "<spectrum name='scale' value='400:0.5, 700:1'/></bsdf>",
        unsupported, 3, {"\"scale\"", "one value or three"});
}

TEST_CASE("measured materials") {
    const auto measured = [](const std::string& bsdf) { return as<MeasuredModel>(material(bsdf)); };
    const MeasuredModel all = measured(
        "<bsdf type='measured_polarized'><string name='filename' value='/data/gold.pbsdf'/>"
        "<float name='alpha_sample' value='0.02'/></bsdf>");
    CHECK(all.filename == "/data/gold.pbsdf");
    CHECK_FALSE(all.wavelength);
    const std::string start = "<bsdf type='measured_polarized'><string name='filename' value='a.pbsdf'/>\n";
    CHECK(measured(start + "<float name='wavelength' value='550'/></bsdf>").wavelength == 550.0);
    CHECK_FALSE(measured(start + "<float name='wavelength' value='-1'/></bsdf>").wavelength);
    refused(start + "<float name='wavelength' value='-2'/></bsdf>", invalid, 3, {"\"wavelength\" is -2"});
    refused(start + "<float name='wavelength' value='0'/></bsdf>", invalid, 3, {"\"wavelength\" is 0"});
    refused("<bsdf type='measured_polarized'/>", invalid, 2, {"\"filename\" is missing"});
}

TEST_CASE("twosided takes one bsdf, nested or by reference, and leaves that one as it is") {
    const SceneDescription s =
        read(a_sensor + an_emitter +
             "<bsdf type='twosided' id='both'><ref id='gold'/></bsdf><bsdf type='psh' id='unused'>"
             "<string name='filename' value='a.npz'/></bsdf>"
             "<bsdf type='roughconductor' id='gold'><string name='material' value='Au'/></bsdf>"
             "<shape type='sphere'><ref id='both'/></shape><shape type='sphere'><ref id='gold'/></shape>"
             "<shape type='sphere'><bsdf type='twosided'><bsdf type='pplastic' id='inner'/><ref "
             "id='inner'/></bsdf></shape>");
    REQUIRE(s.materials.size() == 3);
    const auto of = [&](std::size_t i) { return s.materials.at(s.shapes.at(i).material); };
    CHECK(of(0).twosided);
    CHECK(of(0).id == "both");
    CHECK(as<MetalModel>(of(0)).metal == "Au");
    CHECK_FALSE(of(1).twosided);
    CHECK(of(1).id == "gold");
    CHECK(of(2).twosided);
    CHECK(is<PplasticModel>(of(2)));
    CHECK(of(2).id.empty());
    refused("<bsdf type='twosided'/>", invalid, 2, {"\"twosided\"", "no bsdf inside"});
    refused("<bsdf type='twosided'><bsdf type='diffuse'/>\n<bsdf type='diffuse'/></bsdf>", unsupported, 3,
            {"second bsdf", "both sides must be the same"});
    refused("<bsdf type='twosided'>\n<bsdf type='twosided'/></bsdf>", invalid, 3, {"inside another"});
    refused("<bsdf type='twosided' id='a'>\n<ref id='a'/></bsdf>", invalid, 3, {"inside another"});
    refused("<bsdf type='twosided'><float name='x' value='1'/></bsdf>", invalid, 2, {"\"x\" is unknown"});
}

TEST_CASE("an instance is each member of its group, moved") {
    const SceneDescription s =
        read(a_sensor + an_emitter +
             "<shape type='shapegroup' id='pair'>"
             "<shape type='sphere' id='ball'><transform name='to_world'><translate x='1'/></transform>"
             "<bsdf type='pplastic'/></shape><shape type='cube'/></shape>"
             "<shape type='instance' id='left'><ref id='pair'/><transform name='to_world'><scale value='2'/>"
             "<translate y='5'/></transform></shape><shape type='instance'><ref id='pair'/></shape>"
             "<shape type='instance'><shape type='shapegroup'><shape type='rectangle'/></shape></shape>");
    REQUIRE(s.shapes.size() == 5);
    CHECK(s.shapes[0].kind == ShapeDescription::Kind::sphere);
    CHECK(s.shapes[0].id == "left");
    CHECK(glm::dvec3(s.shapes[0].to_world * glm::dvec4(0, 0, 0, 1)) == glm::dvec3(2, 5, 0));
    CHECK(s.shapes[1].kind == ShapeDescription::Kind::cube);
    CHECK(glm::dvec3(s.shapes[1].to_world * glm::dvec4(1, 1, 1, 1)) == glm::dvec3(2, 7, 2));
    CHECK(glm::dvec3(s.shapes[2].to_world * glm::dvec4(0, 0, 0, 1)) == glm::dvec3(1, 0, 0));
    CHECK(s.shapes[2].id.empty());
    CHECK(s.shapes[2].material == s.shapes[0].material);
    CHECK(s.shapes[4].kind == ShapeDescription::Kind::rectangle);
    CHECK(s.materials.size() == 2);
}

TEST_CASE("instances and groups that are refused") {
    CHECK(read(a_sensor + "<shape type='merge'><shape type='cube'/><shape type='sphere'/></shape>")
              .shapes.size() == 2);
    const std::string group = "<shape type='shapegroup' id='g'><shape type='cube'/></shape>\n";
    refused(group + "<shape type='instance'/>", invalid, 3, {"shape \"instance\"", "0 shapes"});
    refused(group + "<shape type='instance'><ref id='g'/><ref id='g'/></shape>", invalid, 3, {"2 shapes"});
    refused("<shape type='cube' id='c'/>\n<shape type='instance'><ref id='c'/></shape>", invalid, 3,
            {"an instance of a shape \"cube\"", "shapegroup"});
    refused(group + "<shape type='instance'><ref id='g'/><bsdf type='diffuse'/></shape>", unsupported, 3,
            {"<bsdf> inside shape \"instance\""});
    refused("<shape type='shapegroup' id='g'>\n<shape type='instance'><ref id='g'/></shape></shape>",
            unsupported, 3, {"\"instance\" inside a shapegroup"});
    refused("<shape type='shapegroup' id='g'>\n<ref id='g'/></shape>", unsupported, 3,
            {"\"shapegroup\" inside a shapegroup"});
    refused("<shape type='shapegroup'>\n<transform name='to_world'/></shape>", invalid, 3,
            {"\"to_world\" is unknown"});
    refused(a_sensor + group, invalid, 1, {"no <shape>"});
    // A small file describes 400 times 400 shapes.
    std::string many = "<shape type='shapegroup' id='g'>";
    for (int i = 0; i < 400; ++i) many += "<shape type='cube'/>";
    many += "</shape>\n";
    for (int i = 0; i < 400; ++i) many += "<shape type='instance'><ref id='g'/></shape>";
    refused(many, unsupported, 3, {"more than 100000 shapes"});
}

TEST_CASE("objects by reference") {
    const SceneDescription s = read(
        "<film type='hdrfilm' id='film'><integer name='width' value='33'/><ref id='filter'/></film>"
        "<sampler type='multijitter' id='sampler'/><rfilter type='tent' id='filter'/>"
        "<sensor type='orthographic'><ref id='film'/><ref id='sampler'/></sensor>" +
        an_emitter + a_shape);
    CHECK(s.sensor.width == 33);
    CHECK(s.notices.empty());
    CHECK(s.sensor.filter == ReconstructionFilter{.kind = ReconstructionFilter::Kind::tent, .size = 1});
    refused("<sensor type='orthographic'/>" + a_shape + "<shape type='sphere'>\n<ref id='none'/></shape>",
            invalid, 4, {"<ref> to \"none\", an id that no element has"});
    refused("<rfilter type='box' id='f'/><sensor type='orthographic'>\n<ref id='f'/></sensor>", invalid, 3,
            {"which is a <rfilter>, inside sensor \"orthographic\"", "film, sampler"});
}

TEST_CASE("skies with turbidity") {
    const std::string sun = "<emitter type='sky'><vector name='sun_direction' x='1' y='0.5'/>\n";
    const EnvironmentDescription plain = emitter(sun + "</emitter>");
    CHECK(plain.turbidity == 0.0);
    CHECK(plain.ground_albedo.rgb == glm::dvec3(0.2));
    CHECK_FALSE(plain.sun);
    CHECK(emitter(sun + "<boolean name='sun' value='true'/></emitter>").sun);
    const EnvironmentDescription hazy = emitter(
        sun +
        "<float name='turbidity' value='3'/><rgb name='ground_albedo' value='0.1, 0.2, 0.3'/></emitter>");
    CHECK(hazy.turbidity == 3.0);
    CHECK(hazy.ground_albedo.rgb == glm::dvec3(0.1, 0.2, 0.3));
    for (const char* turbidity : {"1.6", "10.5", "-1"})
        refused(sun + "<float name='turbidity' value='" + turbidity + "'/></emitter>", invalid, 3,
                {"emitter \"sky\": parameter \"turbidity\"", "from 1.7 to 10"});
    refused(sun + "<rgb name='ground_albedo' value='1.5'/></emitter>", invalid, 3,
            {"\"ground_albedo\"", "from 0 to 1"});
    const std::string below = "<emitter type='sky'><vector name='sun_direction' x='1' y='-0.5'/>";
    CHECK(emitter(below + "</emitter>").sun_direction.y < 0.0);
    refused(below + "<float name='turbidity' value='3'/></emitter>", invalid, 2,
            {"\"sun_direction\" points below the horizon"});
}

TEST_CASE("film formats: what is asked for, and what is written instead") {
    std::vector<std::string> notices;
    const SensorDescription plain = film("", notices);
    CHECK_FALSE(plain.luminance);
    CHECK(notices.empty());
    film(
        "<string name='pixel_format' value='rgb'/><string name='component_format' value='float32'/>"
        "<string name='file_format' value='OpenEXR'/><boolean name='banner' value='true'/>"
        "<boolean name='compensate' value='true'/><boolean name='sample_border' value='false'/>"
        "<integer name='crop_offset_x' value='0'/><integer name='crop_width' value='40'/>"
        "<integer name='crop_height' value='576'/>",
        notices);
    CHECK(notices.empty());
    CHECK(film("<string name='pixel_format' value='luminance'/>", notices).luminance);
    CHECK(notices.empty());
    CHECK(film("<string name='pixel_format' value='luminance_alpha'/>", notices).luminance);
    REQUIRE(notices.size() == 1);
    CHECK(notices[0].ends_with("scene.xml:4: pixel_format luminance_alpha: images have no alpha channel."));
    CHECK_FALSE(film("<string name='pixel_format' value='rgba'/>", notices).luminance);
    CHECK(notices.size() == 1);
    for (const char* format : {"float16", "uint32"}) {
        film(std::string("<string name='component_format' value='") + format + "'/>", notices);
        REQUIRE(notices.size() == 1);
        CHECK(notices[0].ends_with(std::string("component_format ") + format +
                                   ": images are written as float32."));
    }
}

TEST_CASE("one notice for all that only steers Mitsuba's sampling") {
    const SceneDescription s = read(
        "<integrator type='path'><integer name='max_depth' value='3'/></integrator>\n"
        "<sensor type='orthographic'><film type='hdrfilm'><boolean name='sample_border' value='true'/></film>"
        "<sampler type='independent'/></sensor><emitter type='envmap'><string name='filename' value='a.exr'/>"
        "<boolean name='mis_compensation' value='true'/></emitter>" +
        a_shape);
    REQUIRE(s.notices.size() == 1);
    CHECK(
        s.notices[0].ends_with("scene.xml:2: not followed: integrator \"path\" (but for max_depth), "
                               "sample_border, mis_compensation."));
    const SceneDescription twice = read(
        "<integrator type='stokes'><integrator type='direct' id='d'/></integrator>" + a_sensor + a_shape +
        "<emitter type='envmap'><string name='filename' value='a.exr'/>"
        "<float name='sampling_weight' value='2'/></emitter>");
    REQUIRE(twice.notices.size() == 1);
    CHECK(twice.notices[0].ends_with("integrator \"stokes\", integrator \"direct\", sampling_weight."));
    refused("<integrator type='path'/>\n<integrator type='path'/>", invalid, 3, {"second integrator"});
    refused("<integrator type='moment' id='a'>\n<ref id='a'/></integrator>", invalid, 2,
            {"more than 16 integrators", "refer to itself"});
    refused("<integrator type='path'>\n<integrator type='direct'/></integrator>", unsupported, 3,
            {"<integrator> inside integrator \"path\""});
}

TEST_CASE("integrators that hold others") {
    const auto notices = [](const std::string& integrator) {
        return read(integrator + a_sensor + a_shape).notices;
    };
    const auto listed = notices(
        "<default name='integrator' value='volpath'/><integrator type='moment'><integrator type='aov'>"
        "<string name='aovs' value='dd.y:depth'/><integrator type='$integrator'/>"
        "<integrator type='depth'/></integrator></integrator>");
    REQUIRE(listed.size() == 1);
    CHECK(
        listed[0].ends_with("not followed: integrator \"moment\", integrator \"volpath\" "
                            "(but for max_depth), integrator \"depth\"."));
    const std::string hide = "<boolean name='hide_emitters' value=";
    struct Case {
        std::string inner;
        bool hide_emitters;
        int max_depth;
    };
    for (const Case& c :
         {Case{"<integrator type='path'>" + hide + "'false'/></integrator>", false, kUnlimitedDepth},
          Case{"<integrator type='path'>" + hide +
                   "'true'/><integer name='max_depth' value='2'/></integrator>",
               true, 2},
          Case{"<integrator type='direct'/>", false, 2},
          Case{"<integrator type='path'><integer name='max_depth' value='1'/></integrator>", false, 1},
          Case{"", false, 2},
          Case{"<integrator type='volpath'><integer name='max_depth' value='3'/></integrator>", false, 3}}) {
        const IntegratorDescription integrator =
            read("<integrator type='moment'>" + c.inner + "</integrator>" + a_sensor + a_shape).integrator;
        CHECK(integrator.hide_emitters == c.hide_emitters);
        CHECK(integrator.max_depth == c.max_depth);
        CHECK(integrator.reflects_often() == (c.max_depth > 2));
    }
}

TEST_CASE("AOVs of integrators") {
    const auto described = [](const std::string& list) {
        return read("<integrator type='aov'>\n<string name='aovs' value='" + list +
                    "'/><integrator type='direct'/></integrator>" + a_sensor + a_shape);
    };
    struct Case {
        const char* list;
        std::uint32_t aovs;
        const char* missing;
    };
    for (const auto& [list, aovs, missing] :
         {Case{"", 0, nullptr}, Case{"dd.y:depth", aov_depth, nullptr},
          Case{"nn:sh_normal, position:position,depth.y : depth ,", aov_normals | aov_positions | aov_depth,
               nullptr},
          Case{"a:shape_index,b:shape_index", aov_instances, nullptr},
          Case{"a:uv,b:depth,c:albedo,d:uv", aov_depth, "not made: albedo, uv;"}}) {
        CAPTURE(list);
        const SceneDescription s = described(list);
        CHECK(s.integrator.aovs == aovs);
        REQUIRE(s.notices.size() == (missing ? 2 : 1));
        CHECK(s.notices[0].ends_with(": not followed: integrator \"direct\"."));
        if (missing) CHECK(s.notices[1].find(missing) != std::string::npos);
    }
    for (const char* const bad : {"depth", "a:depths", ":", "a:depth,,b:uv"})
        refused("<integrator type='aov'>\n<string name='aovs' value='" + std::string(bad) +
                    "'/></integrator>" + a_sensor + a_shape,
                invalid, 3, {"aovs", "name:type", "sh_normal"});
    const SceneDescription depth = read("<integrator type='depth'/>" + a_sensor + a_shape);
    CHECK(depth.integrator.aovs == aov_depth);
}

TEST_CASE("a roughness that differs by direction is read as it is; isotropic materials take the mean") {
    const auto shape = [](const std::string& type, const std::string& alpha) {
        // The material stands alone and is referred to by two shapes.
        return read(
            "<bsdf type='normalmap' id='b'><texture name='n' type='rawconstant'><float name='value' "
            "value='1'/></texture>\n<bsdf type='" +
            type + "'>" + alpha + "</bsdf></bsdf>" + a_sensor + "<shape type='sphere'><ref id='b'/></shape>" +
            "<shape type='cube'><ref id='b'/></shape>");
    };
    const auto checkerboard = [](const std::string& name, const std::string& colors) {
        return "<texture name='" + name +
               "' type='checkerboard'><transform name='to_uv'><scale x='3' y='2'/>" + "</transform>" +
               colors + "</texture>";
    };
    const std::string differ = "<float name='alpha_u' value='0.25'/><float name='alpha_v' value='0.04'/>";
    const std::string boards =
        checkerboard("alpha_u", "<float name='color0' value='0.01'/><float name='color1' value='0.5'/>") +
        checkerboard("alpha_v", "<float name='color0' value='0.25'/><float name='color1' value='0.5'/>");
    const SceneDescription numbers = shape("roughconductor", differ);
    CHECK(numbers.notices.empty());
    const auto alphas = [](const SceneDescription& s) {
        const auto model = as<MetalModel>(as<NormalMapModel>(s.materials[0]).base);
        return std::pair(number(model, &P::alpha), number(model, &P::alpha_v));
    };
    CHECK(alphas(numbers).first.value == 0.25);
    CHECK(alphas(numbers).second.value == 0.04);
    const SceneDescription textures = shape("roughconductor", boards);
    const auto [board, board_v] = alphas(textures);
    REQUIRE(board.texture);
    REQUIRE(board_v.texture);
    CHECK(board.texture->color0.rgb.x == doctest::Approx(0.01));
    CHECK(board_v.texture->color0.rgb.x == doctest::Approx(0.25));
    const SceneDescription mixed =
        shape("roughconductor", checkerboard("alpha_u", "") + "<float name='alpha_v' value='0.04'/>");
    CHECK(alphas(mixed).second.value == 0.04);
    const SceneDescription same =
        shape("roughconductor", checkerboard("alpha_u", "") + checkerboard("alpha_v", ""));
    CHECK_FALSE(alphas(same).second.texture);
    const auto polarizing =
        as<PplasticModel>(as<NormalMapModel>(shape("pplastic", differ).materials[0]).base);
    CHECK(number(polarizing, &PplasticParameters::alpha).value == 0.25);
    CHECK(number(polarizing, &PplasticParameters::alpha_v).value == 0.04);

    const SceneDescription plastic = shape("roughplastic", differ);
    REQUIRE(!plastic.notices.empty());
    CHECK(plastic.notices[0].find("xml:3: alpha_u and alpha_v differ: roughplastic takes") !=
          std::string::npos);
    const auto alpha = [](const SceneDescription& s) {
        return number(as<PlasticModel>(as<NormalMapModel>(s.materials[0]).base), &PlasticParameters::alpha);
    };
    CHECK(alpha(plastic).value == doctest::Approx(0.1));
    const SceneDescription plastic_board = shape("roughplastic", boards);
    const TextureSpecificationPtr mean = alpha(plastic_board).texture;
    REQUIRE(mean);
    CHECK(mean->kind == TextureSpecification::Kind::checkerboard);
    CHECK(mean->color0.rgb.x == doctest::Approx(0.05));
    CHECK(mean->color1.rgb.x == doctest::Approx(0.5));
    CHECK(mean->sampling.to_uv[0][0] == doctest::Approx(3));
    refused("<bsdf type='roughplastic'>" + checkerboard("alpha_u", "") +
                "\n<texture name='alpha_v' type='checkerboard'/></bsdf>",
            unsupported, 3, {"\"alpha_v\" differs", "isotropic"});
    const std::string table = "<spectrum name='color0' value='400:0.1, 700:0.2'/>";
    refused("<bsdf type='roughplastic'>" + checkerboard("alpha_u", "") + "\n" +
                checkerboard("alpha_v", table) + "</bsdf>",
            unsupported, 3, {"\"alpha_v\" differs"});
}

TEST_CASE("a lookat without up takes Mitsuba's") {
    const auto look = [](const std::string& up, const std::string& target) {
        return transform("<lookat origin='0,0,0' target='" + target + "'" + up + "/>");
    };
    for (const char* up : {"", " up='0,0,0'"}) {
        // For both straight ahead and straight back, mitsuba.coordinate_system gives x first.
        CHECK(look(up, "0,0,2")[1] == glm::dvec4(1, 0, 0, 0));
        CHECK(look(up, "0,0,-2")[1] == glm::dvec4(1, 0, 0, 0));
        const glm::dmat4 m = look(up, "1,2,2");
        // With n = (1, 2, 2) / 3, s = (1 - nx^2 / (1 + nz), -nx ny / (1 + nz), -nx).
        CHECK(glm::distance(glm::dvec3(m[1]), glm::dvec3(14.0 / 15.0, -2.0 / 15.0, -1.0 / 3.0)) < 1e-12);
        const glm::dmat4 back = look(up, "1,2,-2");
        CHECK(glm::distance(glm::dvec3(back[1]), glm::dvec3(14.0 / 15.0, -2.0 / 15.0, 1.0 / 3.0)) < 1e-12);
    }
}

TEST_CASE("a dollar that is no parameter is written \\$") {
    const SceneDescription s =
        read("<default name='a' value='x'/>" + a_sensor + an_emitter +
             "<shape type='obj'><string name='filename' value='/c\\$a/$a/m$a.obj'/></shape>");
    CHECK(s.shapes.at(0).filename == "/c$a/x/mx.obj");
}
