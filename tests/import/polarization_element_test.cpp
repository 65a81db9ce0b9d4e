// SPDX-License-Identifier: MIT
// Tests of polarization elements in front of lamps and the camera: the resulting Stokes vectors, the elements
// of the scene, and refusals.
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "import/elements.hpp"
#include "import/load_scene.hpp"
#include "import/png_file.hpp"

using namespace nicol;

namespace {

constexpr auto unsupported = ErrorCode::unsupported;

/// Returns a square of half side 0.5 in the plane z = 0 that emits along z.
std::string lamp(const std::string& emitter = "", const std::string& operations = "",
                 const std::string& type = "rectangle", const std::string& more = "") {
    return "<shape type='" + type + "'>" + more + "<emitter type='area'>" + emitter + "</emitter>" +
           to_world("<scale value='0.5'/>" + operations) + "</shape>";
}

/// Returns the Stokes vector of the light straight from the first shape, a lamp of radiance 1, in the frame
/// of the world's x and z.
Stokes light_of(const SceneDescription& scene) {
    const ShapeDescription& shape = scene.shapes.at(0);
    REQUIRE(shape.emission);
    const PolarizationState& state = shape.emission->state;
    check(state);
    return shape.emission->scale *
           stokes_in(Frame(1.0), state, glm::normalize(glm::dmat3(shape.to_world) * state.axis));
}

Stokes light_behind(const std::string& elements, const std::string& its_lamp = lamp()) {
    const SceneDescription scene = read(a_sensor + its_lamp + elements);
    CHECK(scene.shapes.size() == 1);
    return light_of(scene);
}

/// Checks that the second line after the lamp's is refused.
void check_element_refused(const std::string& its_lamp, const std::string& elements,
                           const std::vector<std::string>& parts, ErrorCode code = unsupported) {
    const SceneFile file(scene(a_sensor + its_lamp + "\n" + elements));
    CAPTURE(elements);
    check_refused(file, code, file.scene().string() + ":4: ", parts);
}

}  // namespace

