// SPDX-License-Identifier: MIT
// Tests of local lights: sums over their light samples.
#include "shading/light_source.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <set>

#include "directions.hpp"
#include "function_texture.hpp"
#include "geometry/mesh.hpp"
#include "geometry/ray_scene.hpp"
#include "light/environment.hpp"
#include "shading/extracted_source.hpp"
#include "shading/light_samples.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr double kPi = std::numbers::pi;

LaneVectors lanes(const glm::vec3& v) {
    LaneVectors out;
    out.x.value.fill(v.x);
    out.y.value.fill(v.y);
    out.z.value.fill(v.z);
    return out;
}

/// Returns the mean irradiance over many light samples at a surface point with this normal: the Stokes vector
/// of a channel, in frames with the light's x.
Stokes irradiance(const LightSource& source, const glm::vec3& point, const glm::dvec3& normal,
                  std::uint32_t samples = 4096, std::size_t channel = 0, std::uint32_t seed = 17) {
    const std::uint32_t seeds[] = {seed};
    LaneLight light;
    Stokes sum(0.0);
    for (std::uint32_t k = 0; k < samples; ++k) {
        Lanes u, v;
        light_samples(k, seeds, u, v);
        source.sample(lanes(point), u, v, light);
        const double cosine =
            normal.x * light.towards.x[3] + normal.y * light.towards.y[3] + normal.z * light.towards.z[3];
        if ((light.points >> 3 & 1) == 0 || cosine <= 0) continue;
        for (std::size_t p = 0; p < light.components; ++p)
            sum[static_cast<glm::length_t>(p)] += cosine * light.irradiance[channel][p][3];
    }
    return sum / static_cast<double>(samples);
}

/// Returns the irradiance at the origin by a polygon of radiance 1 (Lambert 1760).
double of_polygon(const std::vector<glm::dvec3>& corners, const glm::dvec3& normal) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::normalize(corners[i]);
        const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()]);
        sum += std::acos(glm::dot(a, b)) * glm::dot(glm::normalize(glm::cross(a, b)), normal);
    }
    return std::abs(sum) / 2;
}

using Triangles = std::vector<std::array<glm::vec3, 3>>;

/// Computes the irradiance from rays in a cone about `axis` that hit the light.
Stokes irradiance_of_rays(const LightSource& source, const glm::vec3& point, const glm::dvec3& normal,
                          const glm::dvec3& axis, double angle) {
    constexpr int groups = 20000;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(0, 1);
    const Frame frame = theta_phi_frame(glm::normalize(axis));
    LaneLight light;
    LaneVectors directions;
    bool all_before = true;
    Stokes sum(0.0);
    for (int n = 0; n < groups; ++n) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const double cosine = 1 - number(random) * (1 - std::cos(angle));
            const double sine = std::sqrt(1 - cosine * cosine), phi = 2 * kPi * number(random);
            put(directions, i,
                glm::vec3(frame * glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine)));
        }
        source.intersect(lanes(point), directions, light);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::dvec3 towards(light.towards.x[i], light.towards.y[i], light.towards.z[i]);
            if ((light.points >> i & 1) == 0 || glm::dot(normal, towards) <= 0) continue;
            all_before = all_before && light.distance[i] > 0;
            for (std::size_t p = 0; p < light.components; ++p)
                sum[static_cast<glm::length_t>(p)] +=
                    glm::dot(normal, towards) * static_cast<double>(light.irradiance[0][p][i]);
        }
    }
    CHECK(all_before);
    return 2 * kPi * (1 - std::cos(angle)) / (groups * double{kLanes}) * sum;
}

}  // namespace

