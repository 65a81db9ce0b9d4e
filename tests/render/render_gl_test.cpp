// SPDX-License-Identifier: MIT
#include "directions.hpp"
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "light/images.hpp"
#include "render/scenes.hpp"

using namespace nicol;

namespace {

constexpr int width = 48;
constexpr int height = 32;

Camera camera_at(const glm::dvec3& origin) {
    Camera camera;
    camera.to_world = look_at(origin, {0, 0, 0}, {0.1, 1, 0.2});
    camera.fov = 60;
    return camera;
}

StokesImage render(const std::shared_ptr<gl::Context>& context, const Scene& scene, const Camera& camera,
                   int order) {
    return test::Studio(context, width, height)(scene, {.order_low = order, .order_high = order}, camera);
}

/// Returns a component, by default s0, at the middle of an image.
float middle(const StokesImage& image, int channel = 0, std::size_t component = 0) {
    return image.at(channel, height / 2, width / 2)[component];
}

// Returns the world direction of a pixel's ray, computed independently.
glm::dvec3 ray_of(const Camera& camera, int x, int y) {
    const double half = std::tan(camera.fov * pi / 360);
    const double right = (2 * (x + 0.5) / width - 1) * half;
    const double up = (1 - 2 * (y + 0.5) / height) * half * height / width;
    return glm::normalize(glm::dvec3(camera.to_world * glm::dvec4(-right, up, 1, 0)));
}

}  // namespace

GL_TEST_CASE("the background is the environment, rotated, with its Stokes vectors in the camera's frame") {
    for_all({1, 3, 6}, {true, false}, [&](int channels, bool polarized) {
        Scene scene;
        std::vector<double> radiance;
        for (int c = 0; c < channels; ++c) radiance.push_back(0.5 + c);
        const EnvironmentPtr light =
            polarized ? image_environment(random_image(16, 9, channels, 5)) : constant_environment(radiance);
        scene.set_environment(light, some_rotation(), 1.5);
        const Camera camera = camera_at({2, 1, -3});
        const glm::dvec3 up = glm::normalize(glm::dvec3(camera.to_world[1]));
        const StokesImage image = render(context, scene, camera, 4);
        double error = 0;
        for (int c = 0; c < channels; ++c) {
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    const glm::dvec3 ray = ray_of(camera, x, y);
                    const glm::dvec3 local = glm::normalize(glm::transpose(some_rotation()) * ray);
                    const Stokes own = 1.5 * light->radiance(c, local);
                    const glm::dvec3 right = glm::normalize(glm::cross(ray, up));
                    const Frame to(right, glm::cross(-ray, right), -ray);
                    const Frame from = some_rotation() * theta_phi_frame(-local);
                    const Stokes expected = rotated(own, angle_between(from, to));
                    error = std::max(error, glm::distance(image.stokes(c, y, x), expected));
                }
            }
        }
        CAPTURES(channels, polarized);
        // Texture units interpolate with few bits.
        CHECK(error < gl::tolerance_of(context) * (polarized ? 5e-3 : 1e-5));
    });
}

TEST_CASE("OSMesa and EGL give the same floats") {
    Scene scene;
    scene.add({.mesh = test::fine_sphere(),
               .material = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.3})});
    scene.set_environment(rayleigh_sky({.sun_direction = {1, 1, 0.5}}), glm::dmat3(1.0), 1);
    const Camera camera = camera_at({1, 1, 3});
    const StokesImage egl = render(gl::make_context(gl::Backend::egl), scene, camera, 6);
    const StokesImage osmesa = render(gl::make_context(gl::Backend::osmesa), scene, camera, 6);
    CHECK(largest(egl) > 0.1F);
    CHECK(largest_difference(egl, osmesa) < 1e-5F * largest(egl));
}

