// SPDX-License-Identifier: MIT
// Tests of smooth glass: closed forms of what its boundaries reflect and transmit, and energy.
#include "image_difference.hpp"
#include "material/dielectric.hpp"
#include "material/mixture.hpp"
#include "reference/light_arrival.hpp"
#include "scene/path_depth.hpp"
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

constexpr double kGlass = 1.5;

MaterialPtr glass(double eta = kGlass) {
    return dielectric({.int_ior = eta, .ext_ior = 1});
}

MaterialPtr thin_glass() {
    return thin_dielectric({.int_ior = kGlass, .ext_ior = 1});
}

Stokes seen(const Scene& scene, const Camera& camera, int samples, int max_depth = kUnlimitedDepth,
            Strategy strategy = Strategy::both) {
    return render(scene, camera, 1, 1, {.samples = samples, .max_depth = max_depth}, strategy)
        .stokes(0, 0, 0);
}

Instance shining(Instance instance, const PolarizationState& state = {}) {
    instance.emission =
        std::make_shared<const Emission>(Emission{.radiance = {1}, .two_sided = true, .state = state});
    return instance;
}

/// Returns light with s-polarized and p-polarized parts as the camera sees it. towards_viewer is a direction
/// in the plane of incidence of a surface whose normal is z.
Stokes in_camera(double s, double p, const Camera& camera, const glm::dvec3& towards_viewer) {
    const Frame along_s = frame_with_x(towards_viewer, glm::cross(glm::dvec3(0, 0, 1), towards_viewer));
    const Frame received = project(camera, 1, 1).view.frame(towards_viewer);
    return rotated({(s + p) / 2, (s - p) / 2, 0, 0}, angle_between(along_s, received));
}

/// Returns a unit vector at an angle from z, in no special plane.
glm::dvec3 at_angle(double angle) {
    return {std::sin(angle) * std::cos(0.7), std::sin(angle) * std::sin(0.7), std::cos(angle)};
}

void check_near(const Stokes& ours, const Stokes& wanted, double most) {
    for (int p = 0; p < 4; ++p) {
        CAPTURES(p, ours[p], wanted[p]);
        CHECK(std::abs(ours[p] - wanted[p]) < most);
    }
}

/// Returns the share that one boundary reflects of s-polarized light, by the sine law.
double reflected_s(double angle) {
    const double refracted = std::asin(std::sin(angle) / kGlass);
    return std::pow(std::sin(angle - refracted) / std::sin(angle + refracted), 2);
}

/// Returns the share that one boundary reflects of p-polarized light, by the tangent law.
double reflected_p(double angle) {
    const double refracted = std::asin(std::sin(angle) / kGlass);
    return std::pow(std::tan(angle - refracted) / std::tan(angle + refracted), 2);
}

}  // namespace

TEST_CASE("glass that absorbs nothing is as bright as the uniform light around it") {
    Scene scene;
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()), .material = glass()});
    glm::dmat4 aside(0.5);
    aside[3] = {1.2, 0.8, 0.4, 1};
    scene.add(
        {.mesh = std::make_shared<const Mesh>(make_cube(1)), .material = glass(1.7), .to_world = aside});
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    Camera camera;
    camera.to_world = look_at({0.5, 2, 6}, {0.4, 0.2, 0}, {0, 1, 0});
    const StokesImage image = render(scene, camera, 12, 12, {.samples = 1024, .max_depth = kUnlimitedDepth});
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) check_near(image.stokes(0, y, x), {1, 0, 0, 0}, 0.1);
    double sum = 0;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) sum += image.stokes(0, y, x)[0];
    CHECK(sum / 144 == doctest::Approx(1).epsilon(2e-3));
}

