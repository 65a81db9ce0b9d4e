// SPDX-License-Identifier: MIT
#include "polarization/element.hpp"

#include "test.hpp"

using namespace nicol;
using Kind = PolarizationElement::Kind;
using Outline = PolarizationElement::Outline;

namespace {

/// The frame of propagation towards +z, seen against the light: x to the right, y up.
const Frame kAlong(1.0);
const Stokes kUnpolarized(1, 0, 0, 0);

PlacedElement element(Kind kind, double degrees, double retardance = 90) {
    return PlacedElement(
        {.kind = kind, .angle = glm::radians(degrees), .retardance = glm::radians(retardance)});
}

void check_near(const Mueller& a, const Mueller& b, double tolerance) {
    for (std::size_t i = 0; i < 16; ++i) CHECK(std::abs(a(i / 4, i % 4) - b(i / 4, i % 4)) < tolerance);
}

/// Returns a frame about the propagation direction.
Frame about(const glm::dvec3& propagation) {
    return frame_with_x(glm::normalize(propagation), {0.3, 0.2, -0.7});
}

/// Checks that light along `transmitted` passes unchanged and that perpendicular light is absorbed.
void check_polarizer(const Mueller& m, const Frame& frame, const glm::dvec3& transmitted) {
    const auto along = [&](const glm::dvec3& e) {
        const double angle = std::atan2(glm::dot(e, frame[1]), glm::dot(e, frame[0]));
        return Stokes(1, std::cos(2 * angle), std::sin(2 * angle), 0);
    };
    const Stokes kept = along(transmitted);
    CHECK(glm::distance(m * kept, kept) < 1e-12);
    CHECK(glm::length(m * along(glm::cross(frame[2], transmitted))) < 1e-12);
}

}  // namespace

TEST_CASE("at normal incidence elements do what their names say") {
    const struct {
        Kind kind;
        double angle;
        Stokes in, out;
    } rows[] = {
        {Kind::polarizer, 0, kUnpolarized, {0.5, 0.5, 0, 0}},
        {Kind::polarizer, 45, kUnpolarized, {0.5, 0, 0.5, 0}},
        {Kind::polarizer, 90, {1, 1, 0, 0}, {0, 0, 0, 0}},
        {Kind::right_circular, 0, kUnpolarized, {0.5, 0, 0, 0.5}},
        {Kind::right_circular, 30, {1, 0, 0, -1}, {0, 0, 0, 0}},
        {Kind::left_circular, 0, kUnpolarized, {0.5, 0, 0, -0.5}},
        {Kind::retarder, 20, kUnpolarized, {1, 0, 0, 0}},
        {Kind::retarder, 0, {1, 1, 0, 0}, {1, 1, 0, 0}},
        // In Mitsuba 3.9.1 a quarter-wave plate with its fast axis at 45 degrees behind a polarizer at 0 also
        // makes right circular light.
        {Kind::retarder, 45, {1, 1, 0, 0}, {1, 0, 0, 1}},
        {Kind::retarder, -45, {1, 1, 0, 0}, {1, 0, 0, -1}},
    };
    for (const auto& row : rows) {
        CAPTURE(static_cast<int>(row.kind));
        CAPTURE(row.angle);
        CHECK(glm::distance(element(row.kind, row.angle).mueller(kAlong) * row.in, row.out) < 1e-12);
    }
}

TEST_CASE("a half-wave plate mirrors E-vectors in its axis, and transmittance darkens") {
    const PlacedElement half = element(Kind::retarder, 30, 180);
    CHECK(glm::distance(half.mueller(kAlong) * Stokes(1, 1, 0, 0),
                        {1, std::cos(glm::radians(120.0)), std::sin(glm::radians(120.0)), 0}) < 1e-12);
    for (const Kind kind : {Kind::polarizer, Kind::retarder, Kind::right_circular, Kind::left_circular}) {
        const PolarizationElement clear{.kind = kind, .angle = 0.3};
        PolarizationElement dim = clear;
        dim.transmittance = 0.25;
        check_near(PlacedElement(dim).mueller(kAlong), 0.25 * PlacedElement(clear).mueller(kAlong), 1e-15);
    }
}