GL_TEST_CASE("a diffuse surface under constant light has its albedo's radiance, and its back is black") {
    Scene scene;
    scene.add({.mesh = test::rectangle(2), .material = diffuse({0.25, 0.5})});
    scene.set_environment(constant_environment({2}), glm::dmat3(1.0), 3);
    const StokesImage front = render(context, scene, camera_at({0, 0, 1}), 4);
    CHECK(middle(front) == doctest::Approx(1.5).epsilon(1e-5));
    CHECK(middle(front, 1) == doctest::Approx(3).epsilon(1e-5));
    CHECK(middle(front, 0, 1) == 0);
    const StokesImage back = render(context, scene, camera_at({0, 0, -1}), 4);
    CHECK(middle(back) == 0);
}

GL_TEST_CASE("a two-sided surface is lit on both sides, each by the light it faces") {
    Scene scene;
    scene.add({.mesh = test::rectangle(2), .material = twosided(diffuse({0.5}))});
    // The light is brighter towards +z: s0 = 1 + z by the direction towards the light.
    EquirectImage image(64, 33, 1);
    for (int y = 0; y < 33; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double theta = pi * y / 32;
            const double phi = 2 * pi * (x + 0.5) / 64;
            image.at(0, y, x)[0] = static_cast<float>(1 - std::cos(phi) * std::sin(theta));
        }
    }
    scene.set_environment(image_environment(std::move(image)), glm::dmat3(1.0), 1);
    // A Lambertian surface under 1 + c z facing +-z reflects albedo (1 +- 2/3 c).
    const StokesImage front = render(context, scene, camera_at({0, 0, 1}), 8);
    CHECK(middle(front) == doctest::Approx(0.5 * (1 + 2.0 / 3)).epsilon(2e-3));
    const StokesImage back = render(context, scene, camera_at({0, 0, -1}), 8);
    CHECK(middle(back) == doctest::Approx(0.5 * (1 - 2.0 / 3)).epsilon(2e-3));
}

TEST_CASE("near things hide far ones whatever the order, and darkness is black") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    for (const bool near_first : {true, false}) {
        Scene scene;
        const Instance near{
            .mesh = test::rectangle(1), .material = diffuse({0.8}), .to_world = test::at(0, 0, 1, 0.5)};
        const Instance far{.mesh = near.mesh, .material = diffuse({0.2})};
        scene.add(near_first ? near : far);
        scene.add(near_first ? far : near);
        scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
        CHECK(middle(render(context, scene, camera_at({0, 0, 4}), 2)) == doctest::Approx(0.8).epsilon(1e-5));
        scene.set_environment(nullptr, glm::dmat3(1.0), 1);
        CHECK(largest(render(context, scene, camera_at({0, 0, 4}), 2)) == 0);
    }
}

TEST_CASE("what needs no work is counted, and another image or framebuffer is drawn") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    Scene scene;
    scene.add({.mesh = std::make_shared<const Mesh>(make_sphere()), .material = pplastic({})});
    scene.set_environment(constant_environment({1, 1, 1}), glm::dmat3(1.0), 1);
    Framebuffer target(context, width, height, 3);
    Renderer renderer(context);
    const auto run = [&](const Camera& camera) {
        renderer.render(scene, camera, {}, target);
        return target.statistics();
    };
    const Statistics first = run(camera_at({0, 0, 3}));
    CHECK(first.project_ms > 0);
    CHECK(first.relight_ms > 0);
    CHECK(first.vertices == 14442);
    CHECK(first.vertices_skipped > first.vertices / 3);
    CHECK(first.light_columns_skipped == 3);  // a single channel of grey light with only s0
    CHECK(first.channels_shared == 2);
    CHECK(first.response_rows_skipped == 3);  // three channels without s3

    const StokesImage image = target.image();
    CHECK(run(camera_at({0, 0, 3})).draw_ms == 0);
    // Another image in the framebuffer and another framebuffer both require drawing.
    Framebuffer other(context, width, height, 3);
    renderer.render(scene, camera_at({0, 0, 3}), {}, other);
    CHECK(other.statistics().draw_ms > 0);
    CHECK(largest_difference(image, other.image()) == 0);
    target.show(StokesImage(width, height, 3), {});
    CHECK(run(camera_at({0, 0, 3})).draw_ms > 0);
    CHECK(largest_difference(image, target.image()) == 0);
    RenderOptions unpolarized;
    unpolarized.components = 1;
    renderer.render(scene, camera_at({0, 0, 3}), unpolarized, target);
    CHECK(target.statistics().draw_ms > 0);
    CHECK(largest_difference(image, target.image()) > 0);
}