TEST_CASE("samples of a light are stratified") {
    for (const std::uint32_t seed : {0U, 1U, 0xDEADBEEFU}) {
        const std::uint32_t seeds[] = {seed};
        for (const int across : {16, 4, 1}) {
            std::set<int> boxes;
            for (std::uint32_t k = 0; k < 16; ++k) {
                Lanes u, v;
                light_samples(k, seeds, u, v);
                CHECK(u[0] < 1);
                CHECK(v[0] < 1);
                boxes.insert(static_cast<int>(u[0] * static_cast<float>(across)) * 16 +
                             static_cast<int>(v[0] * 16 / static_cast<float>(across)));
            }
            CHECK(boxes.size() == 16);
        }
    }
    CHECK(sample_seed(1, 2) != sample_seed(2, 1));
}

TEST_CASE("a disc of the sky sheds its irradiance on a surface that faces it") {
    for (const double radius : {0.0, 0.0047, 0.3, 1.5}) {
        CAPTURE(radius);
        const LightSourcePtr sun =
            light_source(LocalLight{.kind = LocalLight::Kind::directional,
                                    .value = {3, 2},
                                    .to_world = glm::rotate(glm::dmat4(1), 0.7, {1, 2, 3}),
                                    .angular_radius = radius},
                         glm::dmat4(1));
        CHECK(sun->angular_radius({1, 2, 3}) == static_cast<float>(radius));
        const glm::dvec3 towards = -glm::dvec3(glm::rotate(glm::dmat4(1), 0.7, {1, 2, 3})[2]);
        CHECK(irradiance(*sun, {1, 2, 3}, towards)[0] == doctest::Approx(3).epsilon(5e-4));
        CHECK(irradiance(*sun, {1, 2, 3}, towards, 4096, 1)[0] == doctest::Approx(2).epsilon(5e-4));
    }
}

TEST_CASE("points, spots and projectors fall off with distance and angle") {
    const double cutoff = 0.5, width = 0.3;
    const LocalLight point{.value = {8}};
    const LocalLight spot{
        .kind = LocalLight::Kind::spot, .value = {8}, .cutoff_angle = cutoff, .beam_width = width};
    const LocalLight projector{.kind = LocalLight::Kind::projector, .value = {8}, .fov = 1, .aspect = 2};
    const auto at = [](double angle) { return 2.0 * glm::dvec3(std::sin(angle), 0, std::cos(angle)); };
    struct {
        const LocalLight& light;
        glm::dvec3 place;
        double expected;
    } const table[] = {
        {point, at(2), 2},        {spot, at(0), 2},
        {spot, at(0.29), 2},      {spot, at(-0.4), 1},
        {spot, at(0.51), 0},      {spot, at(kPi), 0},
        {projector, at(0), 2},    {projector, at(0.4), 2 / std::pow(std::cos(0.4), 3)},
        {projector, at(0.51), 0}, {projector, {0, 2 * std::tan(0.25) * 1.2, 2}, 0},
        {projector, at(3), 0},
    };
    for (const auto& row : table) {
        CAPTURES(row.place.x, row.place.z);
        const LightSourcePtr source = light_source(row.light, glm::translate(glm::dmat4(1), {1, 2, 3}));
        CHECK(source->angular_radius({1, 2, 3}) == 0);
        CHECK(irradiance(*source, glm::vec3(row.place + glm::dvec3(1, 2, 3)), glm::normalize(-row.place),
                         1)[0] == doctest::Approx(row.expected).epsilon(1e-5));
    }
}

TEST_CASE("emissive surfaces are Lambert's polygons") {
    const glm::vec3 a(-1, -1, 2), b(1, -1, 2.5), c(1, 1, 2.5), d(-1, 1, 2);
    const Triangles quad{{a, c, b}, {a, d, c}};  // faces the origin
    const Triangles away{{a, b, c}, {a, c, d}};
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, 0.1, 1));
    const double expected = of_polygon({a, b, c, d}, normal);
    Emission emission{.radiance = {2}, .state = {.dolp = 0.6, .aolp = 0.2}};
    const LightSourcePtr one = light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = quad});
    CHECK(one->angular_radius({0, 0, 0}) == doctest::Approx(std::asin(std::sqrt(2.0625) / 2.25)));
    const Stokes got = irradiance(*one, {0, 0, 0}, normal);
    CHECK(got[0] == doctest::Approx(2 * expected).epsilon(2e-3));
    CHECK(got[1] == doctest::Approx(2 * expected * 0.6 * std::cos(0.4)).epsilon(2e-3));
    CHECK(got[2] == doctest::Approx(2 * expected * 0.6 * std::sin(0.4)).epsilon(2e-3));

    CHECK(irradiance(*light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = away}), {0, 0, 0},
                     normal)[0] == 0);
    emission.two_sided = true;
    CHECK(irradiance(*light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = away}), {0, 0, 0},
                     normal)[0] == doctest::Approx(2 * expected).epsilon(2e-3));
    CHECK(light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = {{a, a, b}}}) == nullptr);
}

