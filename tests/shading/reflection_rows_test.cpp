// SPDX-License-Identifier: MIT
// Tests of reflection as rows over the incident light.
#include "shading/reflection_rows.hpp"
#include "harmonics/light_coefficients.hpp"
#include "material/brute_force.hpp"
#include "material/chiral_material.hpp"
#include "shading/shade.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr std::size_t kPoints = 11;
constexpr int kOrder = 3;

/// Points that a camera sees under various angles.
struct Points {
    std::vector<glm::vec3> positions, normals;
    Viewpoint view{
        .eye = {4, 3, 2}, .forward = glm::normalize(glm::dvec3(-4, -3, -2)), .up = {0, 0, 1}, .right = {}};

    Points() {
        view.right = glm::normalize(glm::cross(view.forward, view.up));
        view.up = glm::cross(view.right, view.forward);
        for (std::size_t i = 0; i < kPoints; ++i) {
            const auto x = static_cast<float>(i);
            positions.emplace_back(0.2F * std::sin(x), 0.1F * x, 0.3F);
            normals.push_back(glm::normalize(glm::vec3(1, 0.9F * std::sin(3 * x), std::cos(2 * x))));
        }
    }
};

// Returns the largest difference between products of rows with a light and Shade's Stokes vectors.
double difference(const Points& points, std::span<const ResponseTable* const> layers,
                  std::span<const LayerWeights> weights, const LightLayout& tables, LightKind kind) {
    const LightLayout layout(kOrder, kind);
    const PshVector light = test::random_light(kOrder, 2, static_cast<int>(kind), 9);
    // Shade takes light with all components of the tables.
    VertexLight local(tables, 2, kPoints);
    PshVector all(kOrder, 2);
    std::ranges::copy(light.data(), all.data().begin());
    Relight(tables, all).run(points.normals, 0, local.blocks(), local);
    std::vector<glm::vec4> red(kPoints), green(kPoints);
    const std::vector<std::span<glm::vec4>> out{red, green};
    if (weights.empty())
        Shade(tables, 4).run(*layers[0], local, points.view, points.positions, points.normals,
                             std::vector<std::uint8_t>(kPoints, 1), 0, kPoints, out);
    else
        Shade(tables, 4).run(layers, weights, local, points.view, points.positions, points.normals, out);

    const ReflectionRows rows(tables, kind, 4);
    VertexLight factors;
    double largest = 0;
    for (std::size_t c = 0; c < 2; ++c) {
        rows.run(layers, weights, c, points.view, points.positions, points.normals, factors);
        const std::vector<double> numbers =
            test::light_coefficients(layout, light.channel(static_cast<int>(c)));
        for (std::size_t i = 0; i < kPoints; ++i)
            for (std::size_t p = 0; p < 4; ++p) {
                double sum = 0;
                for (std::size_t j = 0; j < numbers.size(); ++j)
                    sum += numbers[j] * double{factors.row(i)[p * numbers.size() + j]};
                largest = std::max(largest, std::abs(sum - double{out[c][i][static_cast<glm::length_t>(p)]}));
            }
    }
    return largest;
}

}  // namespace

TEST_CASE("rows times light are the Stokes vectors that shading makes of the light") {
    const Points points;
    const MaterialPtr plastic =
        pplastic({.diffuse_reflectance = {0.5, 0.2}, .alpha = 0.4, .distribution = Distribution::ggx});
    for_all({plastic, test::chiral(plastic)}, {LightKind::linear, LightKind::full},
            [&](const MaterialPtr& material, LightKind kind) {
                const LightLayout layout(kOrder, kind);
                const ResponseTable table(*material, layout, 2);
                const std::array layers{&table};
                CHECK(difference(points, layers, {}, layout, kind) < 2e-5);
                CHECK(difference(points, layers, {}, layout, LightKind::unpolarized) < 2e-5);
            });
}

TEST_CASE("rows of layers are summed by the layers' weights") {
    const Points points;
    const MaterialPtr plastic =
        pplastic({.diffuse_reflectance = {0.5, 0.2}, .alpha = 0.4, .distribution = Distribution::ggx});
    const LightLayout layout(kOrder, LightKind::linear);
    const ResponseTable first(*plastic, layout, 2), second(*test::chiral(plastic), layout, 2);
    const std::array layers{&first, &second};
    std::vector<LayerWeights> weights(2);
    for (std::size_t l = 0; l < 2; ++l) {
        weights[l].points = 0xFFFF;
        weights[l].equal = l == 0;
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < kLanes; ++i)
                weights[l].value[c][i] = 0.1F * static_cast<float>(1 + l + 2 * c + i);
    }
    CHECK(difference(points, layers, weights, layout, LightKind::linear) < 2e-5);
}
