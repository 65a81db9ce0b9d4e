// SPDX-License-Identifier: MIT
// Tests of visibility times light at vertices: every form equals the product of harmonics.
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <numeric>

#include "harmonics/light_coefficients.hpp"
#include "harmonics/product.hpp"
#include "material/brute_force.hpp"
#include "test.hpp"
#include "transfer/visibility_product.hpp"
#include "visibility/even_irradiance.hpp"
#include "visibility/projected.hpp"

using namespace nicol;

namespace {

constexpr std::array kinds{LightKind::unpolarized, LightKind::linear, LightKind::full};

const DirectionSet& directions() {
    static const DirectionSet set(512);
    return set;
}

// Vertices that see the environment on one side of a random plane. Some see all of it.
struct Scene {
    explicit Scene(std::size_t vertices) : visibility(directions().size(), vertices) {
        std::mt19937 random(11);
        std::normal_distribution<float> normal;
        const auto direction = [&] {
            return glm::normalize(glm::vec3{normal(random), normal(random), normal(random)});
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
    [[nodiscard]] VisibilityProduct product(const LightLayout& layout) const {
        return VisibilityProduct(visibility, directions(), normals, layout);
    }

    Visibility visibility;
    std::vector<glm::vec3> normals;
};

// Returns a different light for every vertex.
PshVector light_at(std::size_t vertex, int order, int channels, LightKind kind) {
    return test::random_light(order, channels, static_cast<int>(kind), static_cast<unsigned>(vertex) + 1);
}

VertexLight vertex_lights(const LightLayout& layout, int channels, std::size_t vertices) {
    VertexLight out(layout, channels, vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        const PshVector light = light_at(v, layout.order(), channels, layout.kind());
        for (int c = 0; c < channels; ++c) {
            const std::vector<double> numbers = test::light_coefficients(layout, light.channel(c));
            for (std::size_t k = 0; k < numbers.size(); ++k)
                out.block(v / kLanes, c)[k][v % kLanes] = static_cast<float>(numbers[k]);
        }
    }
    return out;
}

std::vector<float> numbers_at(const VertexLight& light, std::size_t vertex, int channel) {
    std::vector<float> out;
    for (const Lanes& number : light.block(vertex / kLanes, channel)) out.push_back(number[vertex % kLanes]);
    return out;
}

// Returns the largest difference from the product of harmonics, relative to the largest coefficient.
double error_of(const Scene& scene, const LightLayout& layout, int channels, const VertexLight& have) {
    const int order = layout.order();
    const VisibilityHarmonics harmonics(directions(), 2 * order);
    PshProduct reference(2 * order, order, order);
    PshVector want(order, 1);
    const EvenIrradiance even(directions(), order);
    double error = 0;
    double largest = 0;
    for (std::size_t vertex = 0; vertex < scene.normals.size(); ++vertex) {
        std::vector<float> v =
            test::projected(harmonics, scene.visibility, scene.normals, static_cast<std::uint32_t>(vertex));
        even.restore(scene.visibility, vertex, scene.normals[vertex], v);
        const PshVector light = light_at(vertex, order, channels, layout.kind());
        for (int c = 0; c < channels; ++c) {
            reference.multiply(std::vector<double>(v.begin(), v.end()), light.channel(c), want.channel(0));
            const std::vector<double> numbers = test::light_coefficients(layout, want.channel(0));
            const auto got = have.block(vertex / kLanes, c);
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                error = std::max(error, std::abs(got[k][vertex % kLanes] - numbers[k]));
                largest = std::max(largest, std::abs(numbers[k]));
            }
        }
    }
    return error / largest;
}

}  // namespace

TEST_CASE("the product at vertices is the product of harmonics, by matrices and by the grid") {
    const Scene scene(21);
    for (const int order : {0, 1, 2, 3, 4, 6, 9, 10, 11}) {
        for (const LightKind kind : kinds) {
            const LightLayout layout(order, kind);
            const int channels = order == 4 ? 4 : 1;
            VertexLight light = vertex_lights(layout, channels, scene.normals.size());
            const VisibilityProduct product = scene.product(layout);
            CHECK((product.matrices() != nullptr) == (order <= 9));
            CHECK((product.grid() != nullptr) == (order > 9));
            product.run(light, 0, light.blocks());
            CAPTURE(order);
            CHECK(error_of(scene, layout, channels, light) < 2e-4);
        }
    }
}

TEST_CASE("unoccluded vertices keep their light, and blocks of them are not stored") {
    Scene scene(56);
    for (std::size_t v = 16; v < 32; ++v) scene.visibility.set_unoccluded(v, true);
    const LightLayout layout(4, LightKind::linear);
    const VisibilityProduct product = scene.product(layout);
    CHECK(product.blocks() == 3);
    CHECK(product.vertices().size() == 40);
    const VertexLight before = vertex_lights(layout, 2, 56);
    VertexLight light = vertex_lights(layout, 2, 56);
    product.run(light, 0, light.blocks());
    int shadowed = 0;
    for (std::size_t v = 0; v < 56; ++v) {
        float difference = 0;
        for (int c = 0; c < 2; ++c) {
            const std::vector<float> was = numbers_at(before, v, c);
            const std::vector<float> is = numbers_at(light, v, c);
            for (std::size_t j = 0; j < was.size(); ++j)
                difference = std::max(difference, std::abs(is[j] - was[j]));
        }
        if (scene.visibility.unoccluded(v)) CHECK(difference < 1e-5F);
        if (difference > 0.01F) ++shadowed;
    }
    CHECK(shadowed > 25);
    // No vertex is in shadow.
    for (std::size_t v = 0; v < 56; ++v) scene.visibility.set_unoccluded(v, true);
    const VisibilityProduct none = scene.product(layout);
    CHECK(none.blocks() == 0);
    CHECK(none.bytes() == 0);  // no block is stored
}

TEST_CASE("the product is the same to the last bit in place, in pieces and beside other threads") {
    const Scene scene(300);
    for (const int order : {3, 10}) {
        const LightLayout layout(order, LightKind::full);
        const VertexLight light = vertex_lights(layout, 1, 300);
        std::vector<VisibilityProduct> products;
        for (const int threads : {1, 2}) {
            tbb::task_arena(threads).execute([&] { products.push_back(scene.product(layout)); });
        }
        VertexLight whole = vertex_lights(layout, 1, 300);
        products[0].run(whole, 0, light.blocks());
        VertexLight pieces = vertex_lights(layout, 1, 300);
        tbb::parallel_for(std::size_t{0}, light.blocks(),
                          [&](std::size_t block) { products[1].run(pieces, block, block + 1); });
        bool same = true;
        for (std::size_t v = 0; v < 300; ++v)
            same = same && numbers_at(whole, v, 0) == numbers_at(pieces, v, 0);
        CHECK(same);
    }
}

TEST_CASE("coefficients that are computed on the way can be kept") {
    const Scene scene(70);
    const LightLayout layout(3, LightKind::unpolarized);
    const VisibilityHarmonics harmonics(directions(), 6);
    VisibilityBlocks kept(scene.visibility, 6);
    const VisibilityProduct product(scene.visibility, directions(), scene.normals, layout, {&kept, {}});
    VisibilityBlocks expected(scene.visibility, 6);
    std::vector<Lanes> lanes(5 * psh_count(6));
    std::vector<std::uint32_t> vertices(70);
    std::iota(vertices.begin(), vertices.end(), 0U);
    harmonics.project(scene.visibility, scene.normals, vertices, lanes);
    for (std::size_t first = 0; first < 70; first += kLanes)
        expected.set(std::span(vertices).subspan(first, std::min<std::size_t>(kLanes, 70 - first)),
                     &lanes[first / kLanes * psh_count(6)]);
    std::vector<float> one(psh_count(6));
    std::vector<float> other(psh_count(6));
    for (std::size_t v = 0; v < 70; ++v) {
        kept.expand(v, one);
        expected.expand(v, other);
        CHECK(one == other);
    }
    VisibilityBlocks short_one(scene.visibility, 4);
    CHECK_THROWS_AS(
        VisibilityProduct(scene.visibility, directions(), scene.normals, layout, {&short_one, {}}), Error);
}

TEST_CASE("only vertices that changed are computed anew") {
    constexpr std::uint32_t changed = 50, removed = 37;
    for (const int order : {3, 10}) {
        CAPTURE(order);
        const LightLayout layout(order, LightKind::full);
        const Scene before(100);
        Scene after(99);
        std::vector<std::uint32_t> former(99);
        for (std::uint32_t v = 0; v < 99; ++v) {
            former[v] = v < removed ? v : v + 1;
            after.normals[v] = before.normals[former[v]];
            std::ranges::copy(before.visibility.at(former[v]), after.visibility.at(v).begin());
            after.visibility.set_unoccluded(v, before.visibility.unoccluded(former[v]));
        }
        former[changed] = kNoVertex;
        std::ranges::fill(after.visibility.at(changed), 0U);
        after.visibility.set_unoccluded(changed, false);
        VisibilityBlocks kept(after.visibility, 2 * order);
        std::vector<std::uint8_t> missing(99, 1);
        const VisibilityProduct carried(before.product(layout), former, after.visibility, directions(),
                                        after.normals, {&kept, missing});
        for (std::uint32_t v = 0; v < 99; ++v) CHECK(missing[v] == (v == changed ? 0 : 1));
        VertexLight light = vertex_lights(layout, 1, 99), expected = vertex_lights(layout, 1, 99);
        carried.run(light, 0, light.blocks());
        after.product(layout).run(expected, 0, expected.blocks());
        for (std::size_t v = 0; v < 99; ++v) CHECK(numbers_at(light, v, 0) == numbers_at(expected, v, 0));
    }
}

TEST_CASE("vertices with large numbers make the unit grow, and those kept keep their product") {
    constexpr std::uint32_t vertices = 64, kept = 16;
    // More than twice as many coefficients as directions.
    const LightLayout layout(16, LightKind::linear);
    Scene after(vertices);
    for (std::size_t v = 0; v < kept; ++v) {  // these see everything, so that their numbers are about 1
        for (std::size_t i = 0; i < directions().size(); ++i)
            if (glm::dot(directions().directions()[i], after.normals[v]) > 0)
                after.visibility.at(v)[i / 64] |= std::uint64_t{1} << (i % 64);
        after.visibility.set_unoccluded(v, false);
    }
    Scene before = after;
    std::vector<std::uint32_t> former(vertices, kNoVertex);
    std::iota(former.begin(), former.begin() + kept, 0U);
    for (std::size_t v = kept; v < vertices; ++v) {
        std::ranges::fill(before.visibility.at(v), std::uint64_t{0});
        before.visibility.set_unoccluded(v, false);
    }
    VisibilityProduct small = before.product(layout);
    CHECK(small.unit() == 1);
    const VisibilityProduct carried(std::move(small), former, after.visibility, directions(), after.normals);
    const VisibilityProduct expected = after.product(layout);
    CHECK(expected.unit() > 1);
    CHECK(carried.unit() == expected.unit());
    const VertexLight given = vertex_lights(layout, 1, vertices);
    VertexLight light = vertex_lights(layout, 1, vertices), of_all = vertex_lights(layout, 1, vertices);
    carried.run(light, 0, light.blocks());
    expected.run(of_all, 0, of_all.blocks());
    float difference = 0, largest = 0, from_given = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::vector<float> whole = numbers_at(given, v, 0);
        const std::vector<float> have = numbers_at(light, v, 0), want = numbers_at(of_all, v, 0);
        for (std::size_t k = 0; k < want.size(); ++k) {
            difference = std::max(difference, std::abs(have[k] - want[k]));
            largest = std::max(largest, std::abs(want[k]));
            if (v < kept) from_given = std::max(from_given, std::abs(have[k] - whole[k]));
        }
    }
    CHECK(difference < 1e-4F * largest);
    CHECK(from_given < 1e-3F * largest);
}

