// SPDX-License-Identifier: MIT
// Tests of area lights reflected in smooth surfaces, against the mirror image in closed form.
#include <functional>

#include "gl/contexts.hpp"
#include "polarization/fresnel.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;

namespace {

const std::complex<double> kGold(0.4, -2.4);
const PolarizationState kState{.dolp = 0.7, .aolp = 0.4, .docp = -0.5, .axis = {0.3, 1, 0.2}};
constexpr double kMargin = 0.02;  // width around edges that is not compared

/// A lamp over a mirror in the plane y = 0, seen from above.
struct MirroredLamp {
    std::string name;
    Mesh mesh;
    Emission emission;
    /// Radiance along a ray in the lamp's axes, relative to its emission, or a negative number close to an
    /// edge.
    std::function<double(const glm::dvec3& origin, const glm::dvec3& direction)> radiance;
};

double within(double outside) {
    return std::abs(outside - 1) < kMargin ? -1 : outside < 1 ? 1 : 0;
}

glm::dvec2 at_plane(const glm::dvec3& origin, const glm::dvec3& direction) {
    return glm::dvec2(origin - origin.z / direction.z * direction);
}

double of_square(const glm::dvec3& origin, const glm::dvec3& direction) {
    if (!(origin.z > 0 && direction.z < 0)) return 0;
    const glm::dvec2 at = at_plane(origin, direction);
    return within(std::max(std::abs(at.x), std::abs(at.y)));
}

double of_ball(const glm::dvec3& origin, const glm::dvec3& direction) {
    const double along = -glm::dot(origin, direction) / glm::dot(direction, direction);
    return along > 0 ? within(glm::length(origin + along * direction)) : 0;
}

const std::vector<MirroredLamp>& lamps() {
    static const std::vector<MirroredLamp> all{
        {"square", make_rectangle(1), {.radiance = {2}, .state = kState}, of_square},
        {"unpolarized", make_rectangle(1), {.radiance = {2}}, of_square},
        {"disk",
         make_disk(),
         {.radiance = {2}, .state = kState},
         [](const glm::dvec3& origin, const glm::dvec3& direction) {
             if (!(origin.z > 0 && direction.z < 0)) return 0.0;
             return within(glm::length(at_plane(origin, direction)));
         }},
        {"sphere", make_sphere(), {.radiance = {2}, .state = kState}, of_ball},
        {"sphere of few triangles", *test::coarse_sphere(12), {.radiance = {2}}, of_ball},
        {"texture",
         *test::with_texcoords(make_rectangle(1)),
         {.radiance = {2},
          .texture = test::texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x); }),
          .state = kState},
         [](const glm::dvec3& origin, const glm::dvec3& direction) {
             const double square = of_square(origin, direction);
             return square > 0 ? (at_plane(origin, direction).x + 1) / 2 : square;
         }}};
    return all;
}

const glm::dmat4 kLampPlace =
    look_at({0.6, 1.6, -2.5}, glm::dvec3(0, 0, 0.2), {0.2, 1, 0}) * test::at(0, 0, 0, 0.7);
const glm::dvec3 kBall(0.2, 0.9, -1.2);
constexpr double kBallRadius = 0.25;

/// Largest difference from the closed form at the mirror's pixels, and the numbers of lit and hidden pixels.
struct Errors {
    double largest = 0;
    int lit = 0, hidden = 0;
};

Errors errors_of(const std::shared_ptr<gl::Context>& context, const MirroredLamp& lamp,
                 const MaterialPtr& mirror, std::complex<double> index, Executor executor) {
    constexpr int width = 96, height = 72;
    Scene scene;
    scene.add({.mesh = test::rectangle(1), .material = mirror, .to_world = test::plate_at(0, 3)});
    scene.add({.mesh = std::make_shared<const Mesh>(lamp.mesh),
               .material = diffuse({0}),
               .to_world = kLampPlace,
               .emission = std::make_shared<const Emission>(lamp.emission)});
    scene.add({.mesh = test::fine_sphere(),
               .material = diffuse({0}),
               .to_world = test::at(kBall.x, kBall.y, kBall.z, kBallRadius)});
    const Camera camera = test::camera_at({0, 1.5, 3}, {0, 0.2, -0.3});
    Renderer renderer(context);
    Framebuffer target(context, width, height, 1);
    renderer.render(scene, camera,
                    {.executor = executor,
                     .bake_directions = 256,
                     .shade_at = ShadeAt::pixels,
                     .aovs = aov_positions | aov_instances},
                    target);
    const Viewpoint view = project(camera, width, height).view;
    const glm::dmat4 to_lamp = glm::inverse(kLampPlace);
    Errors out;
    for (std::size_t p = 0; p < target.aovs().instances.size(); ++p) {
        if (target.aovs().instances[p] != 0) continue;
        const float* const at = &target.aovs().positions[3 * p];
        const glm::dvec3 position(at[0], at[1], at[2]);
        const glm::dvec3 viewer = view.towards(position);
        const glm::dvec3 mirrored(-viewer.x, viewer.y, -viewer.z);
        const double radiance = lamp.radiance(glm::dvec3(to_lamp * glm::dvec4(position, 1)),
                                              glm::dvec3(to_lamp * glm::dvec4(mirrored, 0)));
        const double ball = of_ball((position - kBall) / kBallRadius, mirrored);
        if (radiance < 0 || ball < 0) continue;
        const glm::dvec3 s_axis = glm::cross(mirrored, viewer);
        const Stokes incident = stokes_in(frame_with_x(-mirrored, s_axis), lamp.emission.state,
                                          glm::normalize(glm::dmat3(kLampPlace) * lamp.emission.state.axis));
        const Stokes reflected = rotated(fresnel_reflection(viewer.y, index) * incident,
                                         angle_between(frame_with_x(viewer, s_axis), view.frame(viewer)));
        const Stokes expected = ball > 0 ? Stokes(0) : 2 * radiance * reflected;
        for (std::size_t q = 0; q < 4; ++q)
            out.largest =
                std::max(out.largest, std::abs(double{target.image().at(0, static_cast<int>(p / width),
                                                                        static_cast<int>(p % width))[q]} -
                                               expected[static_cast<int>(q)]));
        if (radiance > 0) ++(ball > 0 ? out.hidden : out.lit);
    }
    return out;
}

}  // namespace

IMAGE_TEST_CASE("a mirror shows lamps where they are, and what hides them") {
    for (const MirroredLamp& lamp : lamps())
        for (const Executor executor : {Executor::cpu, Executor::compute}) {
            CAPTURES(lamp.name, executor == Executor::cpu);
            const Errors errors = errors_of(context, lamp, conductor({kGold}), kGold, executor);
            CHECK(errors.largest < 2e-3);
            CHECK(errors.lit > 150);
            CHECK(errors.hidden > 20);
        }
}

IMAGE_TEST_CASE("glass and both sides of a thin mirror show lamps") {
    const MirroredLamp& square = lamps().front();
    const MaterialPtr glass = rough_conductor({.eta = {1.5}, .alpha = 0});
    CHECK(errors_of(context, square, glass, 1.5, Executor::cpu).largest < 2e-3);
    CHECK(errors_of(context, square, twosided(conductor({kGold})), kGold, Executor::cpu).largest < 2e-3);
}