TEST_CASE("a polygon close to a point sheds its light by few samples") {
    const glm::dvec3 up(0, 0, 1);
    for (const double height : {0.5, 0.1, 0.02, 1e-3}) {
        for (const double aside : {0.0, 0.9, 1.1}) {
            CAPTURES(height, aside);
            const glm::vec3 a(-1 + aside, -1, height), b(1 + aside, -1, height), c(1 + aside, 1, height),
                d(-1 + aside, 1, height);
            const double expected = of_polygon({a, b, c, d}, up);
            const Emission emission{.radiance = {1}};
            // The corner beyond the edge that both share makes the second no parallelogram.
            const LightSourcePtr sources[] = {
                light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = {{a, c, b}, {a, d, c}}}),
                light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = {{b, a, c}, {a, d, c}}})};
            for (const LightSourcePtr& source : sources) {
                double error2 = 0;
                constexpr std::uint32_t tries = 40;
                for (std::uint32_t seed = 0; seed < tries; ++seed) {
                    const double got = irradiance(*source, {0, 0, 0}, up, 16, 0, 1234567 * seed)[0];
                    error2 += (got / expected - 1) * (got / expected - 1) / tries;
                }
                CHECK(std::sqrt(error2) < 0.15);
                CHECK(irradiance(*source, {0, 0, 0}, up)[0] == doctest::Approx(expected).epsilon(0.01));
            }
        }
    }
}

TEST_CASE("two triangles that make a parallelogram are one, by few places") {
    const glm::vec3 a(-1, -0.5, 2), b(1, -0.5, 2.5), c(1, 1, 3), d(-1, 1, 2.5), e(-1.5, 1, 2.375);
    struct Case {
        const char* name;
        Triangles triangles;
        std::vector<glm::dvec3> outline;
        bool few;
    };
    for (const Case& given : {Case{"as cut", {{a, c, b}, {a, d, c}}, {a, b, c, d}, true},
                              Case{"turned", {{c, b, a}, {d, c, a}}, {a, b, c, d}, true},
                              Case{"by the other diagonal", {{d, b, a}, {b, d, c}}, {a, b, c, d}, true},
                              Case{"no parallelogram", {{a, c, b}, {a, e, c}}, {a, b, c, e}, false}}) {
        CAPTURE(given.name);
        const Emission emission{.radiance = {1}};
        const LightSourcePtr source =
            light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = given.triangles});
        const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, 0.1, 1));
        const double expected = of_polygon(given.outline, normal);
        double square = 0;
        for (std::uint32_t seed = 0; seed < 64; ++seed)
            square += std::pow(
                irradiance(*source, {0, 0, 0}, normal, 16, 0, sample_seed(seed, 0))[0] / expected - 1, 2);
        CHECK(std::sqrt(square / 64) < (given.few ? 0.01 : 0.05));
        CHECK(irradiance(*source, {0, 0, 0}, normal)[0] == doctest::Approx(expected).epsilon(2e-3));
    }
}