TEST_CASE("elements make of a lamp's light what Mitsuba makes of it") {
    // The values are those of Mitsuba 3.9.1, scalar_spectral_polarized, stokes, to 3 digits. The camera looks
    // along -z with y up.
    const struct {
        std::string elements;
        double s0;
        glm::dvec3 rest;  ///< divided by s0
    } rows[] = {
        {element(polarizer(0), 0.02), 0.5, {1, 0, 0}},
        {element(polarizer(30), 0.02), 0.5, {0.5, -0.866, 0}},
        {element(polarizer(0), 0.02, "<rotate z='1' angle='30'/>"), 0.5, {0.5, 0.866, 0}},
        {element(polarizer(30), 0.02, backwards), 0.5, {0.5, 0.866, 0}},
        {element(polarizer(30), 0.02, "<rotate x='1' angle='180'/>"), 0.5, {0.5, 0.866, 0}},
        {element(polarizer(30), 0.02, "", flipped), 0.5, {0.5, 0.866, 0}},
        {element(polarizer(30), 0.02, backwards, flipped), 0.5, {0.5, -0.866, 0}},
        {element(polarizer(30), 0.02, "<scale x='-1'/>"), 0.5, {0.5, -0.866, 0}},
        {element(polarizer(30), 0.02, "<scale x='-1'/>", flipped), 0.5, {0.5, 0.866, 0}},
        {element(polarizer(30), 0.02, "<scale z='-1'/>"), 0.5, {0.5, 0.866, 0}},
        {element(polarizer(30), 0.02, "<scale x='3'/>"), 0.5, {0.5, -0.866, 0}},
        {element(polarizer(30), 0.02, "<matrix value='1 0 0 0 0.5 1 0 0 0 0 1 0 0 0 0 1'/>"),
         0.5,
         {0.993, -0.120, 0}},
        {element(polarizer(0, "<spectrum name='transmittance' value='0.5'/>"), 0.02), 0.25, {1, 0, 0}},
        {element(polarizer(0), 0.02) + element(retarder(45, 90), 0.03), 0.5, {0, 0, 1}},
        {element(polarizer(0), 0.02) + element(retarder(45, 90), 0.03, backwards), 0.5, {0, 0, -1}},
        {element(polarizer(0), 0.02) + element(retarder(20, 60), 0.03), 0.5, {0.793, 0.246, 0.557}},
        {element(polarizer(0), 0.02) + element(retarder(20, 60), 0.03, "", flipped),
         0.5,
         {0.793, -0.246, -0.557}},
        {element(polarizer(15), 0.02) + element(retarder(40, 60), 0.03), 0.5, {0.403, -0.418, 0.814}},
        {element(retarder(-20, 100), 0.03) + element(retarder(30, 50), 0.02) + element(polarizer(10), 0.01),
         0.5,
         {0.901, 0.150, -0.408}},
        {element(right, 0.02), 0.5, {0, 0, 1}},
        {element(right, 0.02, backwards), 0.5, {0, 0, 1}},
        {element(left, 0.02), 0.5, {0, 0, -1}},
        {element(right, 0.01) + element(retarder(20, 60), 0.02), 0.5, {-0.557, 0.663, 0.5}},
        {element(right, 0.01) + element(polarizer(10), 0.02), 0.25, {0.940, -0.342, 0}},
        {element(polarizer(10), 0.01) + element(polarizer(40), 0.02), 0.375, {0.174, -0.985, 0}},
        {element(retarder(20, 60), 0.02), 1, {0, 0, 0}},
    };
    for (const auto& row : rows) {
        CAPTURE(row.elements);
        check_near(light_behind(row.elements), row.s0 * Stokes(1, row.rest.x, row.rest.y, row.rest.z),
                   1.2e-3);
    }
}

TEST_CASE("a retarder behind a polarizer, by hand") {
    for (const double theta : {-70.0, 0.0, 15.0, 120.0})
        for (const double fast : {-30.0, 0.0, 45.0, 100.0})
            for (const double delta : {-90.0, 0.0, 37.0, 90.0, 180.0}) {
                // The basis is along and across the fast axis, seen against the light, with E-vectors at
                // -theta and at fast.
                const double to_fast = glm::radians(-theta - fast);
                const double phase = glm::radians(delta);
                const Stokes in_retarder(1, std::cos(2 * to_fast), std::sin(2 * to_fast) * std::cos(phase),
                                         -std::sin(2 * to_fast) * std::sin(phase));
                check_near(
                    light_behind(element(polarizer(theta), 0.01) + element(retarder(fast, delta), 0.02)),
                    0.5 * rotated(in_retarder, -glm::radians(fast)), 1e-9);
            }
}

TEST_CASE("nothing changes with the axes, the shape and the place of the lamp") {
    const std::string elements = element(polarizer(30), 0.02) + element(retarder(10, 70), 0.03);
    const Stokes expected = light_behind(elements);
    for (const std::string& other :
         {lamp("", "<rotate z='1' angle='77'/>"), lamp("", "<scale x='0.9' y='1.3'/>"),
          lamp("", "<rotate z='1' angle='20'/><scale x='0.8'/>"), lamp("", "<scale x='-1'/>"),
          lamp("", backwards, "rectangle", flipped), lamp("", "", "disk"), lamp("", "<scale value='2'/>"),
          lamp("", "<translate x='0.5' y='-0.5'/>"), lamp("", "<rotate x='1' angle='0.09'/>")}) {
        CAPTURE(other);
        check_near(light_behind(elements, other), expected, 1e-5);
    }
    // The whole scene is rotated and moved.
    const std::string turn = "<rotate x='1' y='2' z='-1' angle='50'/><translate x='3' y='1' z='2'/>";
    const SceneDescription turned =
        read(a_sensor + lamp("", turn) + "<shape type='rectangle'>" + polarizer(30) +
             to_world("<translate z='0.02'/>" + turn) + "</shape>");
    const ShapeDescription& shape = turned.shapes.at(0);
    const glm::dvec3 axis = glm::dmat3(shape.to_world) * shape.emission->state.axis;
    const glm::dvec3 absorbing(0.5, std::sqrt(0.75), 0);
    CHECK(std::abs(glm::dot(glm::normalize(axis), glm::dmat3(transform(turn)) * absorbing)) ==
          doctest::Approx(1));
}