TEST_CASE("at Brewster's angle reflected light is s-polarized and transmitted light partly p-polarized") {
    const double angle = std::atan(kGlass);
    const glm::dvec3 towards_viewer = at_angle(angle);
    const Camera camera = camera_on({0, 0, 0}, towards_viewer);
    const double s = reflected_s(angle);
    CHECK(reflected_p(angle) < 1e-15);

    Scene above;
    above.add(square(glass()));
    above.add(square(diffuse({0}), Frame(1.0), {0, 0, -1}, 20));
    above.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    check_near(seen(above, camera, 1 << 12), in_camera(s, 0, camera, towards_viewer), 1e-3);
    // Both parts of the light count if the path ends behind the boundary.
    check_near(seen(above, camera, 1 << 12, 2), in_camera(s, 0, camera, towards_viewer), 1e-3);

    Scene below;
    below.add(square(glass()));
    below.add(shining(square(diffuse({0}), Frame(1.0), {0, 0, -1}, 20)));
    // Radiance per square of the index stays the same.
    const double spread = 1 / (kGlass * kGlass);
    check_near(seen(below, camera, 1 << 12), in_camera(spread * (1 - s), spread, camera, towards_viewer),
               1e-3);
}

TEST_CASE("m thin plates, or one of two boundaries, transmit by Stokes's formula") {
    constexpr double angle = 56 * pi / 180;
    const glm::dvec3 towards_viewer = at_angle(angle);
    const Camera camera = camera_on({0, 0, 0}, towards_viewer);
    const auto transmitted = [](double r, int m) { return (1 - r) / (1 + (2 * m - 1) * r); };
    const auto check_plates = [&](const Scene& scene, int m) {
        CAPTURES(m);
        check_near(seen(scene, camera, 1 << 17),
                   in_camera(transmitted(reflected_s(angle), m), transmitted(reflected_p(angle), m), camera,
                             towards_viewer),
                   4e-3);
    };
    const Instance lamp = shining(square(diffuse({0}), Frame(1.0), {0, 0, -1}, 20));
    for (const int m : {1, 3, 8}) {
        Scene scene;
        scene.add(lamp);
        for (int i = 0; i < m; ++i) scene.add(square(thin_glass(), Frame(1.0), {0, 0, -0.001 * i}, 10));
        check_plates(scene, m);
    }
    Scene body;
    body.add(lamp);
    body.add(square(glass(), Frame(1.0), {0, 0, 0}, 10));
    body.add(square(glass(), Frame({1, 0, 0}, {0, -1, 0}, {0, 0, -1}), {0, 0, -0.001}, 10));
    check_plates(body, 1);
}

TEST_CASE("a thin plate acts on light of every polarization like the two boundaries of a body") {
    const Frame tilted = frame_with_x(glm::normalize(glm::dvec3(0.3, -0.2, 1)), {1, 0.3, 0.2});
    const glm::dvec3 towards_viewer = glm::normalize(tilted * at_angle(1.1));
    const Camera camera = camera_on({0, 0, 0}, towards_viewer);
    const EnvironmentPtr sky = rayleigh_sky({.sun_direction = {1, 1, 1}, .radiance = {1}});
    const glm::dvec3 mirrored = 2 * glm::dot(towards_viewer, tilted[2]) * tilted[2] - towards_viewer;
    const auto image = [&](const std::vector<Instance>& plates, const glm::dvec3& towards_lamp) {
        Scene scene;
        for (const Instance& plate : plates) scene.add(plate);
        scene.add(shining(square(diffuse({0}), theta_phi_frame(-towards_lamp), 5.0 * towards_lamp, 2),
                          {.dolp = 0.6, .aolp = 0.4, .docp = 0.8, .axis = {1, 0.2, 0}}));
        scene.set_environment(sky, glm::dmat3(1.0), 1);
        return seen(scene, camera, 1 << 16);
    };
    const Frame turned(tilted[0], -tilted[1], -tilted[2]);
    for (const glm::dvec3& towards_lamp : {-towards_viewer, mirrored}) {
        const Stokes body =
            image({square(glass(), tilted, {0, 0, 0}, 2), square(glass(), turned, -0.001 * tilted[2], 2)},
                  towards_lamp);
        const Stokes thin = image({square(thin_glass(), tilted, {0, 0, 0}, 2)}, towards_lamp);
        CHECK(std::abs(thin[3]) > 0.03);
        CHECK(std::abs(thin[1]) + std::abs(thin[2]) > 0.03);
        check_near(thin, body, 5e-3);
    }
}

