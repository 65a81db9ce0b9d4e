// SPDX-License-Identifier: MIT
// Tests of <emitter>s beside the environment: results and refusals.
#include <glm/trigonometric.hpp>

#include "import/described_material.hpp"
#include "import/load_scene.hpp"
#include "import/png_file.hpp"
#include "import/scene_file.hpp"

using namespace nicol;

namespace {

constexpr auto invalid = ErrorCode::invalid_file;
constexpr auto unsupported = ErrorCode::unsupported;
using Kind = LocalLight::Kind;

LoadedScene load(const std::string& content) {
    return load_scene(SceneFile(::scene(a_sensor + content)).scene(), {});
}

LocalLight light(const std::string& type, const std::string& inside = "") {
    const LoadedScene loaded = load(a_shape + "<emitter type='" + type + "'>" + inside + "</emitter>");
    REQUIRE(loaded.scene.lights().size() == 1);
    CHECK(loaded.notices.empty());
    CHECK_FALSE(loaded.scene.environment());
    return loaded.scene.lights()[0];
}

Instance shining(const std::string& inside, const std::string& rest = "") {
    return load("<shape type='rectangle'><emitter type='area'>" + inside + "</emitter>" + rest + "</shape>")
        .scene.at(0);
}

/// Returns the unit vector along which a light emits, in world space.
glm::dvec3 along(const LocalLight& light) {
    return glm::dvec3(light.to_world[2]);
}
glm::dvec3 axis(const LocalLight& light) {
    return glm::dmat3(light.to_world) * light.state.axis;
}

void check_near(const glm::dvec3& a, const glm::dvec3& b) {
    CAPTURE(a.x);
    CAPTURE(a.y);
    CAPTURE(a.z);
    CHECK(glm::distance(a, b) < 1e-9);
}

/// Checks that reading fails with every part. The emitter begins on line 4.
void refused(const std::string& content, ErrorCode code, int line, const std::vector<std::string>& parts) {
    const SceneFile file(::scene(a_sensor + a_shape + content));
    CAPTURE(content);
    check_refused(file, code, file.scene().string() + ":" + std::to_string(line) + ": ", parts);
}

void bad_light(const std::string& type, const std::string& inside, const std::vector<std::string>& parts) {
    refused("<emitter type='" + type + "'>\n" + inside + "</emitter>", invalid, 5, parts);
}

const std::string moved =
    "<transform name='to_world'><rotate y='1' angle='90'/><scale value='3'/>"
    "<translate x='1' y='2' z='3'/></transform>";

}  // namespace

TEST_CASE("lights without parameters are Mitsuba's") {
    const LocalLight point = light("point");
    CHECK(point.kind == Kind::point);
    CHECK(point.value == std::vector<double>{1, 1, 1});
    CHECK(point.to_world == glm::dmat4(1.0));
    CHECK_FALSE(point.state.polarized());
    const LocalLight sun = light("directional");
    CHECK(sun.kind == Kind::directional);
    CHECK(sun.value == std::vector<double>{1, 1, 1});
    CHECK(sun.angular_radius == 0);
    check_near(along(sun), {0, 0, 1});
    const LocalLight spot = light("spot");
    CHECK(spot.kind == Kind::spot);
    CHECK(glm::degrees(spot.cutoff_angle) == doctest::Approx(20));
    CHECK(glm::degrees(spot.beam_width) == doctest::Approx(15));
    CHECK(spot.texture == nullptr);
    // The default is a lens of 50 mm in front of 35 mm film, along its diagonal.
    const LocalLight projector = light("projector");
    CHECK(projector.kind == Kind::projector);
    CHECK(glm::degrees(projector.fov) == doctest::Approx(34.0221));
    CHECK(projector.aspect == 1);
    const Instance surface = shining("");
    REQUIRE(surface.emission);
    CHECK(surface.emission->radiance == std::vector<double>{1, 1, 1});
    CHECK_FALSE(surface.emission->two_sided);
    CHECK_FALSE(surface.emission->state.polarized());
}

