// SPDX-License-Identifier: MIT
// Visibility times light at vertices: every form equals the product of harmonics.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "material/brute_force.hpp"
#include "nicol/error.hpp"
#include "nicol/product.hpp"
#include "transfer/mirror_basis.hpp"
#include "transfer/shadow_product.hpp"

using namespace nicol;

namespace {

using Form = ShadowProduct::Form;

constexpr std::array kinds{LightKind::unpolarized, LightKind::linear, LightKind::full};

const DirectionSet& directions() {
    static const DirectionSet set(512);
    return set;
}

// Vertices that see what lies on one side of a random plane, here and there one that sees all.
struct Scene {
    explicit Scene(std::size_t vertices) : visibility(directions().size(), vertices) {
        std::mt19937 random(11);
        std::normal_distribution<float> normal;
        const auto direction = [&] {
            return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
        };
        for (std::size_t v = 0; v < vertices; ++v) {
            normals.push_back(v == 0 ? glm::vec3(0, 0, 1) : v == 1 ? glm::vec3(0, 0, -1) : direction());
            const glm::vec3 plane = direction();
            const float least = v % 5 == 2 ? -2.0F : 0.3F * normal(random);
            visibility.set_unoccluded(v, v % 5 == 2);
            for (std::size_t i = 0; i < directions().size(); ++i) {
                const glm::vec3& d = directions().directions()[i];
                if (glm::dot(d, normals[v]) > 0 && glm::dot(d, plane) > least) {
                    visibility.at(v)[i / 64] |= std::uint64_t{1} << (i % 64);
                }
            }
        }
    }
    [[nodiscard]] ShadowProduct product(const LightLayout& in, const LightLayout& out,
                                        HorizonExtension extension, Form form, ShadowStorage storage) const {
        return ShadowProduct(visibility, directions(), normals, in, out, extension, form, storage);
    }

    Visibility visibility;
    std::vector<glm::vec3> normals;
};

// Other light at every vertex.
PshVector light_at(std::size_t vertex, int order, int channels, LightKind kind) {
    return test::random_light(order, channels, static_cast<int>(kind), static_cast<unsigned>(vertex) + 1);
}

VertexLight vertex_lights(const LightLayout& layout, int channels, std::size_t vertices) {
    VertexLight out(layout, channels, vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        const PshVector light = light_at(v, layout.order(), channels, layout.kind());
        for (int c = 0; c < channels; ++c) {
            const auto packed = layout.pack(light.channel(c));
            for (std::size_t j = 0; j < packed.size(); ++j) {
                out.at(v, c)[j] = static_cast<float>(packed[j].real());
                out.at(v, c)[packed.size() + j] = static_cast<float>(packed[j].imag());
            }
        }
    }
    return out;
}

// The largest difference from the product of harmonics, in units of the largest coefficient.
double error_of(const Scene& scene, const LightLayout& in, const LightLayout& out, int channels,
                HorizonExtension extension, const VertexLight& have) {
    const VisibilityHarmonics harmonics(directions(), in.order() + out.order(), extension);
    PshProduct reference(in.order() + out.order(), in.order(), out.order());
    std::vector<float> v(psh_count(harmonics.order()));
    PshVector want(out.order(), 1);
    double error = 0;
    double largest = 0;
    for (std::size_t vertex = 0; vertex < scene.normals.size(); ++vertex) {
        harmonics.project(scene.visibility, vertex, scene.normals[vertex], v);
        const PshVector light = light_at(vertex, in.order(), channels, in.kind());
        for (int c = 0; c < channels; ++c) {
            reference.multiply(std::vector<double>(v.begin(), v.end()), light.channel(c), want.channel(0));
            const auto packed = out.pack(want.channel(0));
            for (std::size_t j = 0; j < packed.size(); ++j) {
                const std::complex<double> z(have.at(vertex, c)[j], have.at(vertex, c)[packed.size() + j]);
                error = std::max(error, std::abs(z - packed[j]));
                largest = std::max(largest, std::abs(packed[j]));
            }
        }
    }
    return error / largest;
}

}  // namespace

TEST_CASE("splitting light at the mirror plane and joining it leaves it unchanged") {
    for (const int order : {0, 1, 2, 5}) {
        for (const LightKind kind : kinds) {
            const LightLayout layout(order, kind);
            const MirrorBasis basis(layout);
            const VertexLight light = vertex_lights(layout, 1, kLanes);
            std::vector<Lanes> packed(basis.packed_size());
            for (std::size_t i = 0; i < kLanes; ++i) {
                for (std::size_t j = 0; j < packed.size(); ++j) packed[j][i] = light.at(i, 0)[j];
            }
            std::vector<Lanes> split(basis.size());
            std::vector<Lanes> joined(packed.size());
            basis.split(packed.data(), split.data());
            basis.join(split.data(), joined.data());
            float error = 0;
            for (std::size_t j = 0; j < packed.size(); ++j) {
                for (std::size_t i = 0; i < kLanes; ++i) {
                    error = std::max(error, std::abs(packed[j][i] - joined[j][i]));
                }
            }
            CHECK(error < 1e-6F);
        }
    }
}

TEST_CASE("the product at vertices is the product of harmonics, whatever its form") {
    const Scene scene(21);
    for (const auto& [low, high] : {std::array{0, 0}, std::array{1, 1}, std::array{1, 3}, std::array{4, 4},
                                    std::array{3, 4}, std::array{4, 8}, std::array{9, 9}}) {
        for (const LightKind kind : kinds) {
            const LightLayout in(low, kind);
            const LightLayout out(high, kind);
            const int channels = low == 4 ? 4 : 1;
            const VertexLight light = vertex_lights(in, channels, scene.normals.size());
            for (const auto& [extension, form] : {std::pair{HorizonExtension::mirrored, Form::matrix},
                                                  std::pair{HorizonExtension::mirrored, Form::grid},
                                                  std::pair{HorizonExtension::dark, Form::grid}}) {
                for (const ShadowStorage storage : {ShadowStorage::float32, ShadowStorage::fixed16}) {
                    const ShadowProduct product = scene.product(in, out, extension, form, storage);
                    CHECK(product.form() == form);
                    VertexLight result(out, channels, scene.normals.size());
                    product.copy(light, result, 0, scene.normals.size());
                    product.run(light, result, 0, product.blocks());
                    CAPTURE(low);
                    CAPTURE(high);
                    CAPTURE(static_cast<int>(form));
                    CAPTURE(static_cast<int>(extension));
                    const double error = error_of(scene, in, out, channels, extension, result);
                    CHECK(error < (storage == ShadowStorage::float32 ? 1e-6 : 2e-4));
                }
            }
        }
    }
}