TEST_CASE("a polarizer's axis absorbs in each direction of light") {
    const SceneDescription scene = read(a_sensor + lamp() + element(polarizer(30), 0.02));
    const PolarizationState& state = scene.shapes.at(0).emission->state;
    CHECK(state.dolp == doctest::Approx(1));
    CHECK(state.docp == 0);
    CHECK(state.aolp == pi / 2);
    CHECK(std::abs(glm::dot(state.axis, glm::dvec3(0.5, std::sqrt(0.75), 0))) == doctest::Approx(1));
}

TEST_CASE("light that is polarized already passes by Malus' law") {
    const std::string polarized = number("dolp", 0.8) + number("aolp", 20);
    for (const double angle : {0.0, 20.0, 65.0, 110.0}) {
        const double s0 = 0.5 * (1 + 0.8 * std::cos(2 * glm::radians(angle - 20)));
        CHECK(light_behind(element(polarizer(-angle), 0.02), lamp(polarized))[0] == doctest::Approx(s0));
    }
    check_near(light_behind(element(polarizer(0), 0.01) + element(polarizer(90), 0.02)), Stokes(0), 1e-9);
}

TEST_CASE("elements are gone from the scene, and lamps are darker by them") {
    const std::string grey = "<float name='radiance' value='8'/>";
    const std::string textured = "<texture type='checkerboard' name='radiance'/>";
    const auto loaded = [](const std::string& emitter) {
        const SceneFile file(scene(a_sensor + a_shape + lamp(emitter) + element(right, 0.02)));
        return load_scene(file.scene(), {}).scene;
    };
    CHECK(loaded(grey).instances().size() == 2);
    CHECK(loaded(grey).at(1).emission->radiance[0] == doctest::Approx(4));
    CHECK(loaded(grey).at(1).emission->state.docp == doctest::Approx(1));
    CHECK(loaded(textured).at(1).emission->radiance == std::vector<double>{0.5});
    CHECK_FALSE(loaded(grey).at(0).emission);
}

TEST_CASE("an element may cover several lamps, be referred to and lie before an instance") {
    const std::string sheet = "<bsdf type='polarizer' id='sheet'/>";
    const std::string two = lamp("", "<scale value='0.9'/><translate x='-0.5'/>") +
                            lamp("", "<scale value='0.9'/><translate x='0.5'/>") +
                            lamp("", "<translate z='-3'/>");
    const SceneDescription scene = read(a_sensor + sheet + two + element("<ref id='sheet'/>", 0.02));
    CHECK(scene.shapes[0].emission->state.polarized());
    CHECK(scene.shapes[1].emission->state.polarized());
    CHECK_FALSE(scene.shapes[2].emission->state.polarized());
    CHECK(scene.shapes[2].emission->scale == 1);
    const std::string group = "<shape type='shapegroup' id='group'>" + lamp() + "</shape>";
    check_near(
        light_behind(element(polarizer(0), 0.02), group + "<shape type='instance'><ref id='group'/></shape>"),
        Stokes(0.5, 0.5, 0, 0), 1e-9);
}

