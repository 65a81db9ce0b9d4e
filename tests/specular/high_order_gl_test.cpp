// SPDX-License-Identifier: MIT
// glsl/high_order.glsl against the CPU.
#include "directions.hpp"
#include "gl/buffer.hpp"
#include "gl/contexts.hpp"
#include "gl/draw.hpp"
#include "material/brute_force.hpp"
#include "material/conductor.hpp"
#include "specular/convolution_kernel.hpp"
#include "specular/high_order_light.hpp"
#include "specular/high_order_scene.hpp"
#include "test.hpp"

namespace nicol::gl {
[[nodiscard]] std::span<const ShaderSource> specular_test_shaders();
}

using namespace nicol;
using namespace nicol::gl;

namespace {

constexpr int l_low = 4;
constexpr int l_high = 32;
constexpr double tolerance = 1e-5;  // of the largest component

/// A vertex as the shader reads it.
struct Point {
    glm::vec4 normal;
    glm::vec4 view;
    glm::vec4 fraction;
};

/// All views of a surface: any, head-on, grazing, and from behind.
std::vector<Point> test_points() {
    std::vector<Point> points;
    std::mt19937 random(7);
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> uniform(0, 1);
    const auto direction = [&] {
        return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
    };
    while (points.size() < 400) {
        const glm::vec3 n = direction();
        glm::vec3 v = direction();
        if (points.size() == 1) v = n;
        if (points.size() == 2) v = -n;
        if (points.size() == 3) v = glm::normalize(glm::cross(n, v));
        if (points.size() > 20 && glm::dot(n, v) < 0) v = -v;
        points.push_back(
            {glm::vec4(n, 0), glm::vec4(v, 0), glm::vec4(uniform(random), uniform(random), 0, 0)});
    }
    return points;
}

/// The same texels for the shader. A map that is not used is replaced by one that is.
Texture2D texture(const std::shared_ptr<Context>& context, const LobeMap* map, int channels) {
    const int layers = map->polarized() ? 2 * channels : 1;
    return Texture2D(context, {.width = map->columns(), .height = layers * map->rows()},
                     map->layers_apart(0, layers));
}

void compare(const std::shared_ptr<Context>& context, const HighOrderFactors& factors,
             const HighOrderMaps& maps, int channels) {
    const std::vector<Point> points = test_points();
    const auto up = glm::normalize(glm::vec3(0.2F, 1, -0.1F));
    const HighOrder high(factors, maps, some_rotation());
    std::vector<std::vector<glm::vec4>> expected(static_cast<std::size_t>(channels));
    double largest = 0;
    for (const Point& point : points) {
        Viewpoint view;
        view.orthographic = true;
        view.forward = -glm::dvec3(point.view);
        view.up = up;
        const auto stokes =
            test::look_up(high, view, glm::vec3(point.normal), glm::vec2(point.fraction), expected.size());
        for (std::size_t c = 0; c < expected.size(); ++c) {
            expected[c].push_back(stokes[c]);
            for (int p = 0; p < 4; ++p)
                largest = std::max(largest, static_cast<double>(std::abs(stokes[c][p])));
        }
    }

    const bool polarized = maps.central->polarized();
    std::vector<Define> defines{{"CHANNELS", std::to_string(channels)}};
    if (polarized) defines.push_back({"HIGH_ORDER_POLARIZED"});
    Program program =
        Program::graphics(context, embedded_shader("fullscreen.vert"), specular_test_shaders()[0], defines);
    program.set("to_light", glm::mat3(glm::transpose(some_rotation())));
    program.set("up", up);
    program.set("spread", static_cast<float>(factors.spread()));
    const Texture2D table(
        context,
        {.width = HighOrderFactors::kAngles,
         .height = polarized ? HighOrderFactors::kElements : HighOrderFactors::kUnpolarized},
        factors.texels(0, channels, polarized));
    const Texture2D central = texture(context, maps.central, channels);
    const Texture2D outer = texture(context, maps.outer != nullptr ? maps.outer : maps.central, channels);
    const Texture2D base = texture(context, maps.base != nullptr ? maps.base : maps.central, channels);
    table.bind(0);
    central.bind(1);
    outer.bind(2);
    base.bind(3);
    std::vector<Point> drawn = points;
    if (maps.base == nullptr)
        for (Point& point : drawn) point.fraction.y = 0;
    const Buffer buffer(context, BufferUse::storage, std::as_bytes(std::span(drawn)));
    buffer.bind_storage(0);
    RenderTarget target(context, {static_cast<int>(points.size()), 1, channels, false});
    draw_fullscreen(target, program);
    double worst = 0;
    for (std::size_t c = 0; c < expected.size(); ++c) {
        std::vector<float> pixels(4 * points.size());
        target.read(static_cast<int>(c), pixels);
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (int p = 0; p < 4; ++p) {
                const float found = pixels[4 * i + static_cast<std::size_t>(p)];
                REQUIRE(std::isfinite(found));
                worst = std::max(worst, static_cast<double>(std::abs(found - expected[c][i][p])));
            }
        }
    }
    CHECK(largest > 0);
    CHECK(worst < tolerance * largest);
}

/// As of nature: the power of an order falls with its square.
PshVector natural_light(int channels, int components) {
    PshVector light = test::random_light(l_high, channels, components, 6);
    std::vector<double> gains;
    for (int l = 0; l <= l_high; ++l) gains.push_back(1 / std::sqrt(l + 1.0));
    scale_orders(light, gains);
    return light;
}

}  // namespace

TEST_CASE("shaders look up high orders as the CPU does, split and convolved") {
    const MaterialPtr gold = rough_conductor({.eta = metal_index("Au"), .alpha = 0.15});
    const MaterialPtr grey = pplastic({.alpha = 0.3});
    const HighOrderFactors coloured(*gold, l_low, l_high, 3);
    const HighOrderFactors colourless(*grey, l_low, l_high, 1);
    HighOrderLight plain(natural_light(3, 1), l_low, l_high, false);
    HighOrderLight full(natural_light(3, 4), l_low, l_high, true);
    HighOrderLight single(natural_light(1, 4), l_low, l_high, true);
    HighOrderLight four(natural_light(4, 1), l_low, l_high, false);
    const HighOrderFactors mirror = HighOrderFactors::mirror();
    const LobeMap convolved = convolved_map(natural_light(3, 1), mirrored_kernels(*gold, 9, 3), l_low, 9);
    on_every_backend([&](const std::shared_ptr<Context>& context) {
        context->run([&] {
            compare(context, coloured, plain.maps(coloured), 3);
            compare(context, coloured, full.maps(coloured), 3);
            compare(context, colourless, single.maps(colourless), 1);
            compare(context, colourless, four.maps(colourless), 4);
            compare(context, mirror, {.central = &convolved}, 3);
        });
    });
}