TEST_CASE("a texture of one value needs no texture coordinates") {
    const Emission emission{.radiance = {3}, .texture = constant_texture(glm::vec4(0.5F), 1)};
    const glm::vec3 a(-1, -1, 2), b(1, -1, 2), c(1, 1, 2), d(-1, 1, 2);
    const Triangles square{{a, d, c}, {a, c, b}};
    const LightSourcePtr source =
        light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = square});
    const double expected = of_polygon({a, b, c, d}, {0, 0, 1});
    CHECK(irradiance(*source, {0, 0, 0}, {0, 0, 1})[0] == doctest::Approx(1.5 * expected).epsilon(2e-3));
    LaneLight light;
    source->intersect(lanes({0, 0, 0}), lanes({0, 0, 1}), light);
    REQUIRE(light.points == 0xFFFF);
    CHECK(light.irradiance[0][0][5] == doctest::Approx(1.5));
}

TEST_CASE("emissive spheres shed the light of the cone that they fill, by few places") {
    const Mesh ball = make_sphere({1, 2, 5}, 0.5);
    Triangles triangles, inwards, half;
    for (const glm::uvec3& t : ball.triangles) {
        const glm::vec3 a = ball.positions[t.x], b = ball.positions[t.y], c = ball.positions[t.z];
        triangles.push_back({a, b, c});
        inwards.push_back({a, c, b});
        if (a.z < 5) half.push_back({a, b, c});
    }
    const Emission emission{.radiance = {2}, .state = {.dolp = 0.5}};
    const auto at = [&](const Triangles& of, std::uint32_t samples) {
        const LightSourcePtr source =
            light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = of});
        return irradiance(*source, {0, 0, 0}, glm::normalize(glm::dvec3(1, 2, 5)), samples);
    };
    const double expected = 2 * kPi * 0.25 / 30;  // pi L (r / d)^2
    CHECK(at(triangles, 4)[0] == doctest::Approx(expected).epsilon(3e-3));
    CHECK(at(triangles, 4)[1] == doctest::Approx(0.5 * expected).epsilon(3e-3));
    CHECK(at(inwards, 4096)[0] > 0);  // from the far side of the sphere
    CHECK(at(inwards, 4096)[0] == doctest::Approx(expected).epsilon(0.02));
    CHECK(at(half, 4096)[0] == doctest::Approx(expected).epsilon(0.05));

    const LightSourcePtr source =
        light_source({.emission = emission, .axis = {1, 0, 0}, .triangles = triangles});
    LaneLight light;
    Lanes middle;
    middle.value.fill(0.4F);
    source->sample(lanes({0, 0, 0}), middle, middle, light);
    const glm::dvec3 place =
        double{light.distance[0]} * glm::dvec3(light.towards.x[0], light.towards.y[0], light.towards.z[0]);
    CHECK(glm::distance(place, glm::dvec3(1, 2, 5)) == doctest::Approx(0.5).epsilon(1e-2));
    source->sample(lanes({1, 2, 5.1F}), middle, middle, light);
    CHECK(light.points == 0);  // inside the sphere
}

TEST_CASE("frames of polarized light have the axis across the light") {
    const LocalLight lamp{.value = {1}, .state = {.dolp = 1, .axis = {1, 2, 0.5}}};
    const LightSourcePtr source = light_source(lamp, glm::dmat4(1));
    for (const glm::vec3& at : {glm::vec3(1, 0, 0), glm::vec3(0.3F, -2, 1), glm::vec3(1, 2, 0.5F)}) {
        LaneLight light;
        source->sample(lanes(at), {}, {}, light);
        const Frame expected = polarization_frame(lamp.state.axis, glm::normalize(glm::dvec3(at)));
        const glm::dvec3 x(light.x.x[5], light.x.y[5], light.x.z[5]);
        CHECK(glm::length(x - expected[0]) < 1e-5);
    }
}