TEST_CASE("what covers a lamp") {
    const auto covers = [](const std::string& type, double scale, double x, const std::string& its_lamp) {
        const std::string cover = "<shape type='" + type + "'>" + right +
                                  to_world("<scale value='" + std::to_string(scale) + "'/><translate x='" +
                                           std::to_string(x) + "' z='0.02'/>") +
                                  "</shape>";
        const SceneFile file(scene(a_sensor + its_lamp + cover));
        const SceneDescription covered = read_mitsuba_scene(file.scene());
        const bool before = covered.shapes.at(0).emission->state.docp > 0.999;
        CHECK(covered.elements.size() == (before ? 0 : 1));
        return before;
    };
    CHECK(covers("rectangle", 0.5, 0, lamp()));
    CHECK_FALSE(covers("rectangle", 0.499, 0, lamp()));
    CHECK(covers("rectangle", 0.6, 0.099, lamp()));
    CHECK_FALSE(covers("rectangle", 0.6, 0.101, lamp()));
    CHECK_FALSE(covers("disk", 0.7, 0, lamp()));
    CHECK(covers("disk", 0.708, 0, lamp()));
    CHECK(covers("disk", 0.5, 0, lamp("", "", "disk")));
    CHECK_FALSE(covers("disk", 0.5, 0.01, lamp("", "", "disk")));
    CHECK(covers("rectangle", 0.5, 0, lamp("", "", "disk")));
    CHECK_FALSE(covers("rectangle", 0.5, 0, lamp("", "<rotate z='1' angle='5'/>")));
}

TEST_CASE("elements that stand before no lamp stand before the camera") {
    const std::string p = element(polarizer(0), 0.02);
    const struct {
        std::string its_lamp, elements;
    } rows[] = {{lamp(), element(polarizer(0), 0.051)},
                {lamp(), element(polarizer(0), -0.02)},
                {lamp(), element(polarizer(0), 0)},
                {lamp(), element(polarizer(0), 0.02, "<rotate x='1' angle='0.11'/>")},
                {lamp(), element(polarizer(0), 0.02, "<scale value='0.49'/>")},
                {lamp(), element(polarizer(0), 0.02, "<translate x='0.51'/>")},
                {lamp("", backwards), p},
                {lamp("", "", "rectangle", flipped), p},
                {lamp("", "<scale x='0.3'/>"), p},
                {lamp("<boolean name='two_sided' value='true'/>"), p},
                {lamp("", "", "cube"), p},
                {a_shape, p},
                {"", p},
                // The nearer element belongs to the lamp, and the distant one stays.
                {lamp(), element(right, 0.02) + element(polarizer(0), 1)}};
    for (const auto& row : rows) {
        CAPTURE(row.its_lamp);
        CAPTURE(row.elements);
        const SceneDescription scene = read(a_sensor + row.its_lamp + row.elements);
        CHECK(scene.shapes.size() == (row.its_lamp.empty() ? 0 : 1));
        REQUIRE(scene.elements.size() == 1);
        CHECK(scene.elements[0].kind == PolarizationElement::Kind::polarizer);
    }
}

TEST_CASE("elements before the camera are what elements before lamps are") {
    for (const std::string& more : {std::string(), flipped})
        for (const std::string& operations : {std::string(), backwards, std::string("<scale x='-1' y='2'/>")})
            for (const std::string& bsdf : {polarizer(30), polarizer(-70), right, left}) {
                CAPTURE(bsdf);
                CAPTURE(operations);
                const std::string before_lamp = element(bsdf, 0.02, operations, more);
                const SceneDescription scene =
                    read(a_sensor + a_shape + element(bsdf, 0.02, operations, more));
                REQUIRE(scene.elements.size() == 1);
                check_near(PlacedElement(scene.elements[0]).mueller(Frame(1.0)) * Stokes(1, 0, 0, 0),
                           light_behind(before_lamp), 1e-12);
            }
    const PolarizationElement retarding =
        read(a_sensor + a_shape + element(retarder(20, 60), 3)).elements.at(0);
    CHECK(retarding.kind == PolarizationElement::Kind::retarder);
    CHECK(retarding.outline == PolarizationElement::Outline::rectangle);
    CHECK(retarding.angle == doctest::Approx(glm::radians(20.0)));
    CHECK(retarding.retardance == doctest::Approx(glm::radians(60.0)));
    CHECK(retarding.to_world[3] == glm::dvec4(0, 0, 3, 1));
    const PolarizationElement round =
        read(a_sensor + a_shape + "<shape type='disk'>" + left + "</shape>").elements.at(0);
    CHECK(round.kind == PolarizationElement::Kind::left_circular);
    CHECK(round.outline == PolarizationElement::Outline::disk);
}