TEST_CASE("glass mirrors lights with a size, and no others") {
    const glm::dvec3 towards_viewer = at_angle(0.8);
    const glm::dvec3 mirrored(-towards_viewer.x, -towards_viewer.y, towards_viewer.z);
    const Camera camera = camera_on({0, 0, 0}, towards_viewer);
    const auto lit = [&](double radius) {
        Scene scene;
        scene.add(square(glass()));
        scene.add_light({.kind = LocalLight::Kind::directional,
                         .value = {1},
                         .to_world = glm::dmat4(theta_phi_frame(-mirrored)),
                         .angular_radius = radius});
        return seen(scene, camera, 1 << 14);
    };
    const double radiance = 1 / (pi * std::pow(std::sin(0.1), 2));
    check_near(lit(0.1) / radiance, in_camera(reflected_s(0.8), reflected_p(0.8), camera, towards_viewer),
               1e-3);
    CHECK(lit(0) == Stokes(0.0));
}

TEST_CASE("total reflection rotates s2 into s3 by Fresnel's phase") {
    constexpr double angle = 54.6 * pi / 180;
    const glm::dvec3 towards_viewer = at_angle(pi - angle);
    const glm::dvec3 towards_light(-towards_viewer.x, -towards_viewer.y, towards_viewer.z);
    const Camera camera = camera_on({0, 0, 0}, towards_viewer);
    const PolarizationState state{.dolp = 0.8, .aolp = 0.3, .docp = -0.6, .axis = {0.2, 1, 0}};
    Scene scene;
    scene.add(square(glass()));
    const Instance lamp =
        shining(square(diffuse({0}), theta_phi_frame(-towards_light), 3.0 * towards_light, 0.5), state);
    scene.add(lamp);

    const Frame arriving = frame_with_x(-towards_light, glm::cross(glm::dvec3(0, 0, 1), towards_viewer));
    const Stokes in = stokes_in(arriving, state, axis_in_world(lamp.to_world, state));
    const double sine = std::sin(angle);
    const double phase =
        2 * std::atan(std::cos(angle) * std::sqrt(sine * sine - 1 / (kGlass * kGlass)) / (sine * sine));
    const double c = std::cos(phase);
    const double s = std::sin(phase);
    // Each of the two total reflections of Fresnel's rhomb retards by an eighth of a wave.
    CHECK(phase == doctest::Approx(pi / 4).epsilon(0.01));
    const Frame leaving_frame = frame_with_x(towards_viewer, glm::cross(glm::dvec3(0, 0, 1), towards_viewer));
    const Frame received = project(camera, 1, 1).view.frame(towards_viewer);
    check_near(seen(scene, camera, 16),
               rotated({in[0], in[1], c * in[2] - s * in[3], s * in[2] + c * in[3]},
                       angle_between(leaving_frame, received)),
               1e-5);
}

TEST_CASE("a ball of the index of its surroundings is invisible") {
    Camera camera;
    camera.to_world = look_at({0.5, 2, 6}, {0, 0, 0}, {0, 1, 0});
    Scene scene;
    scene.set_environment(rayleigh_sky({.sun_direction = {1, 1, 1}, .radiance = {1}}), glm::dmat3(1.0), 1);
    const auto image = [&] { return render(scene, camera, 16, 16, {.samples = 16, .max_depth = 6}); };
    const StokesImage empty = image();
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()), .material = glass(1)});
    CHECK(rms(empty) > 0.1);
    CHECK(rms_difference(image(), empty) < 1e-6 * rms(empty));
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere({0, 1, 0})), .material = glass(1.01)});
    CHECK(rms_difference(image(), empty) > 1e-5 * rms(empty));
}

