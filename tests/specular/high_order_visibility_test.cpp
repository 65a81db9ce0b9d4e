// SPDX-License-Identifier: MIT
#include "specular/high_order_visibility.hpp"

#include <numeric>

#include "harmonics/order_gains.hpp"
#include "harmonics/scalar_harmonics.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Returns vertices whose visibility has these coefficients.
VisibilityBlocks seen_of(std::span<const double> coefficients, int order, std::size_t vertices) {
    static const DirectionSet set(DirectionSet::kFewest);
    VisibilityBlocks out(Visibility(set.size(), vertices), order);
    std::vector<Lanes> lanes(coefficients.size());
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i].value.fill(static_cast<float>(coefficients[i]));
    for (std::uint32_t v = 0; v < vertices; ++v) out.set(std::array{v}, lanes.data());
    return out;
}

/// Returns the visible fractions of a vertex with normal z, for a lobe about d.
glm::vec2 at(const HighOrderVisibility& fraction, const VisibilityBlocks& seen, const glm::vec3& d) {
    Viewpoint view;
    view.orthographic = true;
    view.forward = glm::dvec3(-d.x, -d.y, d.z);
    const glm::vec3 position(0);
    const glm::vec3 normal(0, 0, 1);
    const std::uint8_t visible = 1;
    glm::vec2 out(7);
    fraction.run(view, {&position, 1}, {&normal, 1}, {&visible, 1}, seen, 0, 1, {&out, 1});
    return out;
}

}  // namespace

TEST_CASE("unoccluded lobes are visible as a whole, and occluded ones are dark") {
    constexpr int order = 8;
    const auto all = test::project_scalar(order, [](const glm::dvec3&) { return 1.0; });
    const std::vector<double> none(psh_count(order));
    const HighOrderVisibility fraction(order, 0.2);
    for (const double theta : {0.0, 0.4, 1.0, 1.5}) {
        const glm::vec3 d(std::sin(theta) * 0.6, std::sin(theta) * 0.8, -std::cos(theta));
        const glm::vec2 unoccluded = at(fraction, seen_of(all, order, 1), d);
        CHECK(unoccluded[0] == doctest::Approx(1).epsilon(1e-3));
        CHECK(unoccluded[1] == doctest::Approx(1).epsilon(1e-3));
        CHECK(at(fraction, seen_of(none, order, 1), d) == glm::vec2(0));
    }
}

TEST_CASE("the fraction is the visibility filtered by the lobe, and by the cosine about the normal") {
    // A wall on the +x side blocks light that travels towards -x.
    constexpr int order = 12;
    const auto wall = test::project_scalar(order, [](const glm::dvec3& d) { return d.x < 0 ? 0.0 : 1.0; });
    const HighOrderVisibility fraction(order, 0.3);
    const VisibilityBlocks seen = seen_of(wall, order, 1);
    const OrderGains lobe = gaussian_gains(0.3, 0, order);
    double before = -1;
    for (const double x : {-0.9, -0.4, -0.1, 0.0, 0.1, 0.4, 0.9}) {
        const glm::dvec3 d(x, 0.3 * std::sqrt(1 - x * x), -std::sqrt(0.91 * (1 - x * x)));
        const std::vector<double> scalar = test::scalar_harmonics(order, d);
        double expected = 0;
        for (int l = 0; l <= order; ++l)
            for (int m = -l; m <= l; ++m)
                expected +=
                    lobe[static_cast<std::size_t>(l)] * wall[psh_index(l, m)] * scalar[psh_index(l, m)];
        const glm::vec2 found = at(fraction, seen, glm::vec3(d));
        CHECK(found[0] == doctest::Approx(std::clamp(expected, 0.0, 1.0)).epsilon(1e-4));
        CHECK(found[0] >= before - 1e-3);
        CHECK(found[1] == doctest::Approx(0.5).epsilon(1e-3));
        before = found[0];
    }
    CHECK(before > 0.98);
}

