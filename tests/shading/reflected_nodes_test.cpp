// SPDX-License-Identifier: MIT
#include "shading/reflected_nodes.hpp"

#include <glm/geometric.hpp>

#include "directions.hpp"
#include "material/microfacet.hpp"
#include "polarization/stokes.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

glm::dvec3 lane(const LaneVectors& v, std::size_t i) {
    return {v.x[i], v.y[i], v.z[i]};
}

/// Returns the light of a normally distributed blob of light around `middle`, averaged over a blob of a
/// variance around a direction.
double light(const glm::dvec3& towards, const glm::dvec3& middle, double own, double variance) {
    const double angle = std::acos(std::clamp(glm::dot(towards, middle), -1.0, 1.0));
    return own / (own + variance) * std::exp(-angle * angle / (2 * (own + variance)));
}

/// Returns what a node adds if its light is that of light(), reflected by the facets that `towards` meets, as
/// far as other facets do not hide them. The density of facets is 1 when summed over all slopes.
double reflected(const Lobe& lobe, const glm::dvec3& viewer, const ReflectedNode& node,
                 const glm::dvec3& towards, const glm::dvec3& middle, double variance, std::size_t i) {
    const glm::dvec3 half = glm::normalize(towards + viewer);
    const double facets =
        facet_density(lobe.distribution, lobe.alpha, half) * half.z / (4 * glm::dot(half, towards));
    return static_cast<double>(node.weights[i]) * facets *
           facet_visibility(lobe.distribution, lobe.alpha, towards) *
           light(glm::normalize(lane(node.seen, i)), middle, variance,
                 static_cast<double>(node.variances[i]));
}

}  // namespace

TEST_CASE("nodes add up to the integral over the lobe and the pixel") {
    // Directions to viewers from above the surface to 70 degrees.
    LaneVectors viewers;
    for (std::size_t i = 0; i < kLanes; ++i)
        put(viewers, i, glm::vec3(direction(0.08 * static_cast<double>(i), 0.7 * static_cast<double>(i))));
    const struct {
        Lobe lobe;
        double pixel;      // width, in radians
        double variance;   // of the light
        double tolerance;  // of the largest value
    } rows[] = {{{glm::dvec2(0.02), Distribution::beckmann}, 0, 1e-3, 0.03},
                {{glm::dvec2(0.02), Distribution::beckmann}, 0.1, 1e-3, 0.11},
                {{glm::dvec2(0.001), Distribution::beckmann}, 0.1, 1e-3, 0.05},
                {{{0.1, 0.4}, Distribution::beckmann}, 0, 0.01, 0.11},
                {{{0.4, 0.1}, Distribution::beckmann}, 0.05, 0.01, 0.08},
                {{glm::dvec2(0.05), Distribution::ggx}, 0, 5e-3, 0.11},
                {{{0.1, 0.3}, Distribution::ggx}, 0, 0.01, 0.16},
                // A wide light, whose reflection depends on the long tail of GGX.
                {{glm::dvec2(0.05), Distribution::ggx}, 0, 0.1, 0.0115},
                // Even light, which wide lobes see cut by the horizon.
                {{{0.6, 0.23}, Distribution::ggx}, 0, 1e6, 0.055},
                {{{0.6, 0.23}, Distribution::beckmann}, 0, 1e6, 0.055}};
    const NodeGrids grids(32);
    for (const auto& row : rows) {
        CAPTURES(row.lobe.alpha.x, row.lobe.alpha.y, row.pixel, static_cast<int>(row.lobe.distribution));
        MirroredPixels pixels;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::dvec3 viewer = lane(viewers, i);
            const Frame axes = frame_with_x(glm::dvec3(-viewer.x, -viewer.y, viewer.z), {0.3, 0.8, 0.1});
            put(pixels.steps[0], i, glm::vec3(row.pixel * axes[0]));
            put(pixels.steps[1], i, glm::vec3(0.7 * row.pixel * axes[1]));
        }
        for (const glm::dvec2& beside : {glm::dvec2(0, 0), {0.05, 0.02}, {-0.1, 0.2}}) {
            std::array<double, kLanes> found{}, of_pairs{}, expected{};
            std::array<glm::dvec3, kLanes> middles;
            for (std::size_t i = 0; i < kLanes; ++i) {
                const glm::dvec3 viewer = lane(viewers, i);
                middles[i] = glm::normalize(glm::dvec3(-viewer.x + beside.x, -viewer.y + beside.y, viewer.z));
            }
            for (const SlopePart& part : slope_parts(row.lobe.distribution)) {
                const ReflectedNodes nodes(grids, row.lobe, part, viewers, pixels);
                for (std::size_t k = 0; k < nodes.count(); ++k) {
                    const ReflectedNode node = nodes.node(k);
                    for (std::size_t i = 0; i < kLanes; ++i)
                        found[i] += reflected(row.lobe, lane(viewers, i), node, lane(node.towards, i),
                                              middles[i], row.variance, i);
                }
                for (std::size_t k = 0; k < nodes.count(); k += 2) {
                    const ReflectedPair pair = nodes.pair(k / 2);
                    PairLight of_pair{};
                    for (std::size_t n = 0; n < 2; ++n) of_pair.brightness[n] = pair.nodes[n].weights;
                    const PairDirection at = nodes.direction_of(pair, of_pair);
                    for (std::size_t i = 0; i < kLanes; ++i)
                        for (const ReflectedNode& node : pair.nodes)
                            of_pairs[i] += static_cast<double>(at.factors[i]) *
                                           reflected(row.lobe, lane(viewers, i), node, lane(at.towards, i),
                                                     middles[i], row.variance, i);
                }
            }
            // Slopes at equal steps of probability, and places in the pixel.
            constexpr int turns = 48;
            const int rings = row.lobe.distribution == Distribution::ggx ? 400 : 40;
            const int places = row.pixel > 0 ? 4 : 1;
            for (std::size_t i = 0; i < kLanes; ++i) {
                const glm::dvec3 viewer = lane(viewers, i);
                for (int r = 0; r < rings; ++r)
                    for (int t = 0; t < turns; ++t) {
                        const double rest = (r + 0.5) / rings;  // probability of steeper slopes
                        const double steep = std::sqrt(
                            row.lobe.distribution == Distribution::ggx ? 1 / rest - 1 : -std::log(rest));
                        const double angle = 2 * pi * (t + 0.5 * (r % 2)) / turns;
                        const glm::dvec3 half =
                            glm::normalize(glm::dvec3(row.lobe.alpha.x * steep * std::cos(angle),
                                                      row.lobe.alpha.y * steep * std::sin(angle), 1));
                        if (!(glm::dot(viewer, half) > 0)) continue;
                        const glm::dvec3 towards = 2 * glm::dot(viewer, half) * half - viewer;
                        const double visible =
                            facet_visibility(row.lobe.distribution, row.lobe.alpha, towards);
                        for (int p = 0; p < places * places; ++p) {
                            const glm::dvec2 at((p % places + 0.5) / places - 0.5,
                                                (p / places + 0.5) / places - 0.5);
                            const glm::dvec3 seen = glm::normalize(towards + at.x * lane(pixels.steps[0], i) +
                                                                   at.y * lane(pixels.steps[1], i));
                            expected[i] += visible * light(seen, middles[i], row.variance, 0) /
                                           (rings * turns * places * places);
                        }
                    }
            }
            double largest = 0, wrong = 0;
            for (std::size_t i = 0; i < kLanes; ++i) {
                largest = std::max(largest, expected[i]);
                wrong =
                    std::max({wrong, std::abs(found[i] - expected[i]), std::abs(of_pairs[i] - expected[i])});
            }
            CAPTURES(beside.x, beside.y, largest, wrong);
            if (largest > 0.05) CHECK(wrong < row.tolerance * largest);
        }
    }
}

