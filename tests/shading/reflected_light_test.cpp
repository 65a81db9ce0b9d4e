// SPDX-License-Identifier: MIT
#include "shading/reflected_light.hpp"

#include "../material/chiral_material.hpp"
#include "directions.hpp"
#include "material/conductor.hpp"
#include "material/microfacet.hpp"
#include "material/plastic.hpp"
#include "polarization/fresnel.hpp"
#include "shading/light_samples.hpp"
#include "shading/local_lighting.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

void put(LaneVectors& lanes, std::size_t i, const glm::dvec3& v) {
    lanes.x[i] = static_cast<float>(v.x);
    lanes.y[i] = static_cast<float>(v.y);
    lanes.z[i] = static_cast<float>(v.z);
}
glm::dvec3 lane(const LaneVectors& lanes, std::size_t i) {
    return glm::normalize(glm::dvec3(lanes.x[i], lanes.y[i], lanes.z[i]));
}

/// Unit normals that mostly face the viewer, and lights that mostly lie above them.
struct Points {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec3> tangents;  ///< at any angle to the normals
    LaneLight light;

    [[nodiscard]] std::span<const glm::vec3> tangents_for(const Material& material) const {
        return material.anisotropic() ? std::span(tangents) : std::span<const glm::vec3>();
    }
};

template <class Random>
Points some_points(Random& random, const Viewpoint& view, std::size_t components, std::size_t channels) {
    std::uniform_real_distribution<float> number(0.1F, 2);
    Points out;
    out.light.components = components;
    out.light.irradiance.resize(channels);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3 position(random_direction(random));
        const glm::dvec3 viewer = view.towards(position);
        // Some points are seen and lit along the normal, in the mirror direction, and at grazing angles.
        glm::dvec3 normal = i == 0 ? viewer : glm::normalize(viewer + 0.9 * random_direction(random));
        if (i == 1) normal = -normal;
        normal = glm::normalize(glm::dvec3(glm::vec3(normal)));
        const glm::dvec3 mirrored = 2 * glm::dot(normal, viewer) * normal - viewer;
        const glm::dvec3 light = i == 2   ? normal
                                 : i == 3 ? mirrored
                                 : i == 4 ? frame_with_x(normal, viewer)[1] + 0.01 * normal
                                          : mirrored + 0.8 * random_direction(random);
        out.positions.push_back(position);
        out.normals.push_back(glm::vec3(normal));
        out.tangents.push_back(glm::vec3(random_direction(random)));
        put(out.light.towards, i, glm::normalize(light));
        put(out.light.x, i, frame_with_x(lane(out.light.towards, i), random_direction(random))[0]);
        for (std::array<Lanes, 4>& irradiance : out.light.irradiance) {
            const glm::dvec3 polarized = 0.9 * random_direction(random);
            irradiance[0][i] = number(random);
            for (int p = 1; p < 4; ++p)
                irradiance[static_cast<std::size_t>(p)][i] =
                    irradiance[0][i] * static_cast<float>(polarized[p - 1]);
        }
    }
    // Unused components hold kNothing, because they must not be read.
    for (std::array<Lanes, 4>& irradiance : out.light.irradiance)
        for (std::size_t p = 0; p < 4; ++p)
            if (p == 3 ? components < 4 : p > 0 && components == 1) irradiance[p].value.fill(kNothing);
    if (components == 1)
        for (Lanes* x : {&out.light.x.x, &out.light.x.y, &out.light.x.z}) x->value.fill(kNothing);
    out.light.points = 0xFFF7;
    out.light.irradiance[0][0][3] = kNothing;
    out.light.towards.x[3] = kNothing;
    return out;
}