TEST_CASE("colours of glass multiply what it reflects and transmits") {
    const MaterialPtr coloured = thin_dielectric({.specular_reflectance = {0.5, 0, 1},
                                                  .specular_transmittance = {0.25, 1, 0},
                                                  .int_ior = kGlass,
                                                  .ext_ior = 1});
    Scene scene;
    scene.add(square(coloured));
    scene.set_environment(constant_environment({1, 1, 1}), glm::dmat3(1.0), 1);
    const double r = 2 * reflected_s(1e-4) / (1 + reflected_s(1e-4));
    const std::vector<Stokes> ours = point(scene, camera_on({0, 0, 0}, {1e-4, 0, 1}), 1 << 14);
    CHECK(ours[0][0] == doctest::Approx(0.5 * r + 0.25 * (1 - r)).epsilon(2e-3));
    CHECK(ours[1][0] == doctest::Approx(1 - r).epsilon(2e-3));
    CHECK(ours[2][0] == doctest::Approx(r).epsilon(0.05));
}

TEST_CASE("glass with a film reflects and transmits as the film says at the wavelength of each channel") {
    const std::vector<double> wavelengths = {450, 550, 650};
    const double angle = 50 * pi / 180;
    const double sine2 = std::pow(std::sin(angle), 2);
    const FilmParameters film{.thickness = 300, .eta = {2.1}, .wavelengths = wavelengths};
    const glm::dvec3 towards_viewer = at_angle(angle);
    const Camera camera = camera_on({0, 0, 0}, towards_viewer);
    const auto check = [&](const MaterialPtr& material, bool thin, bool from_below) {
        Scene scene;
        scene.add(square(material));
        const Instance wall = square(diffuse({0}), Frame(1.0), {0, 0, -1}, 20);
        scene.add(from_below ? shining(wall) : wall);
        if (!from_below) scene.set_environment(constant_environment({1, 1, 1}), glm::dmat3(1.0), 1);
        const std::vector<Stokes> ours = point(scene, camera, 1 << 14);
        for (std::size_t c = 0; c < 3; ++c) {
            CAPTURES(thin, from_below, c);
            FilmSplit split = film_split(sine2, kGlass, {300, 2.1}, wavelengths[c]);
            if (thin) split = slab_of(split);
            const double spread = thin || !from_below ? 1 : 1 / (kGlass * kGlass);
            const SpShares seen_part = spread * (from_below ? split.transmission : split.front);
            check_near(ours[c], in_camera(seen_part.s, seen_part.p, camera, towards_viewer), 6e-3);
        }
    };
    for (const bool from_below : {false, true}) {
        check(dielectric({.int_ior = kGlass, .ext_ior = 1, .film = film}), false, from_below);
        check(thin_dielectric({.int_ior = kGlass, .ext_ior = 1, .film = film}), true, from_below);
    }
    // A soap film in air: the index of the body is that of its surroundings.
    const MaterialPtr soap =
        dielectric({.int_ior = 1, .ext_ior = 1, .film = {.thickness = 500, .eta = {1.33}}});
    CHECK(soap->channels() == 3);
    CHECK(error_of(CALL(dielectric({.specular_reflectance = {1, 1}, .film = film}))).find("specular") == 0);
}

