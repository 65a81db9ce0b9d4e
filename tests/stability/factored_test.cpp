// SPDX-License-Identifier: MIT
// Tests of low orders: relight and shade in floats against doubles.
#include "material/conductor.hpp"
#include "shading/shade.hpp"
#include "stability/double_transfer.hpp"
#include "stability/lights.hpp"
#include "test.hpp"
#include "transfer/vertex_light.hpp"
#include "transfer/visibility_product.hpp"

using namespace nicol;

namespace {

const DirectionSet& directions() {
    static const DirectionSet set(512);
    return set;
}

std::vector<std::vector<glm::vec4>> shaded(const test::Vertices& vertices, const PshVector& light,
                                           const LightLayout& layout, const ResponseTable& response) {
    const std::size_t count = vertices.normals.size();
    VertexLight local(layout, light.channels(), count);
    Relight(layout, light).run(vertices.normals, 0, local.blocks(), local);
    VisibilityProduct(vertices.visibility, directions(), vertices.normals, layout)
        .run(local, 0, local.blocks());
    std::vector<std::vector<glm::vec4>> out(static_cast<std::size_t>(light.channels()),
                                            std::vector<glm::vec4>(count));
    const std::vector<std::span<glm::vec4>> channels(out.begin(), out.end());
    Shade(layout).run(response, local, vertices.view, vertices.positions, vertices.normals, vertices.visible,
                      0, count, channels);
    return out;
}

// Bound for sums of some hundred products with terms rounded a few times to 2^-24, ten thousand times below
// the truncation error of low orders.
constexpr double bound = 2e-6;
// Bound for shadow matrices stored in 16 bits, whose numbers are off by up to 3.1e-5, 25 in a row of order 4.
constexpr double fixed_bound = 4e-4;

struct Worst {
    double floats = 0;
    double shadows = 0;  // with shadows in 16 bits, as the renderer stores them
};

double compare(const test::Vertices& vertices, const LightLayout& layout, const test::Lights& lights,
               const std::vector<MaterialPtr>& materials, double allowed) {
    std::vector<PshVector> fields;
    std::vector<ResponseTable> responses;
    for (const auto& [name, light] : lights) fields.push_back(light);
    for (const MaterialPtr& material : materials)
        responses.emplace_back(*material, layout, fields[0].channels());
    const auto truth = test::shaded_in_double(vertices, directions(), layout, fields, responses);
    double worst = 0;
    std::size_t image = 0;
    for (const auto& [name, light] : lights) {
        CAPTURE(name);
        for (const ResponseTable& response : responses) {
            const test::Deviation d =
                test::deviation(vertices, shaded(vertices, light, layout, response), truth[image++], allowed);
            CHECK(d.finite);
            CHECK(d.largest > 0);
            CHECK(d.worst < allowed);
            CHECK(d.negative == 0);
            worst = std::max(worst, d.worst);
        }
    }
    return worst;
}

// Compares with the given occlusion, then with all vertices unoccluded.
Worst compare(test::Vertices vertices, const LightLayout& layout, const test::Lights& lights,
              const std::vector<MaterialPtr>& materials) {
    Worst worst;
    worst.shadows = compare(vertices, layout, lights, materials, fixed_bound);
    for (std::size_t v = 0; v < vertices.normals.size(); ++v) vertices.visibility.set_unoccluded(v, true);
    worst.floats = compare(vertices, layout, lights, materials, bound);
    return worst;
}

const std::vector<MaterialPtr>& materials() {
    static const std::vector<MaterialPtr> some{
        pplastic({.alpha = 0.05, .distribution = Distribution::ggx}),
        rough_conductor({.eta = metal_index("Au"), .alpha = 0.2, .distribution = Distribution::ggx}),
        diffuse({0.5})};
    return some;
}

}  // namespace

TEST_CASE("low orders: floats stay with doubles, under any light, at any size and order") {
    struct Row {
        const char* name;
        int order;
        LightKind kind;
        test::Vertices vertices;
        test::Lights lights;
        std::vector<MaterialPtr> materials;
    };
    const auto random = [](int order, int channels, int components, unsigned seed) -> test::Lights {
        return {{"random light", test::random_light(order, channels, components, seed)}};
    };
    const std::vector<MaterialPtr> plastic{pplastic({.alpha = 0.3})};
    const auto full = LightKind::full;
    const test::Vertices vertices(directions()), few(directions(), 1, 0);
    for (const Row& row : std::vector<Row>{
             {"usual lights", 4, full, vertices, test::usual_lights(4), materials()},
             {"usual lights", 9, full, vertices, test::usual_lights(9), materials()},
             {"stress lights", 4, full, vertices, test::stress_lights(4), materials()},
             {"small", 4, full, test::Vertices(directions(), 1e-6, 0), random(4, 3, 4, 1), materials()},
             {"large", 4, full, test::Vertices(directions(), 1e6, 0), random(4, 3, 4, 1), materials()},
             // These are the highest orders rendered with full detail.
             {"high", 16, LightKind::linear, few, random(16, 1, 3, 5), plastic},
             {"high", 32, LightKind::linear, few, random(32, 1, 3, 5), plastic}}) {
        CAPTURES(row.name, row.order);
        const Worst worst =
            compare(row.vertices, LightLayout(row.order, row.kind), row.lights, row.materials);
        MESSAGE(row.name << ", order " << row.order << ": worst " << worst.floats << " of the largest value, "
                         << worst.shadows << " with shadows of 16 bits");
    }
}