Stokes expected_of(const Points& p, std::size_t i, const Viewpoint& view, const Material& material,
                   std::size_t channel, double& scale) {
    const LaneLight& light = p.light;
    const Frame surface = frame_with_x(glm::normalize(glm::dvec3(p.normals[i])), p.tangents[i]);
    const glm::dvec3 viewer = view.towards(p.positions[i]);
    const glm::dvec3 towards_light = lane(light.towards, i);
    const glm::dvec3 local_viewer = viewer * surface;
    const glm::dvec3 local_light = towards_light * surface;
    scale = 1;
    if (!(local_viewer.z > 0) || !(local_light.z > 0)) return Stokes(0.0);

    const std::array<Lanes, 4>& irradiance = light.irradiance[light.irradiance.size() == 1 ? 0 : channel];
    Stokes incident(0.0);
    for (int c = 0; c < static_cast<int>(light.components); ++c)
        incident[c] = static_cast<double>(irradiance[static_cast<std::size_t>(c)][i]);
    if (light.components > 1)
        incident = rotated(incident, angle_between(frame_with_x(-towards_light, lane(light.x, i)),
                                                   surface * theta_phi_frame(-local_light)));
    const Mueller m = evaluate(material, material.channels() == 1 ? 0 : static_cast<int>(channel),
                               local_light, local_viewer);
    scale = local_light.z * largest(m) * incident[0];
    return rotated(local_light.z * (m * incident),
                   angle_between(surface * theta_phi_frame(local_viewer), view.frame(viewer)));
}

const Viewpoint kPerspective{.eye = {0.3, 5, 1},
                             .forward = glm::normalize(glm::dvec3(0, -1, -0.2)),
                             .up = {1, 0, 0},
                             .right = {0, 0, 1}};
const Viewpoint kOrthographic{.orthographic = true};

}  // namespace

TEST_CASE("sixteen points reflect as the sum over Mueller matrices says, in every frame") {
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.2, 0.5, 0.9}, .alpha = 0.2});
    const MaterialPtr gold =
        rough_conductor({.eta = metal_index("Au"), .alpha = 0.3, .distribution = Distribution::ggx});
    const MaterialPtr brushed = rough_conductor({.eta = metal_index("Au"), .alpha = 0.2, .alpha_v = 0.6});
    const struct {
        std::string name;
        MaterialPtr material;
    } rows[] = {{"diffuse", diffuse({0.5})},
                {"plastic", plastic},
                {"gold", gold},
                {"brushed gold", brushed},
                {"two-sided", twosided(plastic)},
                {"chiral", test::chiral(gold)}};
    std::mt19937 random(7);
    LayerWeights weights{.points = 0xFFFE, .equal = false};
    for (Lanes& w : weights.value)
        for (std::size_t i = 0; i < kLanes; ++i) w[i] = static_cast<float>(i) * 0.1F;
    for (const auto& row : rows) {
        for_all({&kPerspective, &kOrthographic}, {1, 3, 4}, {1, 3},
                [&](const Viewpoint* view, int components, int channels) {
                    CAPTURES(row.name, view->orthographic, components, channels);
                    double worst = 0;
                    bool others_kept = true;
                    int seen = 0;
                    for (int n = 0; n < 20; ++n) {
                        const Points p = some_points(random, *view, static_cast<std::size_t>(components),
                                                     static_cast<std::size_t>(channels));
                        const bool layered = n % 2 == 1;
                        const std::uint32_t points =
                            n == 0 ? 0xFFFF : static_cast<std::uint32_t>(random() & 0xFFFF);
                        ReflectedLight reflected;
                        reflected.set(*view, p.positions, p.normals, p.tangents_for(*row.material));
                        std::vector<std::array<Lanes, 4>> out(3);
                        for (auto& stokes : out)
                            for (Lanes& lanes : stokes) lanes.value.fill(0.25F);
                        reflected.add(*row.material, layered ? &weights : nullptr, p.light, points, 0.5F,
                                      out);
                        const std::uint32_t lit = reflected.lit(p.light);
                        for (std::size_t i = 0; i < kLanes; ++i)
                            for (std::size_t c = 0; c < 3; ++c) {
                                double scale = 1;
                                Stokes expected(0.0);
                                if ((points & p.light.points) >> i & 1) {
                                    expected = expected_of(p, i, *view, *row.material, c, scale);
                                    CHECK(((lit >> i & 1) != 0) == (expected[0] != 0));
                                    seen += expected[0] != 0 ? 1 : 0;
                                }
                                const double factor =
                                    layered ? 0.5 * static_cast<double>(weights.value[c][i]) : 0.5;
                                for (int q = 0; q < 4; ++q) {
                                    const float value = out[c][static_cast<std::size_t>(q)][i];
                                    if (expected[0] * factor == 0) {
                                        others_kept = others_kept && value == 0.25F;
                                        continue;
                                    }
                                    const double error =
                                        std::abs(static_cast<double>(value) - 0.25 - factor * expected[q]);
                                    // The tolerance also covers rounding of the accumulated sum.
                                    CHECK(std::isfinite(error));
                                    worst = std::max(worst, (error - 1e-7) / (factor * scale));
                                }
                            }
                    }
                    CHECK(seen > 300);
                    CHECK(others_kept);
                    CHECK(worst < 5e-5);
                });
    }
}

