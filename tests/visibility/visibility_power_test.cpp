// SPDX-License-Identifier: MIT
// Tests of the mean effect of shadows on spectra over all orientations.
#include "visibility/visibility_power.hpp"

#include <numeric>

#include "harmonics/psh.hpp"
#include "test.hpp"
#include "visibility/projected.hpp"

using namespace nicol;

namespace {

const glm::vec3 up(0, 1, 0);
const std::array<std::uint32_t, 1> first{0};

// Returns a vertex that sees a cone about `axis`, with this cosine of its half angle, above its horizon.
Visibility cone(const DirectionSet& directions, const glm::vec3& axis, float cosine) {
    Visibility visibility(directions.size(), 1);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const glm::vec3& d = directions.directions()[i];
        if (glm::dot(d, up) > 0 && glm::dot(d, axis) > cosine)
            visibility.at(0)[i / 64] |= std::uint64_t{1} << (i % 64);
    }
    return visibility;
}

VisibilityHarmonics harmonics_over(const DirectionSet& directions) {
    return {directions, VisibilityPower::kOrder};
}

/// Returns a spectrum after multiplication with the visibility.
std::vector<double> shadowed(const VisibilityPower& power, const std::vector<double>& response, int spin) {
    const std::size_t size = response.size();
    const std::vector<double> coupling = OrderCoupling(static_cast<int>(size) - 1, spin).of(power);
    std::vector<double> out(size);
    for (std::size_t to = 0; to < size; ++to)
        for (std::size_t from = 0; from < size; ++from)
            out[to] += coupling[to * size + from] * response[from];
    return out;
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("an unoccluded vertex changes no spectrum") {
    const DirectionSet directions(2048);
    Visibility open(directions.size(), 1);
    open.set_unoccluded(0, true);
    const VisibilityPower power(harmonics_over(directions), open, std::span(&up, 1), first);
    const std::vector<double> response{0, 0, 3, 0.5, 0.25};
    for (const int spin : {0, 2}) {
        const std::vector<double> same = shadowed(power, response, spin);
        for (std::size_t l = 0; l < response.size(); ++l)
            CHECK(same[l] == doctest::Approx(response[l]).epsilon(1e-5));
    }
}

TEST_CASE("the energy that is left is the visible part") {
    const DirectionSet directions(8192);
    const VisibilityPower power(harmonics_over(directions),
                                cone(directions, glm::normalize(glm::vec3(1, 2, 0)), 0.3F), std::span(&up, 1),
                                first);
    CHECK(power.fraction() > 0.4);
    CHECK(power.fraction() < 0.8);
    std::vector<double> response(120, 0.0);
    response[2] = 1;
    response[3] = 2;
    for (const int spin : {0, 2}) {
        const std::vector<double> left = shadowed(power, response, spin);
        CHECK(sum(left) == doctest::Approx(3 * power.fraction()).epsilon(0.03));
        CHECK(left[2] < 1);
        CHECK(left[10] > 0);
    }
}

TEST_CASE("a response of order 1 leaves in order 0 what the visibility has in order 1") {
    const DirectionSet directions(4096);
    const Visibility visibility = cone(directions, glm::normalize(glm::vec3(1, 1, 0)), 0.5F);
    const VisibilityPower power(harmonics_over(directions), visibility, std::span(&up, 1), first);
    const VisibilityHarmonics harmonics(directions, 1);
    const std::vector<float> v = test::projected(harmonics, visibility, std::span(&up, 1), 0);
    double first = 0;
    for (std::size_t k = 1; k < v.size(); ++k) first += static_cast<double>(v[k]) * static_cast<double>(v[k]);
    const std::vector<double> response{0, 5};
    CHECK(shadowed(power, response, 0)[0] == doctest::Approx(5 * first / 3 / (4 * pi)).epsilon(1e-5));
}