TEST_CASE("lights are where their parameters place them, a scale without effect") {
    for (const char* type : {"point", "spot", "directional"}) {
        const LocalLight placed = light(type, moved);
        check_near(along(placed), {1, 0, 0});
        check_near(glm::dvec3(placed.to_world[3]), {1, 2, 3});
    }
    check_near(along(light("projector", moved + "<float name='fov' value='30'/>")), {1, 0, 0});
    check_near(glm::dvec3(light("point", "<point name='position' value='1 2 3'/>").to_world[3]), {1, 2, 3});
    for (const glm::dvec3 to : {glm::dvec3(0, -2, 0), glm::dvec3(3, 0, 4), glm::dvec3(0, 0, -1)}) {
        const std::string vector = "<vector name='direction' value='" + std::to_string(to.x) + " " +
                                   std::to_string(to.y) + " " + std::to_string(to.z) + "'/>";
        check_near(along(light("directional", vector)), glm::normalize(to));
    }
}

TEST_CASE("values of lights are those of Mitsuba without spectra") {
    // The values come from mitsuba.load_file of test_arealight_path.xml. Its sum over a thousand wavelengths
    // is 0.1 % off.
    const std::string table = "400:0, 500:8, 600:15.6, 700:18.4";
    struct Row {
        const char* type;
        const char* name;
    };
    for (const auto& [type, name] :
         {Row{"point", "intensity"}, Row{"spot", "intensity"}, Row{"directional", "irradiance"}}) {
        const auto value = [&, type = type, name = name](const std::string& tag, const std::string& text) {
            const std::vector<double> v =
                light(type, "<" + tag + " name='" + name + "' value='" + text + "'/>").value;
            return glm::dvec3(v.at(0), v.at(1), v.at(2));
        };
        CHECK(glm::distance(value("spectrum", table), {20.7108, 10.8546, 2.77115}) < 0.02);
        CHECK(value("rgb", "1, 2, 300") == glm::dvec3(1, 2, 300));
        CHECK(value("float", "2.5") == glm::dvec3(2.5));
    }
    const std::vector<double> v =
        shining("<spectrum name='radiance' value='" + table + "'/>").emission->radiance;
    CHECK(glm::distance(glm::dvec3(v.at(0), v.at(1), v.at(2)), {20.7108, 10.8546, 2.77115}) < 0.02);
    // A white surface has Mitsuba's `irradiance` as its radiance.
    const std::vector<double> projected =
        light("projector", "<rgb name='irradiance' value='1 2 4'/><float name='scale' value='3'/>").value;
    REQUIRE(projected.size() == 3);
    for (std::size_t c = 0; c < 3; ++c) CHECK(projected[c] == doctest::Approx(3 * pi * std::pow(2.0, c)));
}

TEST_CASE("angles are given in degrees") {
    CHECK(light("directional", "<float name='angular_radius' value='90'/>").angular_radius ==
          doctest::Approx(pi / 2));
    const LocalLight spot =
        light("spot", "<float name='cutoff_angle' value='60'/><float name='beam_width' value='60'/>");
    CHECK(spot.cutoff_angle == doctest::Approx(pi / 3));
    CHECK(spot.beam_width == spot.cutoff_angle);
    CHECK(light("spot", "<float name='cutoff_angle' value='40'/>").beam_width == doctest::Approx(pi / 6));
}

TEST_CASE("how light is polarized: in degrees, its axis in the axes that place the light") {
    const std::string state =
        "<float name='dolp' value='0.6'/><float name='aolp' value='45'/><float name='docp' value='-0.8'/>"
        "<vector name='polarization_axis' value='0 2 1'/>";
    for (const char* type : {"point", "spot", "directional", "projector"}) {
        const PolarizationState read = light(type, state).state;
        CHECK(read.dolp == 0.6);
        CHECK(read.aolp == doctest::Approx(pi / 4));
        CHECK(read.docp == -0.8);
        check_near(read.axis, {0, 2, 1});
    }
    CHECK(shining(state, moved).emission->state.axis == glm::dvec3(0, 2, 1));  // in the axes of the mesh
    check_near(axis(light("spot", state + moved)), {1, 2, 0});
    // Without a transform the axis is given in world space.
    check_near(axis(light("directional", state + "<vector name='direction' value='1 2 3'/>")), {0, 2, 1});
    check_near(axis(light("point", state + "<point name='position' value='1 2 3'/>")), {0, 2, 1});
}