TEST_CASE("the pBRDF of a pair is evaluated where its light comes from") {
    LaneVectors viewers;
    for (std::size_t i = 0; i < kLanes; ++i)
        put(viewers, i, glm::vec3(direction(0.06 * static_cast<double>(i), 0.7 * static_cast<double>(i))));
    const Lobe lobe{{0.1, 0.3}, Distribution::ggx};
    const NodeGrids grids(32);
    const MirroredPixels pixels{};
    const ReflectedNodes nodes(grids, lobe, slope_parts(lobe.distribution).front(), viewers, pixels);
    const ReflectedPair pair = nodes.pair(1);
    for (const float part : {0.0F, 0.25F, 1.0F}) {
        PairLight light{};
        light.brightness[0].value.fill(1 - part);
        light.brightness[1].value.fill(part);
        for (std::size_t i = 0; i < kLanes; ++i) put(light.lean, i, {0.01F, -0.02F, 0});
        const PairDirection at = nodes.direction_of(pair, light);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::dvec3 one = lane(pair.nodes[0].towards, i), two = lane(pair.nodes[1].towards, i);
            const glm::dvec3 expected =
                glm::normalize(one + double{part} * (two - one) + glm::dvec3(0.01, -0.02, 0));
            CAPTURES(part, i);
            CHECK(glm::distance(lane(at.towards, i), expected) < 1e-6);
            const glm::dvec3 half = glm::normalize(expected + lane(viewers, i));
            const double inverse = facet_density(lobe.distribution, lobe.alpha, half) *
                                   facet_visibility(lobe.distribution, lobe.alpha, expected);
            CHECK(static_cast<double>(at.factors[i]) * inverse == doctest::Approx(1).epsilon(1e-4));
        }
    }
}

