// SPDX-License-Identifier: MIT
#include "transfer/dense.hpp"
#include "harmonics/evaluate.hpp"
#include "harmonics/light_coefficients.hpp"
#include "harmonics/rotation.hpp"
#include "material/brute_force.hpp"
#include "material/chiral_material.hpp"
#include "material/conductor.hpp"
#include "material/material_projection.hpp"
#include "shading/shade.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

const std::vector<glm::vec3> normals{{0, 0, 1},
                                     {0, 0, -1},
                                     {0, 1, 0},
                                     glm::normalize(glm::vec3(1, -2, 3)),
                                     glm::normalize(glm::vec3(-3, 1, -0.2F))};

std::vector<double> some_visibility(int order, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> visibility(psh_count(order));
    for (double& v : visibility) v = normal(random);
    return visibility;
}

/// Applies the steps one after another in double precision: rotation into the vertex's frame, shadow,
/// material.
PshVector reflected(const PshVector& light, const Frame& frame, const CoefficientMatrix* shadow,
                    const std::vector<IsotropicMatrix>& material) {
    PshVector local = rotated(light, glm::transpose(frame));
    PshVector out(light.order(), light.channels());
    std::vector<double> shadowed(local.channel(0).size());
    for (int c = 0; c < light.channels(); ++c) {
        std::ranges::copy(local.channel(c), shadowed.begin());
        if (shadow != nullptr) shadow->apply(local.channel(c), shadowed);
        material[material.size() == 1 ? 0 : static_cast<std::size_t>(c)].apply(shadowed, out.channel(c));
    }
    return out;
}

std::vector<IsotropicMatrix> matrices(const Material& material, int order) {
    std::vector<IsotropicMatrix> out;
    for (int c = 0; c < material.channels(); ++c) out.push_back(project_material(material, c, order));
    return out;
}

}  // namespace

TEST_CASE("a dense matrix is rotation, shadow and material one after another") {
    const MaterialPtr coloured = pplastic({.diffuse_reflectance = {0.6, 0.2}, .alpha = 0.3});
    const MaterialPtr metal = rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.3});
    for (const MaterialPtr& material : {coloured, metal, test::chiral(metal), diffuse({0.5})}) {
        for (const int order : {0, 1, 4, 5}) {
            const std::vector<IsotropicMatrix> channels = matrices(*material, order);
            const auto shadows = std::make_shared<const ShadowMatrix>(2 * order, order, order);
            const std::vector<double> visibility = some_visibility(2 * order, 3);
            const CoefficientMatrix shadow = shadows->expand(visibility);
            for (const LightKind kind : {LightKind::unpolarized, LightKind::linear, LightKind::full}) {
                const PshVector light = test::random_light(order, 2, static_cast<int>(kind), 17);
                const auto shared = std::make_shared<const DenseMaterial>(channels, kind);
                DenseTransfer transfer(shared, normals.size());
                DenseBuilder builder(shared, shadows);
                for (std::size_t v = 0; v < normals.size(); ++v) {
                    builder.build(normals[v], v == 2 ? std::span<const double>{} : visibility,
                                  transfer.at(v));
                }
                VertexLight out(shared->outgoing(), 2, normals.size() + 1);
                transfer.apply(light, 0, normals.size(), 1, out);
                double error = 0;
                for (std::size_t v = 0; v < normals.size(); ++v) {
                    const PshVector expected = reflected(light, theta_phi_frame(glm::dvec3(normals[v])),
                                                         v == 2 ? nullptr : &shadow, channels);
                    const LightLayout& outgoing = shared->outgoing();
                    const auto components = static_cast<std::size_t>(outgoing.kind());
                    for (int c = 0; c < 2; ++c) {
                        const auto numbers = test::light_coefficients(outgoing, expected.channel(c));
                        const auto got = out.block((v + 1) / kLanes, c);
                        for (std::size_t j = 0; j < numbers.size(); ++j)
                            error = std::max(error, std::abs(got[j][(v + 1) % kLanes] - numbers[j]));
                        // Components that the material cannot produce must be zero.
                        for (std::size_t i = 0; i < expected.channel(c).size(); ++i)
                            if (i % 4 >= components)
                                error = std::max(error, std::abs(expected.channel(c)[i]));
                    }
                }
                CAPTURES(order, kind);
                CHECK(error < 2e-6 * (1 + order) * (1 + order));
            }
        }
    }
}

TEST_CASE("depolarizing materials and unpolarized light make small matrices") {
    const auto plain = DenseMaterial(matrices(*diffuse({0.5}), 4), LightKind::unpolarized);
    CHECK(plain.outgoing().kind() == LightKind::unpolarized);
    CHECK(plain.columns().size() == 25);
    const auto plastic = DenseMaterial(matrices(*pplastic({}), 4), LightKind::linear);
    CHECK(plastic.columns().size() == 25 + 2 * 21);
    const auto metal =
        DenseMaterial(matrices(*rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0.3}), 4), LightKind::linear);
    CHECK(metal.outgoing().kind() == LightKind::full);
}

TEST_CASE("outgoing coefficients are evaluated at the view direction, in the camera's frame") {
    const int order = 6;
    const PshVector field = test::random_light(order, 2, 4, 5);
    for (const LightKind kind : {LightKind::unpolarized, LightKind::linear, LightKind::full}) {
        const LightLayout layout(order, kind);
        VertexLight light(layout, 2, normals.size());
        for (std::size_t v = 0; v < normals.size(); ++v) {
            for (int c = 0; c < 2; ++c) {
                const auto numbers = test::light_coefficients(layout, field.channel(c));
                for (std::size_t j = 0; j < numbers.size(); ++j)
                    light.block(v / kLanes, c)[j][v % kLanes] = static_cast<float>(numbers[j]);
            }
        }
        Viewpoint view;
        view.eye = {2, 3, 4};
        const std::vector<glm::vec3> positions(normals.size(), glm::vec3(0.2F, -0.1F, 0.3F));
        const std::vector<std::uint8_t> visible{1, 1, 0, 1, 1};
        std::vector<glm::vec4> first(normals.size(), glm::vec4(-7));
        std::vector<glm::vec4> second(normals.size(), glm::vec4(-7));
        const std::vector<std::span<glm::vec4>> out{first, second};
        Shade(layout).run(ResponseTable::of_outgoing_light(layout), light, view, positions, normals, visible,
                          0, normals.size(), out);
        CHECK(first[2] == glm::vec4(-7));
        int seen = 0;
        for (std::size_t v = 0; v < normals.size(); ++v) {
            const glm::dvec3 towards = view.towards(glm::dvec3(positions[v]));
            if (visible[v] == 0 || glm::dot(glm::dvec3(normals[v]), towards) < 0.02) continue;
            ++seen;
            const Frame surface = theta_phi_frame(glm::dvec3(normals[v]));
            const Frame from = surface * theta_phi_frame(glm::transpose(surface) * towards);
            for (int c = 0; c < 2; ++c) {
                Stokes expected = rotated(evaluate(field, c, glm::transpose(surface) * towards),
                                          angle_between(from, view.frame(towards)));
                for (int p = static_cast<int>(kind); p < 4; ++p) expected[p] = 0;
                CHECK(glm::distance(glm::dvec4(out[static_cast<std::size_t>(c)][v]), expected) < 2e-5);
            }
        }
        CHECK(seen >= 2);
    }
}
