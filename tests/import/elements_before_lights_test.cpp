// SPDX-License-Identifier: MIT
// Tests of polarization elements in front of lights without a surface: the lights that they cover, and the
// resulting Stokes vectors.
#include <glm/trigonometric.hpp>

#include "import/elements.hpp"
#include "import/load_scene.hpp"

using namespace nicol;

namespace {

/// A square of half side 0.5 that faces the lights. Lights with a position are at the origin and emit along
/// z.
const std::string target = "<shape type='rectangle'>" +
                           to_world("<scale value='0.5'/>" + backwards + "<translate z='5'/>") + "</shape>";
const std::string turn = "<rotate x='1' y='2' z='-1' angle='50'/><translate x='3' y='1' z='2'/>";
const std::vector<std::string> all_lights = {"directional", "point", "spot", "projector"};

std::string light(const std::string& type, const std::string& inside = "") {
    return "<emitter type='" + type + "'>" + inside + "</emitter>";
}

LoadedScene load(const std::string& content) {
    return load_scene(SceneFile(scene(a_sensor + content)).scene(), {});
}

/// Returns the light's Stokes vector in `frame`, relative to its intensity without elements.
Stokes stokes_along(const LocalLight& lit, const LocalLight& plain, const Frame& frame) {
    check(lit.state);
    return lit.value[0] / plain.value[0] *
           stokes_in(frame, lit.state, glm::normalize(glm::dmat3(lit.to_world) * lit.state.axis));
}

/// Returns the Stokes vector of the light behind elements, in the frame of the world's x and z. Without
/// elements s0 is 1.
Stokes light_behind(const std::string& elements, const std::string& its_light) {
    const LoadedScene loaded = load(its_light + target + elements);
    CHECK(loaded.notices.empty());
    return stokes_along(loaded.scene.lights().at(0), load(its_light + target).scene.lights().at(0),
                        Frame(1.0));
}

bool covers(const std::string& cover, const std::string& its_light, const std::string& shapes = target) {
    return load(its_light + shapes + cover).scene.lights().at(0).state.docp > 0.999;
}

/// Returns a right circular polarizer at z = 1.
std::string cover(double scale, const std::string& type = "rectangle", double x = 0) {
    return "<shape type='" + type + "'>" + right +
           to_world("<scale value='" + std::to_string(scale) + "'/><translate x='" + std::to_string(x) +
                    "' z='1'/>") +
           "</shape>";
}

}  // namespace

TEST_CASE("elements make of a light what they make of a lamp") {
    // The values equal those of lamps in polarization_element_test.cpp, to 3 digits.
    const struct {
        std::string elements;
        double s0;
        glm::dvec3 rest;  ///< divided by s0
    } rows[] = {
        {element(polarizer(0), 1), 0.5, {1, 0, 0}},
        {element(polarizer(30), 1), 0.5, {0.5, -0.866, 0}},
        {element(polarizer(30), 1, backwards), 0.5, {0.5, 0.866, 0}},
        {element(polarizer(0, "<float name='transmittance' value='0.5'/>"), 1), 0.25, {1, 0, 0}},
        {element(right, 1), 0.5, {0, 0, 1}},
        {element(left, 1), 0.5, {0, 0, -1}},
        {element(retarder(20, 60), 1), 1, {0, 0, 0}},
        {element(polarizer(0), 1) + element(retarder(45, 90), 1.1), 0.5, {0, 0, 1}},
        {element(retarder(45, 90), 1.1) + element(polarizer(0), 1), 0.5, {0, 0, 1}},
        {element(polarizer(15), 1) + element(retarder(40, 60), 1.1), 0.5, {0.403, -0.418, 0.814}},
        {element(retarder(-20, 100), 1.2) + element(retarder(30, 50), 1.1) + element(polarizer(10), 1),
         0.5,
         {0.901, 0.150, -0.408}},
        {element(right, 1) + element(polarizer(10), 1.1), 0.25, {0.940, -0.342, 0}},
        {element(polarizer(10), 1) + element(polarizer(40), 1.1), 0.375, {0.174, -0.985, 0}},
    };
    for (const std::string& type : all_lights)
        for (const auto& row : rows) {
            CAPTURE(type);
            CAPTURE(row.elements);
            check_near(light_behind(row.elements, light(type)),
                       row.s0 * Stokes(1, row.rest.x, row.rest.y, row.rest.z), 1.2e-3);
        }
}