TEST_CASE("textures of lights, whose image says what a projector's rectangle is") {
    const SceneFile file("");
    file.write("a.png", png_bytes(8, 4, 1, std::vector<std::uint8_t>(32, 255)));
    const std::string image = "type='bitmap'><string name='filename' value='" + (file / "a.png").string() +
                              "'/><boolean name='raw' value='true'/></texture>";
    const std::string irradiance = "<texture name='irradiance' " + image;
    const LocalLight wide = light("projector", irradiance + "<float name='fov' value='40'/>");
    REQUIRE(wide.texture);
    CHECK(wide.aspect == 2);
    CHECK(glm::degrees(wide.fov) == doctest::Approx(40));
    // Mitsuba reports these fields of view.
    CHECK(glm::degrees(light("projector", irradiance + "<float name='fov' value='40'/>"
                                                       "<string name='fov_axis' value='y'/>")
                           .fov) == doctest::Approx(72.1048));
    CHECK(glm::degrees(light("projector", irradiance).fov) == doctest::Approx(42.3117));
    CHECK(light("spot", "<texture name='texture' " + image).texture);
    CHECK(light("projector", "<texture name='irradiance' type='checkerboard'/>").aspect == 1);
    const Instance surface = shining("<texture name='radiance' " + image);
    REQUIRE(surface.emission->texture);
    CHECK(surface.emission->radiance == std::vector<double>{1});
}

TEST_CASE("any number of lights beside one environment, by reference and in included files too") {
    const SceneFile file(::scene(a_sensor + an_emitter + a_shape +
                                 "<emitter type='point' id='lamp'/><emitter type='spot'/>"
                                 "<shape type='cube'><emitter type='area'/></shape><ref id='lamp'/>"
                                 "<include filename='more.xml'/>"));
    file.write("more.xml", ::scene("<emitter type='directional'/>"));
    const LoadedScene loaded = load_scene(file.scene(), {});
    CHECK(loaded.scene.environment());
    CHECK(loaded.scene.lights().size() == 4);
    CHECK(loaded.scene.at(1).emission);
    CHECK_FALSE(loaded.scene.at(0).emission);
    refused(an_emitter + "<emitter type='point'/>\n" + an_emitter, unsupported, 6,
            {"a second emitter that surrounds the scene"});
}

TEST_CASE("an emissive shape is black where it names no bsdf") {
    const SceneDescription s =
        read(a_sensor + "<shape type='cube'><emitter type='area'/></shape>" + a_shape +
             "<shape type='disk'><emitter type='area'/></shape>"
             "<shape type='cylinder'><emitter type='area'/><bsdf type='diffuse'/></shape>");
    const auto reflectance = [&](std::size_t shape) {
        return as<DiffuseModel>(s.materials.at(s.shapes.at(shape).material)).reflectance.rgb.x;
    };
    CHECK(reflectance(0) == 0);
    CHECK(reflectance(1) == 0.5);
    CHECK(s.shapes[2].material == s.shapes[0].material);
    CHECK(reflectance(3) == 0.5);
}

TEST_CASE("an area with an id serves the shapes that refer to it, before and after it") {
    const std::string shape = "<shape type='rectangle'><ref id='glow'/></shape>";
    const std::string glow =
        "<emitter type='area' id='glow'><rgb name='radiance' value='3'/><float name='dolp' "
        "value='1'/></emitter>";
    const LoadedScene loaded = load(shape + glow + shape);
    REQUIRE(loaded.scene.instances().size() == 2);
    for (const Instance& instance : loaded.scene.instances()) {
        REQUIRE(instance.emission);
        CHECK(instance.emission->radiance.front() == 3);
        CHECK(instance.emission->state.dolp == 1);
    }
    CHECK_FALSE(load(glow + "<shape type='cube'/>").scene.has_local_lights());
    refused("<emitter type='area' id='glow'>\n<rgb name='radiance' value='-3'/></emitter>", invalid, 5,
            {"radiance"});
}