TEST_CASE("an anisotropic material without a tangent takes some other") {
    std::mt19937 random(9);
    Points p = some_points(random, kPerspective, 4, 1);
    p.tangents.assign(kLanes, glm::vec3(0));
    p.tangents.front() = p.normals.front();
    ReflectedLight reflected;
    reflected.set(kPerspective, p.positions, p.normals, p.tangents);
    std::vector<std::array<Lanes, 4>> out(1);
    reflected.add(*rough_conductor({.alpha = 0.2, .alpha_v = 0.6}), nullptr, p.light, 0xFFFF, 1, out);
    for (const float s0 : out[0][0].value) CHECK(std::isfinite(s0));
    CHECK(out[0][0][0] > 0);
}

TEST_CASE("smooth terms are mirrors and reflect no light from elsewhere") {
    const std::complex<double> gold(0.4, -2.4);
    const struct {
        const char* name;
        MaterialPtr smooth;
        MaterialPtr base;  ///< material without the mirror term; null: none
        std::complex<double> index;
        bool polarizes;
    } rows[] = {{"gold", conductor({gold}), nullptr, gold, true},
                {"glass", rough_conductor({.eta = {1.5}, .alpha = 0}), nullptr, 1.5, true},
                {"plastic", plastic({.ext_ior = 1}), plastic({.specular_reflectance = {0}, .ext_ior = 1}),
                 1.49, false}};
    for (const auto& row : rows)
        for (const std::size_t components : {1U, 4U}) {
            CAPTURES(row.name, components);
            std::mt19937 random(9);
            Points p = some_points(random, kPerspective, components, 1);
            ReflectedLight reflected;
            reflected.set(kPerspective, p.positions, p.normals);
            const auto added = [&](const Material& material, bool mirrored) {
                std::vector<std::array<Lanes, 4>> out(1);
                if (mirrored)
                    reflected.add_mirrored(material, nullptr, p.light, 0xFFFF, out);
                else
                    reflected.add(material, nullptr, p.light, 0xFFFF, 1, out);
                return out[0];
            };
            const auto rest = added(*row.smooth, false);
            for (std::size_t i = 0; i < kLanes; ++i)
                CHECK(rest[0][i] == (row.base != nullptr ? added(*row.base, false)[0][i] : 0));

            p.light.towards = reflected.mirrored_directions();
            p.light.points = 0xFFFF;
            for (Lanes& lanes : p.light.irradiance[0]) lanes[3] = lanes[4];
            for (std::size_t i = 0; i < kLanes; ++i)
                put(p.light.x, i, frame_with_x(lane(p.light.towards, i), random_direction(random))[0]);
            const auto seen = added(*row.smooth, true);
            for (std::size_t i = 0; i < kLanes; ++i) {
                const glm::dvec3 viewer = kPerspective.towards(p.positions[i]);
                const glm::dvec3 normal = glm::normalize(glm::dvec3(p.normals[i]));
                const glm::dvec3 mirrored = 2 * glm::dot(normal, viewer) * normal - viewer;
                CHECK(glm::distance(lane(p.light.towards, i), mirrored) < 1e-6);
                if (!(glm::dot(viewer, normal) > 0.03)) continue;
                // Both frames have x along the s-axis, as in Fresnel's formulas.
                const glm::dvec3 s_axis = frame_with_x(viewer, glm::cross(mirrored, viewer))[0];
                Stokes incident(0.0);
                for (std::size_t q = 0; q < components; ++q)
                    incident[static_cast<int>(q)] = static_cast<double>(p.light.irradiance[0][q][i]);
                if (components > 1)
                    incident = rotated(incident, angle_between(frame_with_x(-mirrored, lane(p.light.x, i)),
                                                               frame_with_x(-mirrored, s_axis)));
                const Mueller fresnel = fresnel_reflection(glm::dot(viewer, normal), row.index);
                Stokes expected =
                    row.polarizes ? fresnel * incident : Stokes(fresnel(0, 0) * incident[0], 0, 0, 0);
                expected = rotated(expected,
                                   angle_between(frame_with_x(viewer, s_axis), kPerspective.frame(viewer)));
                for (int q = 0; q < 4; ++q)
                    CHECK(static_cast<double>(seen[static_cast<std::size_t>(q)][i]) ==
                          doctest::Approx(expected[q]).epsilon(1e-3).scale(expected[0]));
            }
        }
}