TEST_CASE("tilted elements are Mitsuba's, whichever side light comes from") {
    // In Mitsuba 3.9.1, eval_null_transmission, E-vectors pass that are perpendicular to the absorbing axis,
    // projected across the ray. The retardance is times |cos|.
    for (const glm::dvec3 propagation : {glm::dvec3(0.5, 0, 0.8), {0.2, -0.7, -0.4}, {-0.9, 0.3, 0.1}}) {
        const Frame frame = about(propagation);
        for (const double degrees : {0.0, 30.0, -77.0}) {
            const double angle = glm::radians(degrees);
            const glm::dvec3 absorbed(-std::sin(angle), std::cos(angle), 0);
            check_polarizer(element(Kind::polarizer, degrees).mueller(frame), frame,
                            glm::normalize(glm::cross(frame[2], absorbed)));
        }
        for (const Kind kind : {Kind::right_circular, Kind::left_circular})
            check_near(element(kind, 0).mueller(frame), element(kind, 0).mueller(kAlong), 1e-15);
        const Mueller retarded = element(Kind::retarder, 25, 80).mueller(frame);
        CHECK(retarded(3, 3) == doctest::Approx(std::cos(glm::radians(80.0) * std::abs(frame[2].z))));
        CHECK(retarded(0, 0) == doctest::Approx(1));
    }
}

TEST_CASE("the frame is that of the light alone") {
    const Frame frame = about({0.3, -0.4, 0.8});
    const Frame turned = frame_with_x(frame[2], {0, 1, 0});
    const double angle = angle_between(frame, turned);
    for (const Kind kind : {Kind::polarizer, Kind::retarder, Kind::right_circular})
        check_near(element(kind, 20, 50).mueller(turned),
                   in_rotated_frames(element(kind, 20, 50).mueller(frame), angle, angle), 1e-12);
}

TEST_CASE("an element goes with its transform and the axes that it is seen in") {
    const glm::dmat4 motion = glm::rotate(glm::translate(glm::dmat4(1), {1, 2, 3}), 0.7, {1, -2, 0.5});
    const glm::dmat4 scaled = glm::scale(glm::dmat4(1), {3, 0.5, 2});
    const PolarizationElement moved{.to_world = motion * scaled, .angle = 0.4};
    const PlacedElement world(moved);
    const PlacedElement own(moved, glm::inverse(motion));
    const PlacedElement plain(PolarizationElement{.angle = 0.4});
    const Frame frame = about({0.1, 0.3, 0.9});
    check_near(own.mueller(frame), plain.mueller(frame), 1e-12);
    check_near(world.mueller(Frame(glm::dmat3(motion) * frame)), plain.mueller(frame), 1e-12);
    // The frame stays right-handed if to_world mirrors, because y follows the normal.
    const auto mirrored = [](const glm::dvec3& by) {
        return PlacedElement({.to_world = glm::scale(glm::dmat4(1), by), .angle = 0.4}).mueller(kAlong);
    };
    check_near(mirrored({-1, 1, 1}), PlacedElement({.angle = 0.4}).mueller(kAlong), 1e-12);
    check_near(mirrored({1, 1, -1}), PlacedElement({.angle = -0.4}).mueller(kAlong), 1e-12);
}

TEST_CASE("where a line meets an element") {
    const glm::dmat4 at = glm::scale(glm::translate(glm::dmat4(1), {0, 0, 5}), {2, 1, 1});
    const struct {
        Outline outline;
        glm::dvec2 place;
        bool met;
    } rows[] = {{Outline::rectangle, {1.99, 0.99}, true}, {Outline::rectangle, {2.01, 0}, false},
                {Outline::rectangle, {0, -1.01}, false},  {Outline::disk, {1.99, 0}, true},
                {Outline::disk, {1.99, 0.99}, false},     {Outline::disk, {-1.4, 0.7}, true}};
    for (const auto& row : rows) {
        CAPTURE(row.place.x);
        const PlacedElement placed({.outline = row.outline, .to_world = at});
        const std::optional<ElementCrossing> met = placed.crossing({row.place, 1}, {0, 0, 2});
        CHECK(met.has_value() == row.met);
        if (met) {
            CHECK(met->distance == doctest::Approx(2));
            CHECK(glm::distance(met->place, row.place / glm::dvec2(2, 1)) < 1e-12);
        }
        CHECK_FALSE(placed.crossing({row.place, 1}, {1, 0, 0}));
    }
    CHECK(PlacedElement({.to_world = at}).crossing({0, 0, 6}, {0, 0, 1})->distance == doctest::Approx(-1));
}

TEST_CASE("what no element can be is refused by name") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    check(PolarizationElement{.angle = -1e4, .retardance = -7, .transmittance = 0});
    const auto refused = [](const PolarizationElement& element, const std::string& part) {
        check_error(ErrorCode::invalid_argument, CALL(check(element)), part);
    };
    for (const double value : {nan, 1e6}) refused({.angle = value}, "angle");
    refused({.retardance = std::numeric_limits<double>::infinity()}, "retardance");
    for (const double value : {-0.1, 1.1, nan}) refused({.transmittance = value}, "transmittance");
}