TEST_CASE("every vertex is evaluated along its mirrored view direction") {
    constexpr int order = 12;
    const auto wall = test::project_scalar(order, [](const glm::dvec3& d) { return d.x < 0 ? 0.0 : 1.0; });
    const HighOrderVisibility fraction(order, 0.2);
    // All vertices have the same wall in their frames, whose axes are theta-hat and phi-hat.
    const std::vector<glm::vec3> normals{{1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
    const VisibilityBlocks visibility = seen_of(wall, order, normals.size());
    const std::vector<glm::vec3> positions(normals.size(), glm::vec3(0));
    const std::vector<std::uint8_t> visible{1, 0, 1, 1};
    std::vector<glm::vec2> out(normals.size(), glm::vec2(7));
    Viewpoint view;
    // theta-hat is -z at the equator, so light from below z = 0 travels upwards, against theta-hat.
    view.eye = {5, 0, 5};
    fraction.run(view, positions, normals, visible, visibility, 0, 3, out);
    CHECK(out[0][0] < 0.1F);
    CHECK(out[1] == glm::vec2(7));
    CHECK(out[2][0] < 0.1F);
    CHECK(out[3] == glm::vec2(7));
    view.eye = {5, 0, -5};
    fraction.run(view, positions, normals, visible, visibility, 0, 4, out);
    CHECK(out[0][0] > 0.9F);
    CHECK(out[3][0] > 0.9F);
    CHECK(out[0][1] == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("coefficients are kept small, where they are not known beforehand") {
    constexpr int order = 8;
    constexpr std::size_t vertices = 40;
    const DirectionSet set(DirectionSet::kFewest);
    const VisibilityHarmonics harmonics(set, order);
    Visibility visibility(set.size(), vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        visibility.set_unoccluded(v, v != 3 && v < 32);
        for (std::uint64_t& word : visibility.at(v)) word = 0x0123456789ABCDEF * (v + 1);
    }
    VisibilityBlocks blocks(visibility, order);
    const std::vector<glm::vec3> normals(vertices, glm::vec3(0, 0.6F, 0.8F));
    std::vector<Lanes> lanes(3 * psh_count(order));
    std::vector<std::uint32_t> all(vertices);
    std::iota(all.begin(), all.end(), 0U);
    harmonics.project(visibility, normals, all, lanes);
    VisibilityBlocks before(visibility, order);
    for (VisibilityBlocks* const each : {&blocks, &before})
        for (std::size_t first = 0; first < vertices; first += kLanes)
            each->set(std::span(all).subspan(first, std::min(kLanes, vertices - first)),
                      &lanes[first / kLanes * psh_count(order)]);
    CHECK(blocks.block(0) != nullptr);
    CHECK(blocks.block(1) == nullptr);
    CHECK(blocks.block(2) != nullptr);
    constexpr std::size_t numbers = 45;
    CHECK(blocks.bytes() == 2 * numbers * kLanes * 2);
    std::vector<float> found(psh_count(order));
    for (std::size_t v = 0; v < vertices; ++v) {
        blocks.expand(v, found);
        for (std::size_t i = 0; i < found.size(); ++i)
            CHECK(std::abs(found[i] - lanes[v / kLanes * psh_count(order) + i][v % kLanes]) < 5.5e-5F);
    }
    std::vector<std::uint32_t> former(vertices, kNoVertex);
    for (std::uint32_t i = 0; i < kLanes && 32 + i < vertices; ++i)
        former[32 + i] = (i % 2 == 0 ? 0 : 32) + (3 * i + 5) % (i % 2 == 0 ? 16 : 8);
    std::vector<std::uint8_t> missing;
    const VisibilityBlocks after(std::move(before), former, visibility, order, missing);
    for (std::size_t v = 0; v < vertices; ++v) CHECK(missing[v] == (v < kLanes ? 1 : 0));
    for (std::size_t i = 0; i < numbers * kLanes; ++i) {
        const std::uint32_t vertex = former[std::min<std::size_t>(32 + i % kLanes, vertices - 1)];
        CHECK(after.block(2)[i] == blocks.block(vertex / kLanes)[i / kLanes * kLanes + vertex % kLanes]);
    }
    CHECK(after.block(0)[0] == 0);
    // Unoccluded vertices are not dimmed in either kind of block.
    const std::vector<std::uint8_t> visible(vertices, 1);
    std::vector<glm::vec2> out(vertices);
    HighOrderVisibility(order, 0.2)
        .run(Viewpoint{.eye = {1, 2, 3}}, std::vector<glm::vec3>(vertices, glm::vec3(0)), normals, visible,
             blocks, 0, vertices, out);
    CHECK(out[20] == glm::vec2(1));
    CHECK(out[5][0] == doctest::Approx(1).epsilon(2e-4));
    CHECK(out[5][1] == doctest::Approx(1).epsilon(2e-4));
    CHECK(out[3][1] < 0.9F);
}

TEST_CASE("orders and widths are checked") {
    CHECK_THROWS_AS(HighOrderVisibility(65, 0.1), Error);
    CHECK_THROWS_AS(HighOrderVisibility(-1, 0.1), Error);
    CHECK_THROWS_AS(HighOrderVisibility(8, -0.1), Error);
    CHECK_NOTHROW(HighOrderVisibility(0, 0));
}