TEST_CASE("however bright and near a light is, what reaches a point is finite") {
    const Emission bright{.radiance = {kBrightestLight}};
    const Triangles small{{glm::vec3(0), glm::vec3(1e-20F, 0, 0), glm::vec3(0, 1e-20F, 0)}};
    const Triangles large{{glm::vec3(0), glm::vec3(1e15F, 0, 0), glm::vec3(0, 1e15F, 0)}};
    std::vector<LightSourcePtr> sources;
    for (const double value : {1e-20, 1.0, kBrightestLight})
        sources.push_back(light_source(LocalLight{.value = {value, 0}}, glm::dmat4(1)));
    for (const Triangles& triangles : {small, large})
        sources.push_back(light_source({.emission = bright, .axis = {1, 0, 0}, .triangles = triangles}));
    for (const LightSourcePtr& source : sources) {
        for (const float distance : {0.0F, 1e-30F, 1e-15F, 1.0F, 1e15F}) {
            CAPTURE(distance);
            LaneLight light;
            Lanes middle;
            middle.value.fill(0.25F);
            source->sample(lanes({0, 0, distance}), middle, middle, light);
            const float got = light.irradiance[0][0][2];
            CHECK(std::isfinite(got));
            CHECK(got >= 0);
            CHECK(got <= 1.001F * static_cast<float>(kBrightestLight));
        }
    }
}

TEST_CASE("a sphere of few triangles does not hide its own light") {
    Mesh ball = make_cube(8);
    for (glm::vec3& p : ball.positions) p = glm::vec3(0.1F, 0, 2) + 0.8F * glm::normalize(p);
    const RaySurface surface{.positions = ball.positions, .triangles = ball.triangles};
    const RayScene rays(std::span(&surface, 1));
    Triangles triangles;
    for (const glm::uvec3& t : ball.triangles)
        triangles.push_back({ball.positions[t.x], ball.positions[t.y], ball.positions[t.z]});
    const Emission emission{};
    const LightSourcePtr sphere = light_source({emission, {1, 0, 0}, triangles, {}});
    const std::uint32_t seeds[] = {5};
    LaneLight light;
    for (std::uint32_t k = 0; k < 1024; ++k) {
        Lanes u, v;
        light_samples(k, seeds, u, v);
        sphere->sample(lanes({0, 0, 0}), u, v, light);
        const glm::dvec3 towards(light.towards.x[0], light.towards.y[0], light.towards.z[0]);
        const double distance = light.distance[0];
        CHECK_FALSE(rays.occluded({.direction = glm::normalize(towards), .farthest = distance}));
        CHECK(distance > 1.1);
    }
}