GL_TEST_CASE("framebuffers of one renderer keep their images and AOVs apart") {
    Scene scene;
    scene.add({.mesh = test::fine_sphere(), .material = pplastic({})});
    scene.set_environment(constant_environment({2}), glm::dmat3(1.0), 1);
    constexpr double distances[] = {3, 5};
    const RenderOptions options{.aovs = aov_depth};
    const auto rendered = [&](Renderer& renderer, double distance, Framebuffer& target) {
        renderer.render(scene, camera_at({0, 0, distance}), options, target);
    };
    Renderer renderer(context);
    Framebuffer targets[] = {{context, 8, 8, 1}, {context, 8, 8, 1}};
    // Nothing is read back until all is drawn, so that what is read lies on the device until then.
    for (int round = 0; round < 2; ++round)
        for (int i = 0; i < 2; ++i) rendered(renderer, distances[i], targets[i]);
    for (int i = 0; i < 2; ++i) {
        Renderer fresh(context);
        Framebuffer expected(context, 8, 8, 1);
        rendered(fresh, distances[i], expected);
        CHECK(targets[i].image().data == expected.image().data);
        CHECK(targets[i].aovs().depth == expected.aovs().depth);
    }
    CHECK(targets[0].aovs().depth != targets[1].aovs().depth);
}

GL_TEST_CASE("an image shown in a framebuffer is in memory and on the device") {
    constexpr int channels = Framebuffer::kGroup + 2;
    Framebuffer target(context, 5, 3, channels);
    StokesImage image(5, 3, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<float>(i) - 50;
    Statistics statistics;
    statistics.camera_rays = 7;
    target.show(image, statistics);
    CHECK(target.image().data == image.data);
    CHECK(target.statistics().camera_rays == 7);
    const std::size_t plane = image.data.size() / channels;
    for (int c = 0; c < channels; ++c) {
        std::vector<float> read(plane);
        context->run([&] {
            target.groups()[static_cast<std::size_t>(c / Framebuffer::kGroup)].read(c % Framebuffer::kGroup,
                                                                                    read);
        });
        CHECK(std::equal(read.begin(), read.end(),
                         image.data.begin() + static_cast<std::ptrdiff_t>(plane) * c));
    }
    for (const auto& [w, h, n] : {std::array{4, 3, channels}, {5, 4, channels}, {5, 3, channels - 1}})
        CHECK_THROWS_AS(target.show(StokesImage(w, h, n), statistics), Error);
    CHECK(target.image().data == image.data);
}

TEST_CASE("options and framebuffers that do not fit are refused") {
    const auto context = gl::make_context(gl::Backend::osmesa);
    Scene scene;
    scene.add({.mesh = test::fine_sphere(), .material = pplastic({})});
    Renderer renderer(context);
    Framebuffer target(context, 8, 8, 1);
    Framebuffer coloured(context, 8, 8, 3);
    const auto refuses = [&](const RenderOptions& options, Framebuffer& framebuffer) {
        CHECK_THROWS_AS(renderer.render(scene, camera_at({0, 0, 3}), options, framebuffer), Error);
    };
    for (const auto& [low, high] : {std::pair(-1, 9), {33, 33}, {5, 4}})
        refuses({.order_low = low, .order_high = high}, target);
    check_error(
        ErrorCode::invalid_argument, CALL(renderer.render(scene, camera_at({0, 0, 3}), {}, coloured)),
        "the framebuffer has 3 colour channels and the scene 1; give it those of nicol_scene_get_channels()");
    Framebuffer foreign(gl::make_context(gl::Backend::osmesa), 8, 8, 1);
    refuses({}, foreign);
    CHECK_THROWS_AS(Framebuffer(context, 0, 8, 1), Error);
    CHECK_THROWS_AS(Framebuffer(context, 1 << 20, 8, 1), Error);
    refuses({.order_low = 4, .order_high = 9, .progress = [](const char*, double) { return false; }}, target);
}