TEST_CASE("one notice says what elements do not do, and the scene has them") {
    const SceneFile file(
        scene(a_sensor + a_shape + element(right, 2) + element(polarizer(0), 3) + an_emitter));
    const LoadedScene loaded = load_scene(file.scene(), {});
    REQUIRE(loaded.scene.elements().size() == 2);
    CHECK(loaded.scene.elements()[1].to_world[3].z == 3);
    REQUIRE(loaded.notices.size() == 1);
    CHECK(loaded.notices[0].find(file.scene().string() + ":4: ") == 0);
    CHECK(loaded.notices[0].find("no shadow") != std::string::npos);
    CHECK(read(a_sensor + lamp() + element(right, 0.02)).notices.empty());
}

TEST_CASE("groups have elements, which instances place") {
    const std::string group = "<shape type='shapegroup' id='group'>" + a_shape + element(polarizer(0), 1) +
                              "</shape><shape type='instance'><ref id='group'/>" +
                              to_world("<translate x='5'/>") + "</shape>";
    const SceneDescription scene =
        read(a_sensor + group + "<shape type='instance'><ref id='group'/></shape>");
    CHECK(scene.shapes.size() == 2);
    REQUIRE(scene.elements.size() == 2);
    CHECK(scene.elements[0].to_world[3] == glm::dvec4(5, 0, 1, 1));
    CHECK(scene.elements[1].to_world[3] == glm::dvec4(0, 0, 1, 1));
}

TEST_CASE("angles are numbers in any form that has one value") {
    for (const char* tag : {"float", "spectrum", "rgb"}) {
        CAPTURE(tag);
        const auto given = [&](const char* name, const char* value) {
            return "<" + std::string(tag) + " name='" + name + "' value='" + value + "'/>";
        };
        const PolarizationElement p =
            read(a_sensor + a_shape +
                 element("<bsdf type='retarder'>" + given("theta", "-30") + given("delta", "45") + "</bsdf>",
                         1))
                .elements.at(0);
        CHECK(p.angle == doctest::Approx(glm::radians(-30.0)));
        CHECK(p.retardance == doctest::Approx(glm::radians(45.0)));
    }
}

TEST_CASE("angles and retardances are textures of degrees, which Mitsuba's parameters mean") {
    const auto board = [](const char* name, double first, double second) {
        return "<texture name='" + std::string(name) + "' type='checkerboard'>" + number("color0", first) +
               number("color1", second) + "</texture>";
    };
    const SceneFile file(scene(
        a_sensor + a_shape +
        element("<bsdf type='retarder'>" + board("theta", 30, 140) + board("delta", 90, 450) + "</bsdf>", 2) +
        element("<bsdf type='polarizer'>" + board("theta", 10, 20) + "</bsdf>", 3, "", flipped)));
    const Scene loaded = load_scene(file.scene(), {}).scene;
    REQUIRE(loaded.elements().size() == 2);
    const auto at = [](const TexturePtr& texture, float u) {
        REQUIRE(texture != nullptr);
        return static_cast<double>(texture->at({.uv = {u, 0.1F}}).x);
    };
    const SceneElement& sheet = loaded.elements()[0];
    CHECK(sheet.angle * at(sheet.textures.angle, 0.1F) == doctest::Approx(glm::radians(30.0)));
    CHECK(sheet.angle * at(sheet.textures.angle, 0.6F) == doctest::Approx(glm::radians(140.0)));
    CHECK(sheet.retardance * at(sheet.textures.retardance, 0.1F) == doctest::Approx(glm::radians(90.0)));
    CHECK(sheet.retardance * at(sheet.textures.retardance, 0.6F) == doctest::Approx(glm::radians(450.0)));
    // Mitsuba turns polarizers clockwise, and flipping normals turns them back.
    const SceneElement& analyser = loaded.elements()[1];
    CHECK(analyser.angle * at(analyser.textures.angle, 0.6F) == doctest::Approx(glm::radians(20.0)));
    CHECK(analyser.textures.retardance == nullptr);
}