TEST_CASE("each instance of a group emits light as its member") {
    const LoadedScene loaded = load(
        "<shape type='shapegroup' id='g'><shape type='rectangle'><emitter type='area'>"
        "<float name='radiance' value='7'/></emitter></shape><shape type='cube'/></shape>"
        "<shape type='instance'><ref id='g'/></shape><shape type='instance'><ref id='g'/>" +
        moved + "</shape>");
    for (const std::uint32_t id : {0U, 2U}) {
        REQUIRE(loaded.scene.at(id).emission);
        CHECK(loaded.scene.at(id).emission->radiance[0] == 7);
    }
    for (const std::uint32_t id : {1U, 3U}) CHECK_FALSE(loaded.scene.at(id).emission);
}

TEST_CASE("discs and cylinders are shapes") {
    const LoadedScene loaded = load(
        "<shape type='disk'/><shape type='cylinder'/><shape type='cylinder'><point name='p0' value='1 2 3'/>"
        "<point name='p1' value='2 4 5'/><float name='radius' value='0.5'/></shape>"
        "<shape type='cylinder'><boolean name='flip_normals' value='true'/></shape><shape type='disk'/>");
    const auto mesh = [&](std::uint32_t id) { return loaded.scene.at(id).mesh; };
    CHECK(mesh(0)->positions == make_disk().positions);
    CHECK(mesh(1)->positions == make_cylinder({0, 0, 0}, {0, 0, 1}, 1).positions);
    CHECK(mesh(2)->positions == make_cylinder({0, 0, 0}, {1, 2, 2}, 0.5).positions);
    CHECK(glm::dvec3(loaded.scene.at(2).to_world[3]) == glm::dvec3(1, 2, 3));
    CHECK(mesh(3)->normals[0] == -mesh(1)->normals[0]);
    CHECK(mesh(4) == mesh(0));
    const auto bad = [](const std::string& inside, const std::vector<std::string>& parts) {
        refused("<shape type='cylinder'>\n" + inside + "</shape>", invalid, 5, parts);
    };
    bad("<float name='radius' value='0'/>", {"\"radius\" is 0"});
    bad("<point name='p1' value='0 0 0'/>", {"\"p1\" is p0"});
    bad("<point name='center' value='0 0 0'/>", {"\"center\" is unknown", "p0, p1, radius"});
}

TEST_CASE("lights that cannot be are refused, with the line and the parameter") {
    for (const char* type : {"point", "spot", "directional", "projector"}) {
        const std::string name =
            std::string(type) == "point" || std::string(type) == "spot" ? "intensity" : "irradiance";
        bad_light(type, "<float name='" + name + "' value='-1'/>", {name, "at least 0"});
        bad_light(type, "<rgb name='" + name + "' value='1 inf 1'/>", {name, "finite"});
        bad_light(type, "<float name='" + name + "' value='1e999'/>", {name, "finite"});
        bad_light(type, "<float name='power' value='1'/>", {"\"power\" is unknown", name});
        bad_light(type, "<float name='dolp' value='nan'/>", {"dolp", "finite"});
    }
    bad_light("point", "<point name='position' x='1'/><transform name='to_world'/>",
              {"\"to_world\" is given beside position"});
    bad_light("directional", "<vector name='direction' x='1'/><transform name='to_world'/>",
              {"\"to_world\" is given beside direction"});
    bad_light("directional", "<vector name='direction' value='0'/>", {"\"direction\" has no direction"});
    bad_light("directional", "<float name='angular_radius' value='91'/>",
              {"\"angular_radius\" is 91", "from 0 to 90"});
    bad_light("spot", "<float name='cutoff_angle' value='120'/>", {"\"cutoff_angle\" is 120", "0.01 to 90"});
    bad_light("spot", "<float name='beam_width' value='21'/>", {"\"beam_width\" is 21", "from 0 to 20"});
    bad_light("projector", "<float name='fov' value='180'/>", {"\"fov\" is 180"});
    bad_light("projector", "<float name='fov' value='20'/><string name='focal_length' value='50mm'/>",
              {"beside fov"});
    bad_light("projector", "<float name='scale' value='-1'/>", {"\"scale\" is -1"});
    refused("<emitter type='point'>\n<texture name='intensity' type='checkerboard'/></emitter>", unsupported,
            5, {"\"intensity\" is a texture"});
    // Faults of the state are reported at the line of the emitter.
    const auto bad_state = [](const std::string& inside, const std::vector<std::string>& parts) {
        refused("<emitter type='point'>" + inside + "</emitter>", invalid, 4, parts);
        refused("<shape type='cube'>\n<emitter type='area'>" + inside + "</emitter></shape>", invalid, 5,
                parts);
    };
    bad_state("<float name='dolp' value='1.1'/>", {"dolp is 1.1", "0 to 1"});
    bad_state("<float name='docp' value='-1.1'/>", {"docp is -1.1", "-1 to 1"});
    bad_state("<float name='dolp' value='0.8'/><float name='docp' value='0.8'/>",
              {"more polarized than light"});
    bad_state("<vector name='polarization_axis' value='0'/>", {"axis has no direction"});
}