TEST_CASE("light that is polarized already passes by Malus' law") {
    for (const std::string& type : all_lights)
        for (const double angle : {0.0, 20.0, 65.0, 110.0}) {
            CAPTURE(type);
            const std::string polarized = light(type, number("dolp", 0.8) + number("aolp", 20));
            const double s0 = 0.5 * (1 + 0.8 * std::cos(2 * glm::radians(angle - 20)));
            const double at = 2 * glm::radians(angle);
            check_near(light_behind(element(polarizer(-angle), 1), polarized),
                       s0 * Stokes(1, std::cos(at), std::sin(at), 0), 1e-9);
        }
    CHECK(light_behind(element(polarizer(0), 1) + element(polarizer(90), 2), light("point"))[0] ==
          doctest::Approx(0));
}

TEST_CASE("nothing changes where light, elements and surfaces are placed together") {
    for (const std::string& type : all_lights) {
        CAPTURE(type);
        const std::string turned =
            "<shape type='rectangle'>" + to_world("<scale value='0.5'/><translate z='5'/>" + turn) +
            "</shape>" + "<shape type='rectangle'>" + polarizer(30) + to_world("<translate z='1'/>" + turn) +
            "</shape>" + "<shape type='rectangle'>" + retarder(0, 80) +
            to_world("<translate z='1.1'/>" + turn) + "</shape>";
        const std::string its_light = light(type, to_world(turn));
        const glm::dmat3 axes(transform(turn));
        const Stokes expected =
            light_behind(element(polarizer(30), 1) + element(retarder(0, 80), 1.1), light(type));
        check_near(stokes_along(load(its_light + turned).scene.lights().at(0),
                                load(its_light + target).scene.lights().at(0), Frame(axes)),
                   expected, 1e-6);
    }
}

TEST_CASE("tilted elements act along the light's axis, polarizers in each direction") {
    const std::string tilt = "<rotate x='2' y='1' angle='35'/>";
    const glm::dmat3 turned(transform(tilt));
    const Stokes retarded =
        light_behind(element(polarizer(0), 0.5) + element(retarder(45, 90), 2, tilt), light("directional"));
    // The fast axis is projected across the light, and the retardance is times the cosine of the tilt.
    const glm::dvec3 fast = turned * glm::dvec3(std::sqrt(0.5), std::sqrt(0.5), 0);
    const double at = 2 * std::atan2(fast.y, fast.x);
    const double delta = glm::radians(90.0) * turned[2].z;
    const Stokes along_fast(1, std::cos(at), -std::sin(at) * std::cos(delta), std::sin(at) * std::sin(delta));
    check_near(retarded, 0.5 * rotated(along_fast, -at / 2), 1e-9);

    const LoadedScene loaded = load(light("spot") + target + element(polarizer(30), 1, tilt));
    const glm::dvec3 absorbs = turned * glm::dvec3(0.5, std::sqrt(0.75), 0);
    for (const glm::dvec3& direction : {glm::dvec3(0, 0, 1), {0.3, 0, 1}, {-0.1, 0.3, 1}}) {
        const Frame frame = frame_with_x(glm::normalize(direction), absorbs);
        check_near(stokes_along(loaded.scene.lights().at(0),
                                load(light("spot") + target).scene.lights().at(0), frame),
                   Stokes(0.5, -0.5, 0, 0), 1e-9);
    }
}

TEST_CASE("elements stay in the scene, and colours and textures of lights are theirs") {
    const LoadedScene loaded =
        load("<emitter type='projector'><texture type='checkerboard' name='irradiance'/></emitter>" +
             light("spot", "<rgb name='intensity' value='2 4 6'/>") + target + element(right, 1));
    CHECK(loaded.scene.elements().size() == 1);
    CHECK(loaded.scene.lights().at(1).value == std::vector<double>{1, 2, 3});
    CHECK(loaded.scene.lights().at(0).texture != nullptr);
    CHECK(loaded.scene.lights().at(0).state.docp == doctest::Approx(1));
}