TEST_CASE("colours of a texture are retardances of red, green and blue, and one angle with a notice") {
    const auto board = [](const char* name) {
        return "<texture name='" + std::string(name) +
               "' type='checkerboard'><rgb name='color0' value='10 20 30'/>" + number("color1", 40) +
               "</texture>";
    };
    const auto loaded = [&](const std::string& bsdf) {
        return load_scene(SceneFile(scene(a_sensor + a_shape + element(bsdf, 2))).scene(), {});
    };
    const LoadedScene sheet = loaded("<bsdf type='retarder'>" + board("delta") + "</bsdf>");
    CHECK(sheet.scene.elements().at(0).channels() == 3);
    CHECK(sheet.notices.empty());
    const SceneElement& element = sheet.scene.elements().at(0);
    const auto at = [](const TexturePtr& texture, float u) { return texture->at({.uv = {u, 0.1F}}); };
    CHECK(at(element.textures.retardance, 0.1F) == glm::vec4(10, 20, 30, 1));
    CHECK(at(element.textures.retardance, 0.6F) == glm::vec4(40, 40, 40, 1));
    const LoadedScene axes = loaded("<bsdf type='retarder'>" + board("theta") + "</bsdf>");
    CHECK(axes.scene.elements().at(0).channels() == 1);
    REQUIRE(axes.notices.size() == 1);
    CHECK(axes.notices[0].find("theta has colours") != std::string::npos);
    const double luminance = 0.2126 * 10 + 0.7152 * 20 + 0.0722 * 30;
    CHECK(static_cast<double>(at(axes.scene.elements().at(0).textures.angle, 0.1F).x) ==
          doctest::Approx(luminance));

    const SceneFile file("");
    file.write("a.png", png_bytes(1, 1, 3, {51, 102, 153}));
    const auto map = [&](const char* name) {
        return "<texture type='bitmap' name='" + std::string(name) + "'><string name='filename' value='" +
               (file / "a.png").string() + "'/><boolean name='raw' value='true'/></texture>";
    };
    const LoadedScene both = loaded("<bsdf type='retarder'>" + map("theta") + map("delta") + "</bsdf>");
    const SceneElement& of_image = both.scene.elements().at(0);
    const glm::vec4 retardance = at(of_image.textures.retardance, 0.5F);
    CHECK(glm::distance(retardance, glm::vec4(0.2F, 0.4F, 0.6F, 1)) < 1e-6F);
    CHECK(of_image.textures.angle->channels() == 1);
    REQUIRE(both.notices.size() == 1);
    CHECK(both.notices[0].find("theta has colours") != std::string::npos);
}

