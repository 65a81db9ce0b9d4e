// SPDX-License-Identifier: MIT
// Tests of hidden light against sums in double precision.
#include "visibility/hidden_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <random>

#include "geometry/unit.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("hidden light is the sum over hidden directions above the surface") {
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    for (const int count : {256, 1024, 1000}) {
        CAPTURE(count);
        const DirectionSet directions(count);
        const HiddenLight hidden(directions);
        constexpr std::size_t vertices = 64;
        Visibility visibility(directions.size(), vertices);
        for (std::size_t v = 0; v < vertices; ++v) {
            // Every third vertex from nothing hidden to nearly everything, others a random half.
            for (std::uint64_t& word : visibility.at(v))
                word = v % 3 == 0 ? ~std::uint64_t{0} << v : (std::uint64_t{random()} << 32) | random();
            visibility.set_unoccluded(v, false);
            const glm::vec3 n = unit(glm::vec3(normal(random), normal(random), normal(random)));
            glm::dvec4 sum(0.0);
            for (std::size_t d = 0; d < directions.size(); ++d) {
                if ((visibility.at(v)[d / 64] >> (d % 64) & 1U) != 0) continue;
                const glm::dvec3 to(directions.directions()[d]);
                const double weight = static_cast<double>(directions.weights()[d]) / std::numbers::pi *
                                      std::max(0.0, glm::dot(glm::dvec3(n), to));
                sum += weight * glm::dvec4(1.0, to.x, to.y, to.z);
            }
            CHECK(glm::distance(glm::dvec4(hidden.at(visibility, v, n)), sum) < 1e-5);
        }
    }
}
