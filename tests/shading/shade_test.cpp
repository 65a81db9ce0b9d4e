// SPDX-License-Identifier: MIT
#include "shading/shade.hpp"
#include "directions.hpp"
#include "harmonics/light_coefficients.hpp"
#include "harmonics/rotation.hpp"
#include "material/brute_force.hpp"
#include "material/chiral_material.hpp"
#include "test.hpp"
#include "transfer/vertex_light.hpp"

using namespace nicol;

namespace {

std::vector<glm::vec3> test_normals() {
    std::vector<glm::vec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    while (normals.size() < 37) {
        normals.push_back(glm::normalize(glm::vec3{normal(random), normal(random), normal(random)}));
    }
    return normals;
}

}  // namespace

TEST_CASE("relight rotates the light into each vertex's frame, poles and odd block sizes included") {
    const auto normals = test_normals();
    for_all({0, 1, 4, 9, 32}, {LightKind::unpolarized, LightKind::linear, LightKind::full},
            [&](int order, LightKind kind) {
                const LightLayout layout(order, kind);
                const PshVector light = test::random_light(order, 2, static_cast<int>(kind), 5);
                VertexLight out(layout, 2, normals.size());
                Relight(layout, light).run(normals, 0, out.blocks(), out);
                double error = 0;
                for (std::size_t v = 0; v < normals.size(); ++v) {
                    const Frame frame = theta_phi_frame(glm::dvec3(normals[v]));
                    const PshVector local = rotated(light, glm::transpose(frame));
                    for (int c = 0; c < 2; ++c) {
                        const std::vector<double> expected =
                            test::light_coefficients(layout, local.channel(c));
                        const auto have = out.block(v / kLanes, c);
                        for (std::size_t j = 0; j < expected.size(); ++j)
                            error = std::max(error, std::abs(have[j][v % kLanes] - expected[j]));
                    }
                }
                CAPTURE(order);
                CHECK(error < 1e-6 * (4 + order));
            });
}

TEST_CASE("relight and shade equal the reflection integral in the angular domain, in the camera's frame") {
    const auto normals = test_normals();
    const std::vector<glm::vec3> positions(normals.size(), glm::vec3(0.3F, -0.2F, 0.1F));
    const std::vector<std::uint8_t> visible(normals.size(), 1);
    const MaterialPtr plastic =
        pplastic({.diffuse_reflectance = {0.5, 0.2}, .alpha = 0.4, .distribution = Distribution::ggx});
    for_all({plastic, test::chiral(plastic)}, {LightKind::unpolarized, LightKind::linear, LightKind::full},
            [&](const MaterialPtr& material, LightKind kind) {
                const LightLayout layout(4, kind);
                const PshVector light = test::random_light(4, 2, static_cast<int>(kind), 9);
                VertexLight local(layout, 2, normals.size());
                Relight(layout, light).run(normals, 0, local.blocks(), local);
                const ResponseTable table(*material, layout, 2);
                for (const bool orthographic : {false, true}) {
                    Viewpoint view;
                    view.orthographic = orthographic;
                    view.eye = {4, 3, 2};
                    view.forward = glm::normalize(glm::dvec3(-4, -3, -2));
                    view.right = glm::normalize(glm::cross(view.forward, glm::dvec3(0, 1, 0)));
                    view.up = glm::cross(view.right, view.forward);
                    std::vector<glm::vec4> red(normals.size(), glm::vec4(-7));
                    std::vector<glm::vec4> green(normals.size(), glm::vec4(-7));
                    const std::vector<std::span<glm::vec4>> out{red, green};
                    Shade(layout).run(table, local, view, positions, normals, visible, 0, normals.size(),
                                      out);
                    int seen = 0;
                    for (std::size_t v = 0; v < normals.size(); ++v) {
                        const glm::dvec3 normal(normals[v]);
                        const glm::dvec3 towards = view.towards(glm::dvec3(positions[v]));
                        if (glm::dot(normal, towards) < 0.05) continue;
                        ++seen;
                        // Any frame about the normal is valid.
                        const Frame surface = frame_with_x(normal, {0.6, 0.7, -0.5});
                        for (int c = 0; c < 2; ++c) {
                            Stokes expected = test::reflected(*material, c, light, surface, towards, 64, 128);
                            // x of the camera's frame is ray x up, computed independently.
                            const glm::dvec3 x = glm::normalize(glm::cross(-towards, view.up));
                            const Frame camera(x, glm::cross(towards, x), towards);
                            expected = rotated(expected, angle_between(theta_phi_frame(towards), camera));
                            const glm::vec4 got = out[static_cast<std::size_t>(c)][v];
                            CHECK(glm::distance(glm::dvec4(got), expected) < 1e-4);
                        }
                    }
                    CHECK(seen > 10);
                }
            });
}

TEST_CASE("straight above and below the camera the frame is still a frame") {
    Viewpoint view;
    for (const glm::dvec3 d : {view.up, -view.up}) {
        const Frame f = view.frame(d);
        CHECK(glm::distance(f[0], view.right) < 1e-12);
        CHECK(glm::distance(glm::cross(f[0], f[1]), d) < 1e-12);
    }
    // At the middle of the image x points right and y up.
    const Frame middle = view.frame(-view.forward);
    CHECK(glm::distance(middle[0], view.right) < 1e-12);
    CHECK(glm::distance(middle[1], view.up) < 1e-12);
}