TEST_CASE("a mirror's nodes cover the pixel around its shifted middle") {
    LaneVectors viewers;
    MirroredPixels pixels;
    const glm::dvec3 viewer = direction(0.5, 0.3), mirrored(-viewer.x, -viewer.y, viewer.z);
    const Frame axes = frame_with_x(mirrored, {0, 0, 1});
    for (std::size_t i = 0; i < kLanes; ++i) {
        put(viewers, i, glm::vec3(viewer));
        put(pixels.shift, i, glm::vec3(0.01 * axes[0]));
        put(pixels.steps[0], i, glm::vec3(0.04 * axes[0]));
        put(pixels.steps[1], i, glm::vec3(0.02 * axes[1]));
    }
    const NodeGrids grids(32);
    const ReflectedNodes nodes(grids, 0, viewers, pixels);
    double total = 0;
    glm::dvec2 mean(0.0), squares(0.0);
    for (std::size_t k = 0; k < nodes.count(); ++k) {
        const ReflectedNode node = nodes.node(k);
        CHECK(glm::distance(lane(node.towards, 3), mirrored) < 1e-6);
        const auto weight = static_cast<double>(node.weights[3]);
        const glm::dvec3 seen = glm::normalize(lane(node.seen, 3));
        const glm::dvec2 at(glm::dot(axes[0], seen), glm::dot(axes[1], seen));
        total += weight;
        mean += weight * at;
        squares += weight * (at * at + static_cast<double>(node.variances[3]));
    }
    CHECK(total == doctest::Approx(1));
    CHECK(glm::distance(mean, glm::dvec2(0.01, 0)) < 1e-4);
    CHECK(squares.x - mean.x * mean.x == doctest::Approx(0.04 * 0.04 / 12).epsilon(0.02));
    CHECK(squares.y == doctest::Approx(0.02 * 0.02 / 12).epsilon(0.02));
}

TEST_CASE("the axes of the surface say nothing about a round lobe that is seen at a grazing angle") {
    // The same view at sixteen azimuths. Light beside the mirror direction shows how the lobe lies.
    constexpr double zenith = 1.4;
    const Lobe lobe{glm::dvec2(0.1), Distribution::beckmann};
    const NodeGrids grids(32);
    const MirroredPixels pixels{};
    LaneVectors viewers;
    for (std::size_t i = 0; i < kLanes; ++i)
        put(viewers, i, glm::vec3(direction(zenith, 2 * pi * static_cast<double>(i) / kLanes)));
    const ReflectedNodes nodes(grids, lobe, slope_parts(lobe.distribution).front(), viewers, pixels);
    for (const glm::dvec2& beside : {glm::dvec2(0, 0.04), {0.05, 0}, {0.1, 0.03}, {-0.1, 0.03}}) {
        std::array<double, kLanes> found{};
        for (std::size_t i = 0; i < kLanes; ++i) {
            const double azimuth = 2 * pi * static_cast<double>(i) / kLanes + pi;
            const glm::dvec3 middle = direction(zenith + beside.x, azimuth + beside.y);
            for (std::size_t k = 0; k < nodes.count(); ++k) {
                const ReflectedNode node = nodes.node(k);
                found[i] += reflected(lobe, lane(viewers, i), node, lane(node.towards, i), middle, 1e-3, i);
            }
        }
        CAPTURES(beside.x, beside.y);
        const auto [least, most] = std::ranges::minmax(found);
        CHECK(least > 0);
        CHECK(most < 1.02 * least);
    }
}

TEST_CASE("the one node of a mirror's narrow pixels is the node that all of them together have") {
    const NodeGrids grids(32);
    constexpr float narrowest = 0.01F;
    for (const double stretch : {0.0, 0.2, 1.0, 5.0}) {
        CAPTURE(stretch);
        LaneVectors viewers;
        MirroredPixels pixels;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const auto number = static_cast<double>(i);
            const glm::dvec3 viewer = direction(0.08 * number, 0.7 * number);
            const Frame axes = frame_with_x({-viewer.x, -viewer.y, viewer.z}, {0.1, 0.2, 1});
            const double size = 0.02 * number / (kLanes * std::max(1.0, stretch));
            put(viewers, i, glm::vec3(viewer));
            put(pixels.shift, i, glm::vec3(size * axes[0]));
            put(pixels.steps[0], i,
                glm::vec3(size * (axes[0] + 0.3 * number * axes[1]) / (1 + 0.3 * number)));
            put(pixels.steps[1], i, glm::vec3(size * stretch * (axes[1] - 0.2 * axes[0])));
        }
        ReflectedNode one;
        REQUIRE(mirror_node(narrowest, viewers, pixels, one) == 0xFFFF);
        const ReflectedNodes nodes(grids, narrowest, viewers, pixels);
        REQUIRE(nodes.count() == 1);
        const ReflectedNode of_all = nodes.node(0);
        for (std::size_t i = 0; i < kLanes; ++i) {
            CHECK(glm::distance(lane(one.towards, i), lane(of_all.towards, i)) < 1e-6);
            CHECK(glm::distance(lane(one.seen, i), lane(of_all.seen, i)) < 1e-6);
            CHECK(std::abs(one.variances[i] - of_all.variances[i]) <= 1e-3F * of_all.variances[i]);
            CHECK(one.weights[i] == of_all.weights[i]);
        }
        put(pixels.steps[1], 5, glm::vec3(0, 0.04F, 0));
        CHECK(mirror_node(narrowest, viewers, pixels, one) == (0xFFFF & ~(1U << 5U)));
    }
}