TEST_CASE("elements cover the cone of a spot and the pyramid of a projector") {
    const std::string spot = light("spot", number("cutoff_angle", 20));
    CHECK(covers(cover(0.366), spot));  // tan 20 degrees is 0.3640
    CHECK_FALSE(covers(cover(0.363), spot));
    CHECK(covers(cover(0.366, "disk"), spot));
    CHECK_FALSE(covers(cover(0.363, "disk"), spot));
    CHECK(covers(cover(0.4, "rectangle", 0.03), spot));
    CHECK_FALSE(covers(cover(0.4, "rectangle", 0.05), spot));
    CHECK_FALSE(covers(cover(1000), light("spot", number("cutoff_angle", 90))));
    const std::string projector = light("projector", number("fov", 45));
    CHECK(covers(cover(0.4143), projector));  // tan 22.5 degrees is 0.41421
    CHECK_FALSE(covers(cover(0.4141), projector));
    CHECK_FALSE(covers(cover(0.58, "disk"), projector));
    CHECK(covers(cover(0.586, "disk"), projector));
    // The element is behind the light.
    const std::string behind = to_world("<rotate x='1' angle='180'/>");
    for (const char* type : {"spot", "projector"}) CHECK_FALSE(covers(cover(10), light(type, behind)));
}

TEST_CASE("elements cover a point or directional light where all surfaces lie behind them") {
    const std::string sun = light("directional");
    CHECK(covers(cover(0.5), sun));
    CHECK_FALSE(covers(cover(0.499), sun));
    CHECK_FALSE(covers(cover(0.5, "rectangle", 0.001), sun));
    const std::string disc = light("directional", number("angular_radius", 5));
    CHECK(covers(cover(0.853), disc));  // 0.5 + 4 tan 5 degrees
    CHECK_FALSE(covers(cover(0.849), disc));
    const std::string point = light("point");
    CHECK(covers(cover(0.1), point));
    CHECK_FALSE(covers(cover(0.0999), point));
    const std::string black =
        "<shape type='sphere'><bsdf type='diffuse'><rgb name='reflectance' value='0'/></bsdf></shape>";
    const auto ball = [](double radius, const glm::dvec3& at) {
        return "<shape type='sphere'>" + number("radius", radius) + "<point name='center' x='" +
               std::to_string(at.x) + "' y='" + std::to_string(at.y) + "' z='" + std::to_string(at.z) +
               "'/></shape>";
    };
    for (const std::string& its_light : {sun, point}) {
        CAPTURE(its_light);
        CHECK(covers(cover(2), its_light, target + ball(0.1, {0, 0, 3})));
        CHECK_FALSE(covers(cover(2), its_light, target + ball(0.1, {0, 0, 0.5})));
        CHECK_FALSE(covers(cover(2), its_light, target + ball(0.1, {3, 0, 1.2})));
        CHECK_FALSE(covers(cover(2), its_light, target + ball(0.1, {0, 0, -3})));
        CHECK(covers(cover(2), its_light, target + black));
    }
}

TEST_CASE("notices say what elements do not do, and which lights they cover in part") {
    const auto notices = [](const std::string& content) {
        const SceneFile file(scene(a_sensor + content + "\n" + element(right, 1)));
        const std::vector<std::string> all = load_scene(file.scene(), {}).notices;
        for (const std::string& notice : all) CHECK(notice.find(file.scene().string() + ":4: ") == 0);
        return all;
    };
    const std::string other = "other light passes them unchanged";
    CHECK(notices(target + light("point") + light("spot")).empty());
    for (const std::string& lights : {an_emitter, light("spot", to_world("<translate x='50'/>")),
                                      std::string("<shape type='sphere'><emitter type='area'/></shape>")}) {
        const std::vector<std::string> only = notices(target + lights.substr(0, lights.find('\n')));
        REQUIRE(only.size() == 1);
        CHECK(only[0].find(other) != std::string::npos);
    }
    const std::string wide = "<emitter type='spot' id='key'>" + number("cutoff_angle", 50) + "</emitter>";
    const std::vector<std::string> part = notices(target + wide + wide.substr(0, 21) + "/>");
    REQUIRE(part.size() == 2);
    CHECK(part[0].find(other) != std::string::npos);
    CHECK(part[1].find("does not cover the spot \"key\", whose light passes beside it towards (1.19") !=
          std::string::npos);
    CHECK(part[1].find(", 1.000000)") != std::string::npos);
}