TEST_CASE("blocks of vertices that are not needed are left out until they are") {
    const LightLayout layout(3, LightKind::full);
    const Scene scene(100);
    std::vector<std::uint8_t> needed(100, 0), computed(100);
    const auto needs = [&](std::size_t v) { needed[v / kLanes * kLanes] = 1; };
    std::vector<std::uint32_t> former(100);
    VisibilityBlocks kept(scene.visibility, 6, needed);
    kept.find_computed(computed);
    const auto occluded = static_cast<std::size_t>(std::ranges::find(computed, 0) - computed.begin());
    CHECK(occluded < computed.size());
    CHECK(kept.block(occluded / kLanes) == nullptr);
    VisibilityProduct product(scene.visibility, directions(), scene.normals, layout, {}, needed);
    const std::size_t nothing = product.bytes();
    for (const std::size_t v : {occluded, std::size_t{99}}) {
        needs(v);
        for (std::uint32_t i = 0; i < 100; ++i) former[i] = computed[i] != 0 ? i : kNoVertex;
        std::vector<std::uint8_t> missing;
        kept = VisibilityBlocks(std::move(kept), former, scene.visibility, 6, missing, needed);
        product = VisibilityProduct(std::move(product), former, scene.visibility, directions(), scene.normals,
                                    {&kept, missing}, needed);
        CHECK(std::ranges::count(missing, 1) == 0);
        product.find_computed(computed);
        for (std::size_t i = 0; i < 100; ++i) CHECK((computed[i] != 0 || needed[i / kLanes * kLanes] == 0));
    }
    CHECK(product.bytes() > nothing);
    VisibilityBlocks all(scene.visibility, 6);
    const VisibilityProduct expected(scene.visibility, directions(), scene.normals, layout, {&all, {}});
    VertexLight light = vertex_lights(layout, 1, 100), of_all = vertex_lights(layout, 1, 100);
    expected.run(of_all, 0, of_all.blocks());
    for (std::size_t block = 0; block < light.blocks(); ++block) {
        if (computed[block * kLanes] == 0) continue;
        product.run(light, block, block + 1);
        for (std::size_t v = block * kLanes; v < std::min<std::size_t>(100, (block + 1) * kLanes); ++v)
            CHECK(numbers_at(light, v, 0) == numbers_at(of_all, v, 0));
        CHECK((kept.block(block) == nullptr) == (all.block(block) == nullptr));
    }
    CHECK_INVALID(VisibilityProduct(scene.visibility, directions(), scene.normals, layout, {},
                                    std::span(needed).first(99)));
}

TEST_CASE("what does not fit together is refused") {
    const Scene scene(3);
    const LightLayout low(2, LightKind::linear);
    CHECK_INVALID(scene.product(LightLayout(33, LightKind::linear)));
    const std::vector<glm::vec3> few(2, {0, 0, 1});
    CHECK_INVALID(VisibilityProduct(scene.visibility, directions(), few, low));
    CHECK_INVALID(VisibilityProduct(scene.visibility, DirectionSet(256), scene.normals, low));
}
