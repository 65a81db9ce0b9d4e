// SPDX-License-Identifier: MIT
// Tests of local lights and emission: refusals, and texture coordinates.
#include "light/local_light.hpp"
#include "function_texture.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;
using Kind = LocalLight::Kind;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TexturePtr texture(int channels, const glm::vec2& range = {0, 1}) {
    return texture_of([](const TexturePoint&) { return glm::vec4(1); }, channels, range);
}

TexturePtr mesh_colors(ColorsOf of) {
    return std::make_shared<const FunctionTexture>([](const TexturePoint&) { return glm::vec4(1); }, 3,
                                                   glm::vec2(0, 1), of);
}

}  // namespace

TEST_CASE("parameters of local lights out of range are refused by name") {
    const glm::dmat4 scaled = glm::scale(glm::dmat4(1.0), glm::dvec3(2));
    const glm::dmat4 mirrored = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, -1));
    const glm::dmat4 nowhere = glm::translate(glm::dmat4(1.0), glm::dvec3(0, not_a_number, 0));
    const struct {
        LocalLight light;
        const char* named;
    } cases[] = {
        {{.value = {}}, "value of a light has no value"},
        {{.value = {1, -2, 1}}, "value of a light is -2"},
        {{.value = {not_a_number}}, "value of a light"},
        {{.value = {2e30}}, "0 to 1e30"},
        {{.to_world = scaled}, "to_world"},
        {{.to_world = mirrored}, "rotation"},
        {{.to_world = nowhere}, "shift"},
        {{.kind = Kind::directional, .angular_radius = -0.1}, "angular_radius is -0.1"},
        {{.kind = Kind::directional, .angular_radius = 1.6}, "radians"},
        {{.kind = Kind::spot, .cutoff_angle = 0}, "cutoff_angle"},
        {{.kind = Kind::spot, .cutoff_angle = 2}, "cutoff_angle is 2"},
        {{.kind = Kind::spot, .cutoff_angle = 0.2, .beam_width = 0.3}, "beam_width is 0.3"},
        {{.kind = Kind::projector, .fov = 0}, "fov"},
        {{.kind = Kind::projector, .fov = 3.2}, "fov is 3.2"},
        {{.kind = Kind::projector, .aspect = 0}, "aspect"},
        {{.kind = Kind::projector, .aspect = not_a_number}, "aspect"},
        {{.kind = Kind::point, .texture = texture(3)}, "only spots and projectors"},
        {{.kind = Kind::directional, .texture = texture(3)}, "only spots and projectors"},
        {{.kind = Kind::spot, .texture = texture(4)}, "has 4 channels"},
        {{.kind = Kind::spot, .value = {1, 2}, .texture = texture(3)}, "the light 2"},
        {{.kind = Kind::spot, .texture = texture(1, {-1, 1})}, "negative"},
        {{.kind = Kind::spot, .texture = mesh_colors(ColorsOf::vertices)}, "colours of a mesh"},
        {{.kind = Kind::spot, .texture = mesh_colors(ColorsOf::faces)}, "colours of a mesh"},
        {{.state = {.dolp = 2}}, "dolp"},
    };
    for (const auto& c : cases) check_error(ErrorCode::invalid_argument, CALL(check(c.light)), c.named);
    for (const Kind kind : {Kind::directional, Kind::point, Kind::spot, Kind::projector})
        CHECK_NOTHROW(check(LocalLight{.kind = kind, .value = {0, 1, 2, 3}}));
    // Parameters of other kinds are ignored.
    CHECK_NOTHROW(check(LocalLight{.kind = Kind::point, .angular_radius = -1, .fov = -1}));
}

TEST_CASE("parameters of emission out of range are refused by name") {
    const struct {
        Emission emission;
        const char* named;
    } cases[] = {
        {{.radiance = {}}, "radiance of a surface has no value"},
        {{.radiance = {-1}}, "radiance of a surface is -1"},
        {{.texture = texture(4)}, "has 4 channels"},
        {{.radiance = {1, 1, 1, 1}, .texture = texture(3)}, "the light 4"},
        {{.texture = texture(3, {-1, 0})}, "negative"},
        {{.state = {.docp = 2}}, "docp"},
    };
    for (const auto& c : cases) check_error(ErrorCode::invalid_argument, CALL(check(c.emission)), c.named);
    CHECK_NOTHROW(check(Emission{.radiance = {1, 2, 3}, .texture = texture(1)}));
    CHECK_NOTHROW(check(Emission{.texture = mesh_colors(ColorsOf::faces)}));
}

TEST_CASE("a light has the channels of its value or its texture") {
    CHECK(LocalLight{}.channels() == 1);
    CHECK(LocalLight{.value = {1, 2, 3, 4}}.channels() == 4);
    CHECK(LocalLight{.kind = Kind::spot, .texture = texture(3)}.channels() == 3);
    CHECK(Emission{.radiance = {1, 2, 3}, .texture = texture(1)}.channels() == 3);
}