TEST_CASE("what rays meet of a light adds up to what its places shed") {
    const glm::vec3 a(-1, -1, 2), b(1, -1, 2.5), c(1, 1, 2.5), d(-1, 1, 2);
    const Triangles quad{{a, c, b}, {a, d, c}};  // faces the origin
    const Triangles away{{a, b, c}, {a, c, d}};
    const PolarizationState state{.dolp = 0.6, .aolp = 0.2, .docp = 0.3};
    const TexturePtr slope =
        test::texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x, 0, 0, 1); });
    const Emission plain{.radiance = {2}, .state = state};
    const Emission textured{.radiance = {2}, .texture = slope, .state = state};
    const Emission two_sided{.radiance = {2}, .two_sided = true, .state = state};
    const std::vector<std::array<glm::vec2, 3>> texcoords{{{{0, 0}, {1, 1}, {1, 0}}},
                                                          {{{0, 0}, {0, 1}, {1, 1}}}};
    Triangles sphere;
    const Mesh ball = make_sphere({0.2, 0.1, 3}, 0.8);
    for (const glm::uvec3& t : ball.triangles)
        sphere.push_back({ball.positions[t.x], ball.positions[t.y], ball.positions[t.z]});
    std::vector<float> pixels;
    for (int i = 0; i < 15; ++i) {
        const float s0 = i % 4 == 0 ? 0.0F : static_cast<float>(i);
        pixels.insert(pixels.end(), {s0, 0.5F * s0, -0.3F * s0, 0.2F * s0});
    }
    // The lamp crosses the seam of the image.
    const auto lamp = std::make_shared<const ExtractedLight>(
        EquirectWindow{.width = 64, .height = 33, .top = 9, .left = 62, .rows = 2, .columns = 4}, 1, pixels);
    const glm::dmat3 axes(glm::rotate(glm::dmat4(1), 0.7, {1, 2, 3}));
    struct Row {
        const char* name;
        LightSourcePtr source;
        glm::dvec3 axis;  ///< axis of a cone that contains the light
        double angle;
    };
    std::vector<Row> rows;
    rows.push_back({"quad", light_source({plain, {1, 0, 0}, quad, {}}), {0, 0, 1}, 0.9});
    rows.push_back({"textured", light_source({textured, {1, 0, 0}, quad, texcoords}), {0, 0, 1}, 0.9});
    // Colours of the corners that are the texture's values there.
    const std::vector<std::array<glm::vec3, 3>> colors{{{{0, 0, 0}, {1, 1, 1}, {1, 1, 1}}},
                                                       {{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}}}};
    const Emission colored{
        .radiance = {2}, .texture = mesh_color_texture(ColorsOf::vertices), .state = state};
    rows.push_back({"two-sided", light_source({two_sided, {1, 0, 0}, away, {}}), {0, 0, 1}, 0.9});
    rows.push_back({"sphere", light_source({plain, {1, 0, 0}, sphere, {}}), {0.2, 0.1, 3}, 0.35});
    rows.push_back({"disc",
                    light_source(LocalLight{.kind = LocalLight::Kind::directional,
                                            .value = {3},
                                            .to_world = glm::rotate(glm::dmat4(1), kPi - 0.3, {0, 1, 0}),
                                            .angular_radius = 0.2,
                                            .state = state},
                                 glm::dmat4(1)),
                    {0, 0, 1},
                    0.6});
    rows.push_back(
        {"lamp", std::make_unique<const ExtractedSource>(lamp, axes, 3), axes * lamp->centre(), 0.4});
    rows.push_back({"coloured", light_source({colored, {1, 0, 0}, quad, {}, colors}), {0, 0, 1}, 0.9});
    for (int p = 0; p < 4; ++p)
        CHECK(irradiance(*rows.back().source, {0, 0, 0}, {0, 0, 1})[p] ==
              doctest::Approx(irradiance(*rows[1].source, {0, 0, 0}, {0, 0, 1})[p]).epsilon(1e-6));
    for (const Row& row : rows) {
        CAPTURE(row.name);
        const glm::dvec3 normal = glm::normalize(row.axis + glm::dvec3(0.2, 0.1, 0));
        const Stokes expected = irradiance(*row.source, {0, 0, 0}, normal);
        const Stokes got = irradiance_of_rays(*row.source, {0, 0, 0}, normal, row.axis, row.angle);
        CHECK(expected[0] > 0.05);
        for (int p = 0; p < 4; ++p)
            CHECK(got[p] == doctest::Approx(expected[p]).epsilon(0.01).scale(expected[0]));
    }
    // A back-facing light emits nothing towards the point, and a point light cannot be hit.
    LaneLight light;
    light_source({plain, {1, 0, 0}, away, {}})->intersect(lanes({0, 0, 0}), lanes({0, 0, 1}), light);
    CHECK(light.points == 0);
    light_source(LocalLight{}, glm::dmat4(1))->intersect(lanes({0, 0, -1}), lanes({0, 0, 1}), light);
    CHECK(light.points == 0);
    // Checks the distances of the hits.
    rows[0].source->intersect(lanes({0, 0, 0}), lanes({0, 0, 1}), light);
    CHECK(light.points == 0xFFFF);
    CHECK(light.distance[5] == doctest::Approx(2.25));
    rows[3].source->intersect(lanes({0.2F, 0.1F, 0}), lanes({0, 0, 1}), light);
    CHECK(light.distance[5] == doctest::Approx(2.2).epsilon(1e-3));
    rows[3].source->intersect(lanes({0.2F, 0.1F, 0}), lanes({0, 0, -1}), light);
    CHECK(light.points == 0);
}
