// SPDX-License-Identifier: MIT
// Tests of the projection of light from single directions.
#include "transfer/arriving_light.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "harmonics/evaluate.hpp"
#include "polarization/stokes.hpp"
#include "visibility/visibility_directions.hpp"

using namespace nicol;

namespace {

constexpr int kOrder = 3;

PshVector some_field() {
    PshVector field(kOrder, 1);
    for (int l = 0; l <= kOrder; ++l)
        for (int m = -l; m <= l; ++m)
            for (int p = 0; p < 4; ++p)
                if (l >= 2 || p == 0 || p == 3)
                    field.at(0, l, m, p) = std::sin(1 + 5.1 * l + 2.3 * m + 3.7 * p);
    return field;
}

double number(const LightLayout& layout, const PshVector& field, std::size_t j) {
    const auto& [first, second] = layout.terms()[j];
    return first.factor * field.channel(0)[first.coefficient] +
           second.factor * field.channel(0)[second.coefficient];
}

Viewpoint some_frames() {
    return {.eye = {0, 0, 0}, .forward = {1, 0, 0}, .up = {0, 0.6, 0.8}, .right = {0, 0.8, -0.6}};
}

// Lights that arrive, in the frame field of some_frames(): the third of sixteen has a Stokes vector.
using Arriving = std::array<Lanes, 4>;
constexpr std::size_t kColumn = 2;
constexpr ArrivingLight::SolidAngles kSolidAngles{.scalar = 0.1F, .polarized = 0.1F};

// Returns the light from a direction.
Arriving arriving(const Stokes& in_theta_phi, const glm::dvec3& direction) {
    const glm::dvec3 propagation = -glm::normalize(direction);
    const glm::vec4 stokes(
        rotated(in_theta_phi, angle_between(theta_phi_frame(propagation), some_frames().frame(propagation))));
    Arriving out{};
    for (std::size_t p = 0; p < 4; ++p) out[p][kColumn] = stokes[static_cast<glm::length_t>(p)];
    return out;
}

}  // namespace

TEST_CASE("light that arrives from all directions has its coefficients") {
    const DirectionSet directions(1024);
    const PshVector field = some_field();
    for (const LightKind kind : {LightKind::unpolarized, LightKind::linear, LightKind::full}) {
        const LightLayout layout(kOrder, kind);
        const ArrivingLight arrival(layout, directions.directions(), some_frames());
        std::vector<Lanes> numbers(layout.size(), Lanes{});
        for (std::size_t d = 0; d < directions.size(); ++d) {
            const glm::dvec3 direction(directions.directions()[d]);
            const float weight = directions.weights()[d];
            arrival.add(d, {.scalar = weight, .polarized = weight}, 4, 1,
                        arriving(evaluate(field, 0, -direction), direction).data(), numbers.data());
        }
        for (std::size_t j = 0; j < numbers.size(); ++j)
            CHECK(double{numbers[j][kColumn]} == doctest::Approx(number(layout, field, j)).epsilon(1e-4));
        CHECK(numbers[0][0] == 0);
    }
}

TEST_CASE("s0 alone arrives as it does with the other components") {
    const std::vector<glm::vec3> directions{glm::normalize(glm::vec3(0.3F, -0.5F, 0.7F))};
    const LightLayout layout(kOrder, LightKind::linear);
    const ArrivingLight arrival(layout, directions, some_frames());
    const Arriving light = arriving({2, 0.7, -0.4, 0}, glm::dvec3(directions[0]));
    std::vector<Lanes> all(layout.size(), Lanes{}), scalars(layout.size(), Lanes{});
    arrival.add(0, kSolidAngles, 3, 1, light.data(), all.data());
    arrival.add(0, kSolidAngles, 1, 1, light.data(), scalars.data());
    for (std::size_t j = 0; j < layout.size(); ++j)
        CHECK(scalars[j][kColumn] == (j < layout.spin_begin() ? all[j][kColumn] : 0.0F));
    std::vector<Lanes> apart(layout.size(), Lanes{});
    arrival.add(0, {.scalar = 0.2F, .polarized = 0.3F}, 3, 1, light.data(), apart.data());
    for (std::size_t j = 0; j < layout.size(); ++j)
        CHECK(apart[j][kColumn] ==
              doctest::Approx((j < layout.spin_begin() ? 2.0F : 3.0F) * all[j][kColumn]).epsilon(1e-5));
}

TEST_CASE("the mirror image is the light that a mirror in the surface's plane would send from below") {
    const LightLayout layout(kOrder, LightKind::full);
    const glm::vec3 above = glm::normalize(glm::vec3(0.3F, -0.5F, 0.7F));
    const std::vector<glm::vec3> directions{above, {above.x, above.y, -above.z}};
    const ArrivingLight arrival(layout, directions, some_frames());
    const Stokes light{2, 0.7, -0.4, 0.5};
    const Stokes image{light.x, light.y, -light.z, -light.w};
    std::vector<Lanes> both(layout.size(), Lanes{});
    arrival.add(0, kSolidAngles, 4, 1, arriving(light, glm::dvec3(above)).data(), both.data());
    VertexLight lanes(layout, 1, 1);
    for (std::size_t j = 0; j < layout.size(); ++j) lanes.block(0, 0)[j].value.fill(both[j][kColumn]);
    add_mirror_image(layout, lanes, 0);
    arrival.add(1, kSolidAngles, 4, 1, arriving(image, glm::dvec3(directions[1])).data(), both.data());
    for (std::size_t j = 0; j < layout.size(); ++j)
        CHECK(lanes.block(0, 0)[j][5] == doctest::Approx(both[j][kColumn]).epsilon(1e-4));
}

TEST_CASE("the numbers of a small light have places in a larger one") {
    const PshVector field = some_field();
    const PshVector more = with_order(field, 6);
    for (const LightKind kind : {LightKind::unpolarized, LightKind::linear, LightKind::full}) {
        const LightLayout part(kOrder, kind), whole(6, LightKind::full);
        const std::vector<std::size_t> places = places_in(part, whole);
        REQUIRE(places.size() == part.size());
        for (std::size_t j = 0; j < places.size(); ++j)
            CHECK(number(whole, more, places[j]) == number(part, field, j));
    }
}