TEST_CASE("a value is multiplied by its texture, channel by channel") {
    const glm::vec4 texel(2, 3, 4, 1);
    for (int c = 0; c < 3; ++c) {
        CHECK(textured_value({5}, nullptr, texel, c) == 5);
        CHECK(textured_value({5, 6, 7}, nullptr, texel, c) == 5 + c);
        CHECK(textured_value({5}, texture(3), texel, c) == 5 * (2 + c));
        CHECK(textured_value({5, 6, 7}, texture(3), texel, c) == (5 + c) * (2 + c));
        CHECK(textured_value({5, 6, 7}, texture(1), texel, c) == (5 + c) * 2);
    }
}

TEST_CASE("a spot is as bright as on its axis within the beam, and falls linearly to its cutoff") {
    const auto towards = [](double angle) { return glm::dvec3(std::sin(angle), 0, std::cos(angle)); };
    const LocalLight spot{.kind = Kind::spot, .cutoff_angle = 0.5, .beam_width = 0.3};
    for (const auto& [angle, wanted] :
         {std::pair{0.0, 1.0}, {0.29, 1.0}, {0.35, 0.75}, {0.45, 0.25}, {0.51, 0.0}, {2.0, 0.0}})
        CHECK(light_pattern(spot, towards(angle)) == doctest::Approx(wanted));
    const LocalLight hard{.kind = Kind::spot, .cutoff_angle = 0.5, .beam_width = 0.5};
    CHECK(light_pattern(hard, towards(0.499)) == 1);
    CHECK(light_pattern(hard, towards(0.501)) == 0);
}

TEST_CASE("a projector lights its rectangle evenly, and nothing else") {
    const LocalLight projector{.kind = Kind::projector, .fov = pi / 2, .aspect = 2};
    for (const glm::dvec2& at : {glm::dvec2(0, 0), {0.99, 0}, {-0.99, 0.49}, {0.5, -0.49}}) {
        const double distance = std::sqrt(1 + glm::dot(at, at));
        // On the plane z = 1 the irradiance is 1: that of a surface that faces the light, times the cosine,
        // at the distance 1 / cosine.
        const double facing = light_pattern(projector, glm::dvec3(at, 1) / distance);
        CHECK(facing / (distance * distance * distance) == doctest::Approx(1));
    }
    for (const glm::dvec3& outside : {glm::dvec3(1.01, 0, 1), {0, 0.51, 1}, {0, 0, -1}, {1, 0, 0}})
        CHECK(light_pattern(projector, glm::normalize(outside)) == 0);
}

TEST_CASE("the outline of a light encloses all its light, closely") {
    for (const LocalLight& light : {LocalLight{.kind = Kind::spot, .cutoff_angle = 0.6, .beam_width = 0.6},
                                    LocalLight{.kind = Kind::projector, .fov = 1.2, .aspect = 1.5}}) {
        CAPTURE(light_name(light.kind));
        const std::vector<glm::dvec3> outline = light_outline(light);
        REQUIRE(outline.size() >= 4);
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec2 corner(outline[i]);
            const glm::dvec2 side = glm::dvec2(outline[(i + 1) % outline.size()]) - corner;
            // A point beside the side is dark, but for the margin; one within it is lit.
            for (const double part : {0.1, 0.5, 0.9}) {
                const glm::dvec2 at = corner + part * side;
                CHECK(light_pattern(light, glm::normalize(glm::dvec3(1.00001 * at, 1))) == 0);
                CHECK(light_pattern(light, glm::normalize(glm::dvec3(0.99 * at, 1))) > 0);
            }
        }
    }
    CHECK(light_outline({.kind = Kind::point}).empty());
    CHECK(light_outline({.kind = Kind::directional}).size() == 1);
    for (const glm::dvec3& d : light_outline({.kind = Kind::directional, .angular_radius = 0.3})) {
        const double angle = std::acos(d.z / glm::length(d));
        CHECK(angle > 0.3);
        CHECK(angle < 0.303);
    }
}

// The expected values are how Mitsuba 3.9 places an image of 4 x 2 pixels.
TEST_CASE("the texture of a spot fills the square around its cone, that of a projector its rectangle") {
    const LocalLight spot{.kind = Kind::spot, .cutoff_angle = pi / 4};
    const LocalLight projector{.kind = Kind::projector, .fov = pi / 2, .aspect = 2};
    const struct {
        LocalLight light;
        glm::dvec3 direction;
        glm::dvec2 uv;
    } cases[] = {
        {spot, {0, 0, 3}, {0.5, 0.5}},      {spot, {-1, -1, 1}, {0, 0}},
        {spot, {2, 0, 2}, {1, 0.5}},        {spot, {0, 0.5, 1}, {0.5, 0.75}},
        {projector, {0, 0, 3}, {0.5, 0.5}}, {projector, {2, 1, 2}, {0, 0}},
        {projector, {-1, -0.5, 1}, {1, 1}}, {projector, {0, 0.25, 1}, {0.5, 0.25}},
    };
    for (const auto& c : cases) CHECK(glm::length(light_texcoords(c.light, c.direction) - c.uv) < 1e-12);
}
