// SPDX-License-Identifier: MIT
// Tests of rough glass: its smooth limit, energy, and one image by every strategy.
#include "image_difference.hpp"
#include "material/dielectric.hpp"
#include "material/principled.hpp"
#include "reference/light_arrival.hpp"
#include "scene/path_depth.hpp"
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

DielectricParameters glass(double alpha, Distribution distribution = Distribution::ggx) {
    return {.int_ior = 1.5, .ext_ior = 1, .alpha = alpha, .distribution = distribution};
}

Camera some_view() {
    Camera camera;
    camera.to_world = look_at({0.5, 2, 4}, {0, 0, 0}, {0, 1, 0});
    camera.fov = 34;
    return camera;
}

Stokes mean_of(const StokesImage& image) {
    Stokes sum(0.0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) sum += image.stokes(0, y, x);
    return sum / static_cast<double>(image.width * image.height);
}

}  // namespace

TEST_CASE("hardly rough glass shows a polarized sky as smooth glass does") {
    const EnvironmentPtr sky = rayleigh_sky({.sun_direction = {1, 1, 1}, .radiance = {1}});
    using Make = MaterialPtr (*)(const DielectricParameters&);
    for (const Make make : {Make(dielectric), Make(thin_dielectric)}) {
        const auto image = [&](double alpha) {
            Scene scene;
            scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()), .material = make(glass(alpha))});
            scene.set_environment(sky, glm::dmat3(1.0), 1);
            return render(scene, some_view(), 12, 12, {.samples = 512, .max_depth = 6});
        };
        const StokesImage smooth = image(0), rough = image(0.01);
        for (std::size_t p = 0; p < 3; ++p) {
            double error = 0, power = 0;
            for (std::size_t i = 0; i < smooth.data.size(); i += 4) {
                error += std::pow(static_cast<double>(rough.data[i + p] - smooth.data[i + p]), 2);
                power += std::pow(static_cast<double>(smooth.data[i]), 2);
            }
            CAPTURES(p, std::sqrt(error / power));
            CHECK(std::sqrt(error / power) < (p == 0 ? 0.03 : 0.015));
        }
    }
}

TEST_CASE("rough glass in uniform light is nearly as bright as the light, and never brighter") {
    for (const double alpha : {0.05, 0.3}) {
        for (const Distribution distribution : {Distribution::beckmann, Distribution::ggx}) {
            CAPTURES(alpha);
            Scene scene;
            scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()),
                       .material = dielectric(glass(alpha, distribution))});
            scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
            const double s0 =
                mean_of(render(scene, some_view(), 8, 8, {.samples = 512, .max_depth = kUnlimitedDepth}))[0];
            // Light that several facets reflect one after the other is left out.
            CHECK(s0 < 1.01);
            CHECK(s0 > (alpha < 0.1 ? 0.98 : 0.85));
        }
    }
}

TEST_CASE("light through rough glass counts once on a path, by every strategy") {
    for (const MaterialPtr& material :
         {dielectric(glass(0.2)), thin_dielectric(glass(0.3, Distribution::beckmann)),
          principled({.base_color = {0.6}, .roughness = 0.5, .spec_trans = 0.7}),
          principled_thin({.base_color = {0.6}, .roughness = 0.6, .spec_trans = 0.5, .diff_trans = 0.4})}) {
        CAPTURES(material->content_key());
        Scene scene;
        scene.add(square(diffuse({0.7}), Frame(1.0), {0, 0, -1.5}, 3));
        scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()), .material = material});
        Instance lamp = square(diffuse({0.5}), Frame({1, 0, 0}, {0, -1, 0}, {0, 0, -1}), {0.5, 0, 3}, 1.5);
        lamp.emission = std::make_shared<const Emission>(Emission{.radiance = {1}});
        scene.add(lamp);
        scene.add_light({.kind = LocalLight::Kind::directional,
                         .value = {1},
                         .to_world = glm::dmat4(theta_phi_frame(glm::normalize(glm::dvec3(0.3, 0.5, -0.8)))),
                         .angular_radius = 0.5});
        scene.set_environment(constant_environment({0.3}), glm::dmat3(1.0), 1);
        const auto s0 = [&](Strategy strategy, int samples) {
            return mean_of(
                render(scene, some_view(), 4, 4, {.samples = samples, .max_depth = 8}, strategy))[0];
        };
        const double both = s0(Strategy::both, 1 << 11);
        CHECK(both > 0.1);
        for (const Strategy strategy : {Strategy::light, Strategy::surface})
            CHECK(s0(strategy, 1 << 12) == doctest::Approx(both).epsilon(0.02));
    }
}

TEST_CASE("rough glass is refused with parameters out of range") {
    check_error(ErrorCode::invalid_argument, CALL(dielectric(glass(1.5))), "alpha");
    check_error(ErrorCode::invalid_argument, CALL(dielectric(glass(-0.1))), "alpha");
    check_error(ErrorCode::invalid_argument, CALL(dielectric({.int_ior = 200, .ext_ior = 1, .alpha = 0.1})),
                "int_ior / ext_ior");
    check_error(ErrorCode::invalid_argument, CALL(transmitting(diffuse({0.5}), {})), "alpha");
    check_error(ErrorCode::invalid_argument, CALL(principled_thin({.diff_trans = 3})), "diff_trans");
}