TEST_CASE("rough terms are no mirrors") {
    std::mt19937 random(9);
    const Points p = some_points(random, kPerspective, 1, 1);
    ReflectedLight reflected;
    reflected.set(kPerspective, p.positions, p.normals);
    std::vector<std::array<Lanes, 4>> out(1);
    for (const MaterialPtr& rough : {plastic({.alpha = 0.3}), diffuse({0.5}), rough_conductor({})}) {
        reflected.add_mirrored(*rough, nullptr, p.light, 0xFFF7, out);
        for (const float s0 : out[0][0].value) CHECK(s0 == 0);
    }
}

TEST_CASE("terms that find lights by samples are not lit by light samples") {
    std::mt19937 random(9);
    const Points p = some_points(random, kPerspective, 4, 1);
    ReflectedLight reflected;
    reflected.set(kPerspective, p.positions, p.normals);
    const MaterialPtr narrow = pplastic({.alpha = 0.09}), wide = pplastic({.alpha = 0.3});
    constexpr SampledTerms sampled = SampledTerms::anisotropic_narrow;
    std::vector<std::array<Lanes, 4>> all(1), parts(1), kept(1), same(1);
    reflected.add(*narrow, nullptr, p.light, 0xFFF7, 1, all);
    reflected.add(*narrow, nullptr, p.light, 0xFFF7, 1, kept, sampled);
    parts = kept;
    LaneLight local = p.light;
    into_frames(reflected.frames(), local.towards, local.towards);
    into_frames(reflected.frames(), local.x, local.x);
    for (const double alpha : {0.09, 0.3}) {
        const Lobe lobe{glm::dvec2(alpha), Distribution::beckmann};
        reflected.add_sampled(ReflectedLight::sampled_terms(*narrow, sampled, lobe, 1), nullptr, local,
                              0xFFF7, parts);
    }
    for (std::size_t q = 0; q < 4; ++q)
        for (std::size_t i = 0; i < kLanes; ++i)
            CHECK(parts[0][q][i] == doctest::Approx(all[0][q][i]).epsilon(1e-5));
    bool differ = false;
    for (std::size_t i = 0; i < kLanes; ++i) differ = differ || kept[0][0][i] < all[0][0][i];
    CHECK(differ);
    reflected.add(*wide, nullptr, p.light, 0xFFF7, 1, same, sampled);
    std::vector<std::array<Lanes, 4>> whole(1);
    reflected.add(*wide, nullptr, p.light, 0xFFF7, 1, whole);
    for (std::size_t i = 0; i < kLanes; ++i) CHECK(same[0][0][i] == whole[0][0][i]);
}

TEST_CASE("lanes beyond the points given repeat the first") {
    std::mt19937 random(8);
    Points p = some_points(random, kPerspective, 4, 1);
    p.light.points = 0xFFFF;
    for (Lanes* lanes : {&p.light.towards.x, &p.light.towards.y, &p.light.towards.z, &p.light.x.x,
                         &p.light.x.y, &p.light.x.z})
        lanes->value.fill((*lanes)[0]);
    for (Lanes& lanes : p.light.irradiance[0]) lanes.value.fill(lanes[0]);
    ReflectedLight reflected;
    reflected.set(kPerspective, std::span(p.positions).first(3), std::span(p.normals).first(3),
                  std::span(p.tangents).first(3));
    std::vector<std::array<Lanes, 4>> out(1);
    reflected.add(*pplastic({}), nullptr, p.light, 0xFFFF, 1, out);
    CHECK(out[0][0][0] > 0);
    for (const Lanes& lanes : out[0]) CHECK(lanes[15] == lanes[0]);
}