TEST_CASE("an element with textures, and what light meets after it, stands before the camera") {
    const std::string sheet = "<bsdf type='retarder'><texture name='delta' type='checkerboard'/></bsdf>";
    const SceneDescription scene = read(a_sensor + lamp() + element(polarizer(0), 0.01) +
                                        element(sheet, 0.02) + element(polarizer(90), 0.03));
    CHECK(scene.shapes.at(0).emission->state.dolp == doctest::Approx(1));
    CHECK(scene.shapes.at(0).emission->scale == doctest::Approx(0.5));
    REQUIRE(scene.elements.size() == 2);
    CHECK(scene.elements[0].textured());
    CHECK(scene.elements[1].kind == PolarizationElement::Kind::polarizer);
    // Nothing changes the lamp if the light meets the sheet first.
    const SceneDescription alone =
        read(a_sensor + lamp() + element(sheet, 0.01) + element(polarizer(0), 0.02));
    CHECK(alone.shapes.at(0).emission->scale == 1);
    CHECK(alone.elements.size() == 2);
}

TEST_CASE("elements that cannot be are refused by name") {
    const auto bad = [](const std::string& bsdf, const std::vector<std::string>& parts,
                        ErrorCode code = unsupported) {
        check_element_refused(lamp(), element(bsdf, 0.02), parts, code);
    };
    const auto invalid = ErrorCode::invalid_file;
    bad(polarizer(0, "<boolean name='polarizing' value='false'/>"), {"\"polarizing\" is false", "true"});
    bad(polarizer(0, "<rgb name='transmittance' value='1 0.5 1'/>"), {"\"transmittance\" is coloured"});
    bad(polarizer(0, "<spectrum name='transmittance' value='400:1, 700:0.5'/>"), {"is coloured"});
    bad(polarizer(0, "<float name='transmittance' value='1.1'/>"), {"\"transmittance\"", "0 to 1"}, invalid);
    const std::string of_mesh = "type='mesh_attribute'><string name='name' value='vertex_color'/></texture>";
    bad("<bsdf type='polarizer'><texture name='theta' " + of_mesh + "</bsdf>",
        {"\"theta\" has colours of a mesh; expected an image"});
    bad("<bsdf type='retarder'><texture name='delta' " + of_mesh + "</bsdf>", {"\"delta\" has colours"});
    bad("<bsdf type='circular'><texture name='transmittance' type='checkerboard'/></bsdf>",
        {"\"transmittance\" is a texture"});
    bad("<bsdf type='polarizer'><rgb name='theta' value='10 20 30'/></bsdf>",
        {"\"theta\" is coloured; expected one value"});
    bad("<bsdf type='retarder'><spectrum name='delta' value='400:10, 700:20'/></bsdf>",
        {"\"delta\" is coloured"});
    bad("<bsdf type='retarder'><float name='delta' value='inf'/></bsdf>", {"\"delta\"", "finite"}, invalid);
    bad("<bsdf type='circular'><float name='theta' value='1'/></bsdf>",
        {"\"theta\" is unknown", "left_handed, transmittance"}, invalid);
    bad("<bsdf type='polarizer'><bsdf type='diffuse'/></bsdf>", {"<bsdf> inside"});
    for (const char* type : {"polarizer", "retarder"})
        check_element_refused(lamp(), "<shape type='disk'><bsdf type='" + std::string(type) + "'/></shape>",
                              {type, "on a disk", "expected a rectangle"});
    for (const std::string& elsewhere :
         {"<shape type='sphere'>" + right + "</shape>",
          "<shape type='rectangle'>" + right + "<emitter type='area'/></shape>",
          "<bsdf type='twosided'>" + right + "</bsdf>"})
        check_element_refused(lamp(), elsewhere, {"bsdf \"circular\" is not supported", "emits no light"});
    // A bsdf is refused even if no shape refers to it.
    check_element_refused(lamp(), "<bsdf type='retarder'><float name='thetta' value='1'/></bsdf>",
                          {"\"thetta\" is unknown"}, invalid);
}

TEST_CASE("more elements than a scene may have") {
    std::string elements;
    for (int i = 0; i < 1001; ++i) elements += "<shape type='rectangle'><bsdf type='circular'/></shape>";
    check_element_refused(lamp(), elements, {"more than 1000 polarization elements"});
}