TEST_CASE("a body absorbs light by the length of its path inside, also of lights inside") {
    const std::vector<double> absorption{0.5, 2, 0};
    Camera camera;
    camera.to_world = look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0});
    camera.fov = 1e-3;
    const auto through = [&](double lamp_at) {
        Scene scene;
        scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
                   .material = dielectric({.int_ior = 1, .ext_ior = 1, .absorption = absorption})});
        scene.add(shining(square(diffuse({0, 0, 0}), Frame(1.0), {0, 0, lamp_at}, 0.5)));
        return render(scene, camera, 1, 1, {.samples = 16, .max_depth = kUnlimitedDepth});
    };
    // The cube extends from z = -1 to 1.
    for (const auto& [lamp_at, length] : {std::pair{-1.5, 2.0}, {-0.25, 1.25}}) {
        const StokesImage ours = through(lamp_at);
        for (int c = 0; c < 3; ++c)
            CHECK(ours.stokes(c, 0, 0)[0] ==
                  doctest::Approx(std::exp(-absorption[static_cast<std::size_t>(c)] * length)).epsilon(1e-5));
    }

    // A floor inside the body reflects a lamp inside, so the light is absorbed twice.
    Scene scene;
    scene.add({.mesh = std::make_shared<const Mesh>(make_cube(1)),
               .material = dielectric({.int_ior = 1, .ext_ior = 1, .absorption = absorption})});
    scene.add(square(diffuse({1, 1, 1}), Frame(1.0), {0, 0, -0.5}, 0.5));
    scene.add_light({.kind = LocalLight::Kind::point, .value = {1}, .to_world = glm::dmat4(1.0)});
    const StokesImage ours = render(scene, camera, 1, 1, {.samples = 16, .max_depth = 4});
    for (int c = 0; c < 3; ++c)
        CHECK(ours.stokes(c, 0, 0)[0] ==
              doctest::Approx(std::exp(-2 * absorption[static_cast<std::size_t>(c)]) / (pi * 0.25))
                  .epsilon(1e-5));
}

TEST_CASE("light through glass counts once on a path, by every strategy") {
    Scene scene;
    scene.add(square(diffuse({0.7}), Frame(1.0), {0, 0, -1}, 3));
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()), .material = glass()});
    const Frame down(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
    scene.add(shining(square(diffuse({0.5}), down, {0.5, 0, 3}, 1.5)));
    scene.add_light({.kind = LocalLight::Kind::directional,
                     .value = {1},
                     .to_world = glm::dmat4(theta_phi_frame(-at_angle(0.6))),
                     .angular_radius = 0.5});
    scene.set_environment(constant_environment({0.3}), glm::dmat3(1.0), 1);
    // The floor beside the ball sees the lamp through it.
    const Camera camera = camera_on({-0.6, -0.3, -1}, {-2, 0.3, 0.6});
    const double both = seen(scene, camera, 1 << 15, 12)[0];
    CHECK(both > 1.1 * seen(scene, camera, 1 << 15, 2)[0]);
    for (const Strategy strategy : {Strategy::light, Strategy::surface})
        CHECK(seen(scene, camera, 1 << 16, 12, strategy)[0] == doctest::Approx(both).epsilon(0.015));
}

TEST_CASE("glass is refused where a texture varies it, and with parameters out of range") {
    const TexturePtr half = constant_texture(glm::vec4(0.5F), 1);
    for (const auto& make : std::vector<std::function<MaterialPtr()>>{
             [&] { return scaled(glass(), half); }, [&] { return masked(thin_glass(), half, true); },
             [&] { return blend(diffuse({0.5}), glass(), half); }})
        check_error(ErrorCode::unsupported, CALL(make()), "light passes", "use it alone");
    check_error(ErrorCode::invalid_argument, CALL(twosided(glass())), "twosided", "use it alone");
    check_error(ErrorCode::invalid_argument, CALL(glass(0)), "int_ior");
    check_error(ErrorCode::invalid_argument, CALL(dielectric({.specular_transmittance = {1.5}})),
                "specular_transmittance");
    check_error(ErrorCode::invalid_argument, CALL(dielectric({.absorption = {-1}})), "absorption");
    check_error(ErrorCode::invalid_argument,
                CALL(dielectric({.specular_transmittance = {1, 1}, .absorption = {1, 1, 1}})), "absorption",
                "specular_transmittance");
    check_error(ErrorCode::invalid_argument, CALL(thin_dielectric({.absorption = {1}})), "absorption",
                "specular_transmittance");
    check_error(ErrorCode::unsupported, CALL(dielectric({.specular_reflectance = {half}})),
                "specular_reflectance", "constant colour");
}