TEST_CASE("emitters in the wrong place, and those that do not exist") {
    refused("<emitter type='area'/>", unsupported, 4, {"emitter \"area\"", "belongs into a <shape>"});
    refused("<emitter type='sunsky'/>", unsupported, 4,
            {"emitter \"sunsky\"", "envmap, constant, psh, sky, directional, ", ", projector"});
    const auto inside_shape = [](const std::string& inside, ErrorCode code,
                                 const std::vector<std::string>& parts) {
        refused("<shape type='cube'>\n" + inside + "</shape>", code, 5, parts);
    };
    inside_shape("<emitter type='point'/>", unsupported, {"emitter \"point\"", "area"});
    inside_shape("<emitter type='area'/><emitter type='area'/>", invalid, {"a second <emitter>"});
    refused("<shape type='shapegroup'>\n<emitter type='area'/></shape>", unsupported, 5,
            {"<emitter> inside shape \"shapegroup\"", "of type area, inside a <shape>"});
    // The scaled shape has no area.
    inside_shape("<emitter type='area'/><transform name='to_world'><scale x='0'/></transform>", invalid,
                 {"<transform> cannot be inverted"});
}

TEST_CASE("transforms of lights and their textures are checked when they are made") {
    const auto load_error = [](const std::string& content) {
        return error_of(CALL(load(a_shape + content)), ErrorCode::invalid_argument);
    };
    const std::string mirror = "<transform name='to_world'><scale x='-1'/></transform>";
    const std::string shear =
        "<transform name='to_world'><matrix value='1 1 0 0 0 1 0 0 0 0 1 0 0 0 0 1'/></transform>";
    for (const std::string& to_world : {mirror, shear}) {
        const std::string message = load_error("<emitter type='spot' id='lamp'>" + to_world + "</emitter>");
        CAPTURE(message);
        CHECK(message.find("scene.xml: emitter \"lamp\": ") != std::string::npos);
        CHECK(message.find("to_world must rotate without shearing or mirroring") != std::string::npos);
    }
    const std::string colored =
        "<texture type='mesh_attribute' name='texture'><string name='name' "
        "value='vertex_color'/></texture>";
    CHECK(load_error("<emitter type='spot'>" + colored + "</emitter>").find("colours of a mesh") !=
          std::string::npos);
}

TEST_CASE("what steers Mitsuba's sampling of lights is one notice") {
    const SceneDescription s =
        read(a_sensor +
             "<emitter type='point'><float name='sampling_weight' value='2'/></emitter>"
             "<shape type='cube'><emitter type='area'><float name='sampling_weight' value='2'/>"
             "</emitter></shape>");
    REQUIRE(s.notices.size() == 1);
    CHECK(s.notices[0].ends_with("not followed: sampling_weight, sampling_weight."));
}
