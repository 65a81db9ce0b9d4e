// SPDX-License-Identifier: MIT
// Tests of rotating a separate light at every vertex into its frame and back.
#include "transfer/frame_rotation.hpp"
#include "harmonics/light_coefficients.hpp"
#include "material/brute_force.hpp"
#include "test.hpp"
#include "transfer/vertex_light.hpp"

using namespace nicol;

TEST_CASE("each lane's light goes into its own frame as one light alone would, and comes back") {
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    std::vector<glm::vec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
    while (normals.size() < kLanes)
        normals.push_back(glm::normalize(glm::vec3{normal(random), normal(random), normal(random)}));
    for (const LightKind kind : {LightKind::unpolarized, LightKind::linear, LightKind::full})
        for (const int order : {0, 1, 2, 4, 9, 16})
            for (const int channels : {1, 3, 5}) {
                CAPTURE(order);
                CAPTURE(channels);
                const LightLayout layout(order, kind);
                const FrameRotation rotation(layout);
                VertexLight lights(layout, channels, kLanes);
                VertexLight before(layout, channels, kLanes);
                VertexLight expected(layout, channels, kLanes);
                for (std::size_t i = 0; i < kLanes; ++i) {
                    const PshVector light = test::random_light(order, channels, static_cast<int>(kind),
                                                               static_cast<unsigned>(i) + 1);
                    VertexLight alone(layout, channels, 1);
                    Relight(layout, light).run(std::span(normals).subspan(i, 1), 0, 1, alone);
                    for (int c = 0; c < channels; ++c) {
                        const std::vector<double> numbers =
                            test::light_coefficients(layout, light.channel(c));
                        for (std::size_t k = 0; k < numbers.size(); ++k) {
                            before.block(0, c)[k][i] = static_cast<float>(numbers[k]);
                            lights.block(0, c)[k][i] = before.block(0, c)[k][i];
                            expected.block(0, c)[k][i] = alone.block(0, c)[k][0];
                        }
                    }
                }
                const auto difference = [&](const VertexLight& other) {
                    float largest = 0;
                    for (int c = 0; c < channels; ++c)
                        for (std::size_t k = 0; k < layout.size(); ++k)
                            for (std::size_t i = 0; i < kLanes; ++i)
                                largest = std::max(
                                    largest, std::abs(lights.block(0, c)[k][i] - other.block(0, c)[k][i]));
                    return largest;
                };
                rotation.into_frames(normals, lights, 0);
                CHECK(difference(expected) < 2e-5);
                rotation.into_world(normals, lights, 0);
                CHECK(difference(before) < 2e-5);
            }
}
