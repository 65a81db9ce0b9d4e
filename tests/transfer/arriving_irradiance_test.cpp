// SPDX-License-Identifier: MIT
// Tests of light of few orders whose irradiance is that of all orders.
#include "transfer/arriving_irradiance.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/evaluate.hpp"
#include "polarization/viewpoint.hpp"
#include "test.hpp"
#include "transfer/arriving_light.hpp"

using namespace nicol;

namespace {

constexpr std::size_t kColumn = 5;  // of the light among sixteen

// Returns the irradiance over pi of a field, by midpoints on the upper hemisphere.
double irradiance(const LightLayout& layout, const VertexLight& light) {
    PshVector field(layout.order(), 1);
    for (std::size_t j = 0; j < layout.size(); ++j)
        for (const LightLayout::Term& term : layout.terms()[j])
            field.channel(0)[term.coefficient] += term.factor * double{light.block(0, 0)[j][kColumn]};
    constexpr int rows = 64, columns = 32;
    double sum = 0;
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < columns; ++k) {
            const double z = (i + 0.5) / rows, phi = 2 * std::numbers::pi * (k + 0.5) / columns;
            const double r = std::sqrt(1 - z * z);
            // Light from a direction propagates against it.
            sum += z * evaluate(field, 0, {-r * std::cos(phi), -r * std::sin(phi), -z})[0];
        }
    return 2 * sum / (rows * columns);
}

}  // namespace

TEST_CASE("light of few orders has the irradiance that arrives, from any direction") {
    constexpr float solid_angle = 0.3F;
    for (const int order : {0, 2, 3, 5}) {
        const LightLayout layout(order, LightKind::unpolarized);
        const ArrivingIrradiance exact(layout);
        for (const float z : {1.0F, 0.7F, 0.5F, 0.1F, 0.0F}) {
            CAPTURES(order, z);
            const glm::vec3 direction(0.6F * std::sqrt(1 - z * z), 0.8F * std::sqrt(1 - z * z), z);
            const ArrivingLight arrival(layout, {&direction, 1}, Viewpoint{});
            VertexLight light(layout, 1, kLanes);
            std::ranges::fill(light.block(0, 0), Lanes{});
            Lanes power{}, wanted{};
            power[kColumn] = 2;
            wanted[kColumn] = 2 * solid_angle * z / std::numbers::pi_v<float>;
            arrival.add(0, {.scalar = solid_angle, .polarized = 0}, 1, 1, &power, light.block(0, 0).data());
            add_mirror_image(layout, light, 0);
            exact.set(wanted, light.block(0, 0));
            CHECK(irradiance(layout, light) == doctest::Approx(wanted[kColumn]).epsilon(2e-3));
            // Light whose irradiance is right is not changed.
            const Lanes before = light.block(0, 0)[0];
            exact.set(wanted, light.block(0, 0));
            CHECK(light.block(0, 0)[0][kColumn] == doctest::Approx(before[kColumn]));
        }
    }
}
