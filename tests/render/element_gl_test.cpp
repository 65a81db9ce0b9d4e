// SPDX-License-Identifier: MIT
// Tests of polarization elements in front of the camera: closed forms, each pixel by hand, and the reference
// method.
#include "draw/sample_pattern.hpp"
#include "gl/contexts.hpp"
#include "image_difference.hpp"
#include "reference/camera_rays.hpp"
#include "reference/traced_scene.hpp"
#include "render/scenes.hpp"

using namespace nicol;
using Kind = PolarizationElement::Kind;
using test::at;
using test::camera_at;
using test::Studio;

namespace {

struct Way {
    const char* name;
    RenderOptions options;
};

/// Returns all ways to make an image. Elements act equally in each.
std::vector<Way> every_way() {
    std::vector<Way> ways;
    for (const Executor executor : {Executor::cpu, Executor::compute})
        for (const ShadeAt shade_at : {ShadeAt::vertices, ShadeAt::pixels})
            ways.push_back(
                {executor == Executor::cpu ? "threads" : "compute shaders",
                 {.executor = executor, .bake_directions = 256, .order_high = 4, .shade_at = shade_at}});
    ways.push_back({"reference", {.method = Method::reference, .samples = 4}});
    return ways;
}

PolarizationElement across(Kind kind, double degrees, double z, double size = 10) {
    return {.kind = kind, .to_world = at(0, 0, z, size), .angle = glm::radians(degrees)};
}

/// Returns the Stokes vector, equal in all pixels, of a bright background behind elements.
Stokes behind(Studio& render, const RenderOptions& options, const std::vector<PolarizationElement>& elements,
              const Camera& camera = camera_at({0, 0, 4})) {
    Scene scene;
    scene.set_environment(constant_environment({2}), glm::dmat3(1), 1);
    for (const PolarizationElement& element : elements) scene.add_element(element);
    Camera narrow = camera;
    narrow.fov = 1;
    const StokesImage image = render(scene, options, narrow);
    const auto first = image.at(0, 0, 0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t p = 0; p < 4; ++p) CHECK(std::abs(image.at(0, y, x)[p] - first[p]) < 1e-3F);
    return {first[0], first[1], first[2], first[3]};
}

/// Returns a ball over a floor under polarized light of three channels.
Scene still() {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(12),
               .material = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.25}),
               .to_world = at(0.2, 0.1, 0.1, 0.7)});
    scene.add({.mesh = test::rectangle(8), .material = diffuse({0.5}), .to_world = test::plate_at(-1, 2)});
    scene.set_environment(test::falling_light(4, true), glm::dmat3(1), 1);
    return scene;
}

/// Adds tilted elements of all kinds in front of, through and behind the ball, and across each other.
void add_elements(Scene& scene) {
    const auto tilted = [](double x, double y, double z, double size, double angle, const glm::dvec3& axis) {
        return glm::rotate(at(x, y, z, size), angle, axis);
    };
    scene.add_element(PolarizationElement{.kind = Kind::polarizer,
                                          .to_world = tilted(0.4, 0.6, 1, 0.9, 0.8, {1, 2, 0.3}),
                                          .angle = 0.5,
                                          .transmittance = 0.9});
    scene.add_element(PolarizationElement{.kind = Kind::retarder,
                                          .to_world = tilted(0.5, 0.4, 1, 0.8, -0.4, {0.3, 1, 1}),
                                          .angle = -0.3,
                                          .retardance = 1.2});
    scene.add_element(PolarizationElement{.kind = Kind::left_circular,
                                          .outline = PolarizationElement::Outline::disk,
                                          .to_world = tilted(0.2, 0, 0.1, 1.2, 1.1, {0.2, 1, 0})});
    scene.add_element(PolarizationElement{.kind = Kind::right_circular,
                                          .outline = PolarizationElement::Outline::disk,
                                          .to_world = tilted(-1, 1, 1, 0.5, 0.7, {0, 1, 0})});
    const auto map = [](int channels, TextureSampling::Filter filter) {
        TextureImage image{.width = 7, .height = 5, .channels = channels, .values = {}};
        for (int i = 0; i < 35 * channels; ++i)
            image.values.push_back(0.9F + 0.6F * std::sin(2.3F * float(i)));
        return image_texture(std::move(image), {.filter = filter});
    };
    scene.add_element({PolarizationElement{.kind = Kind::retarder,
                                           .to_world = tilted(-0.3, -0.2, 1.2, 0.9, 0.5, {1, 0.4, 0.2}),
                                           .angle = 0.6,
                                           .retardance = 1.4},
                       {.angle = map(1, TextureSampling::Filter::mipmap),
                        .retardance = map(3, TextureSampling::Filter::bilinear)}});
    scene.add_element(
        {PolarizationElement{.to_world = tilted(0.9, -0.5, 0.8, 0.4, -0.3, {1, 0, 0.2}), .angle = 1},
         {.angle = checkerboard_texture(glm::vec3(0.2F), glm::vec3(1.1F), 1)}});
}

/// Counts pixels that differ from `wanted` by more than 1e-4 of its brightest value. Such pixels lie at edges
/// of elements, where rounding decides.
std::size_t pixels_off(const StokesImage& image, const StokesImage& wanted) {
    const double tolerance = 1e-4 * static_cast<double>(largest(wanted));
    std::size_t off = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            double difference = 0;
            for (int c = 0; c < image.channels; ++c)
                for (std::size_t p = 0; p < 4; ++p)
                    difference =
                        std::max(difference,
                                 std::abs(static_cast<double>(image.at(c, y, x)[p] - wanted.at(c, y, x)[p])));
            off += difference > tolerance ? 1 : 0;
        }
    return off;
}

/// Applies the elements to an image without them, by the depths of its surfaces at one sample per pixel.
StokesImage filtered(const StokesImage& open, const Scene& scene, const Camera& camera,
                     const std::vector<float>& depths, const glm::dvec2& offset = glm::dvec2(0)) {
    const Projection projection = project(camera, open.width, open.height);
    const CameraRays rays(projection, open.width, open.height);
    const ElementsOnRay elements(scene.elements());
    StokesImage out = open;
    for (int y = 0; y < open.height; ++y)
        for (int x = 0; x < open.width; ++x) {
            Ray ray = rays.through(x + 0.5 + offset.x, y + 0.5 + offset.y);
            const double cosine = glm::dot(ray.direction, projection.view.forward);
            const auto depth = static_cast<double>(depths[static_cast<std::size_t>(y * open.width + x)]);
            ray.farthest = std::min(ray.farthest, depth / cosine);
            for (int c = 0; c < open.channels; ++c) {
                const std::optional<Mueller> m = elements.mueller(ray, rays.frame(ray), c);
                if (!m) continue;
                const auto pixel = out.at(c, y, x);
                const Stokes s = *m * Stokes(pixel[0], pixel[1], pixel[2], pixel[3]);
                for (std::size_t p = 0; p < 4; ++p) pixel[p] = static_cast<float>(s[static_cast<int>(p)]);
            }
        }
    return out;
}

}  // namespace

IMAGE_TEST_CASE("polarizers before a bright background follow Malus' law") {
    for (const Way& way : every_way()) {
        CAPTURE(way.name);
        Studio render(context, 4, 3);
        const auto s0_behind = [&](const std::vector<double>& angles) {
            std::vector<PolarizationElement> elements;
            for (const double angle : angles)
                elements.push_back(across(Kind::polarizer, angle, -1 + 0.5 * double(elements.size())));
            return behind(render, way.options, elements)[0];
        };
        CHECK(s0_behind({}) == doctest::Approx(2));
        CHECK(s0_behind({70}) == doctest::Approx(1));
        CHECK(s0_behind({0, 90}) < 1e-6);
        CHECK(s0_behind({20, 110}) < 1e-6);
        CHECK(s0_behind({0, 45, 90}) == doctest::Approx(0.25).epsilon(1e-4));
        CHECK(s0_behind({0, 90, 45}) < 1e-6);
        for (const double angle : {10.0, 30.0, 80.0}) {
            const double c = std::cos(glm::radians(angle));
            CHECK(s0_behind({0, angle}) == doctest::Approx(c * c).epsilon(1e-4));
            CHECK(s0_behind({0, angle, 90}) == doctest::Approx(c * c * (1 - c * c)).epsilon(1e-4));
        }
    }
}

IMAGE_TEST_CASE("a stressed sheet between crossed polarizers shows sin^2 2 theta sin^2 delta / 2") {
    // Each pixel shows one texel. The first row of an image is at the bottom.
    constexpr int columns = 16, rows = 12;
    const auto map = [](int channels, const auto& value) {
        TextureImage image{.width = columns, .height = rows, .channels = channels, .values = {}};
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x)
                for (int c = 0; c < channels; ++c) image.values.push_back(float(value(x, rows - 1 - y, c)));
        return image_texture(std::move(image), {.filter = TextureSampling::Filter::nearest});
    };
    const auto fast = [](int x, int y, int) { return 0.13 * y + 0.02 * x; };
    Camera camera = camera_at({0, 0, 4});
    camera.orthographic = true;
    for (const int channels : {1, 3}) {
        const auto delta = [](int x, int y, int c) { return (0.5 * x - 0.1 * y) * (1 + 0.2 * c); };
        Scene scene;
        scene.set_environment(constant_environment({2}), glm::dmat3(1), 1);
        scene.add_element(across(Kind::polarizer, 0, -1));
        scene.add_element(
            {PolarizationElement{.kind = Kind::retarder,
                                 .to_world = glm::scale(glm::dmat4(1), {1, double(rows) / columns, 1}),
                                 .angle = 0.5,
                                 .retardance = 2},
             {.angle = map(1, [&](int x, int y, int c) { return fast(x, y, c) / 0.5; }),
              .retardance = map(channels, [&](int x, int y, int c) { return delta(x, y, c) / 2; })}});
        scene.add_element(across(Kind::polarizer, 90, 1));
        CHECK(scene.channels() == channels);
        for (const Way& way : every_way()) {
            CAPTURE(way.name);
            Studio render(context, columns, rows);
            const StokesImage image = render(scene, way.options, camera);
            double most = 0;
            for (int y = 0; y < rows; ++y)
                for (int x = 0; x < columns; ++x)
                    for (int c = 0; c < channels; ++c) {
                        const double wanted =
                            std::pow(std::sin(2 * fast(x, y, 0)) * std::sin(delta(x, y, c) / 2), 2);
                        most = std::max(most, std::abs(double(image.at(c, y, x)[0]) - wanted));
                    }
            CHECK(most < 2e-5);
        }
    }
}

IMAGE_TEST_CASE(
    "a texture that replaces another, and colours that come with a texture, show in the next picture") {
    Scene scene;
    scene.set_environment(constant_environment({2}), glm::dmat3(1), 1);
    scene.add_element(across(Kind::polarizer, 0, -1));
    const PolarizationElement sheet = across(Kind::retarder, 45, 0);
    const auto with = [](const glm::vec3& factor, int channels) {
        return ElementTextures{.retardance = constant_texture(glm::vec4(factor, 1), channels)};
    };
    const std::uint32_t id = scene.add_element(sheet);
    scene.add_element(across(Kind::polarizer, 90, 1));
    Camera narrow = camera_at({0, 0, 4});
    narrow.fov = 1;
    for (const Way& way : every_way()) {
        CAPTURE(way.name);
        Studio render(context, 4, 3);
        const auto first = [&](int channel) {
            return render(scene, way.options, narrow).at(channel, 1, 2)[0];
        };
        scene.set_element(id, sheet);
        CHECK(first(0) == doctest::Approx(0.5).epsilon(1e-3));
        scene.set_element(id, {sheet, with(glm::vec3(2), 1)});
        CHECK(first(0) == doctest::Approx(1).epsilon(1e-3));
        scene.set_element(id, {sheet, with({0, 1, 2}, 3)});
        for (const int channel : {0, 1, 2})
            CHECK(first(channel) == doctest::Approx(0.5 * channel).epsilon(1e-3));
    }
}

IMAGE_TEST_CASE("elements act in the order in which light meets them, from either side") {
    const std::vector<PolarizationElement> elements{across(Kind::retarder, 45, 1),
                                                    across(Kind::polarizer, 0, 0)};
    for (const Way& way : every_way()) {
        CAPTURE(way.name);
        Studio render(context, 4, 3);
        CHECK(glm::distance(behind(render, way.options, elements), {1, 0, 0, 1}) < 1e-3);
        // Seen from behind, light meets the wave plate first, which leaves unpolarized light unchanged.
        const Stokes from_behind = behind(render, way.options, elements, camera_at({0, 0, -4}));
        CHECK(glm::distance(from_behind, {1, 1, 0, 0}) < 1e-3);
        CHECK(glm::distance(behind(render, way.options, {across(Kind::left_circular, 0, 0)}), {1, 0, 0, -1}) <
              1e-3);
    }
}

IMAGE_TEST_CASE("elements that the camera cannot see do nothing") {
    Camera camera = camera_at({0, 0, 4});
    camera.near_clip = 1;
    camera.far_clip = 100;
    for (const Way& way : every_way()) {
        CAPTURE(way.name);
        Studio render(context, 4, 3);
        for (const double z : {5.0, 3.1, -97.0})  // behind the camera, too near, too far
            CHECK(glm::distance(behind(render, way.options, {across(Kind::polarizer, 0, z)}, camera),
                                {2, 0, 0, 0}) < 1e-6);
        CHECK(behind(render, way.options, {across(Kind::polarizer, 0, 2.9)}, camera)[0] ==
              doctest::Approx(1));
    }
}

IMAGE_TEST_CASE("an element behind a surface does nothing to it") {
    Scene scene = still();
    for (const Way& way : every_way()) {
        CAPTURE(way.name);
        Studio render(context, 32, 24);
        Camera camera = camera_at({0.2, 0.1, 4}, {0.2, 0.1, 0});
        camera.fov = 12;  // the image shows only the ball
        const StokesImage open = render(scene, way.options, camera);
        const std::uint32_t id = scene.add_element(across(Kind::polarizer, 0, -0.5));
        CHECK(render(scene, way.options, camera).data == open.data);
        scene.set_element(id, across(Kind::polarizer, 0, 1));
        CHECK(pixels_off(render(scene, way.options, camera), open) == 32 * 24);
        scene.remove_element(id);
        CHECK(render(scene, way.options, camera).data == open.data);
    }
}

IMAGE_TEST_CASE("each pixel is what its elements make of what is behind") {
    Camera cameras[] = {test::some_camera(), test::some_camera()};
    cameras[0].jitter = {0.3, -0.2};
    cameras[1].orthographic = true;
    cameras[1].to_world = look_at({2, 3, 4}, {0, 0, 0}, {0, 1, 0}) * at(0, 0, 0, 1.5);
    Scene scene = still();
    Scene with_elements = scene;
    add_elements(with_elements);
    for (const Way& way : every_way()) {
        if (way.options.method == Method::reference) continue;
        CAPTURE(way.name);
        Studio render(context);
        for (const Camera& camera : cameras) {
            RenderOptions options = way.options;
            options.aovs = aov_depth;
            Framebuffer target(context, render.width, render.height, 3);
            render.renderer.render(scene, camera, options, target);
            const StokesImage wanted = filtered(target.image(), with_elements, camera, target.aovs().depth);
            const StokesImage found = render(with_elements, options, camera);
            CHECK(pixels_off(wanted, target.image()) > 600);
            CHECK(pixels_off(found, wanted) <= 6);
        }
    }
}

IMAGE_TEST_CASE("samples of a pixel have each their own elements") {
    Scene scene;
    scene.set_environment(constant_environment({2}), glm::dmat3(1), 1);
    scene.add_element(PolarizationElement{.to_world = glm::rotate(at(0.1, -0.2, 0, 0.6), 0.5, {0.3, 0.2, 1}),
                                          .angle = 0.2});
    scene.add_element(PolarizationElement{.to_world = at(-0.4, 0.1, 0.5, 0.6), .angle = 1.3});
    const Camera camera = camera_at({0, 0, 4});
    for (const Way& way : every_way()) {
        if (way.options.method == Method::reference) continue;
        CAPTURE(way.name);
        Studio render(context, 16, 12);
        RenderOptions options = way.options;
        options.pixel_samples = 8;
        StokesImage open(16, 12, 1);
        for (std::size_t i = 0; i < open.data.size(); i += 4) open.data[i] = 2;
        const std::vector<float> sky(16 * 12, std::numeric_limits<float>::infinity());
        StokesImage mean(16, 12, 1);
        for (const glm::dvec2& offset : sample_pattern(8)) {
            const StokesImage one = filtered(open, scene, camera, sky, offset);
            for (std::size_t i = 0; i < mean.data.size(); ++i) mean.data[i] += one.data[i] / 8;
        }
        CHECK(pixels_off(render(scene, options, camera), mean) == 0);
        CHECK(pixels_off(render(scene, way.options, camera), mean) > 10);
    }
}

IMAGE_TEST_CASE("the components that an image has are those of all four") {
    Scene scene = still();
    add_elements(scene);
    for (const Way& way : every_way()) {
        if (way.options.method == Method::reference) continue;
        CAPTURE(way.name);
        Studio render(context);
        const StokesImage full = render(scene, way.options);
        for (const int components : {1, 3}) {
            RenderOptions fewer = way.options;
            fewer.components = components;
            StokesImage wanted = full;
            for (std::size_t i = 0; i < wanted.data.size(); ++i)
                if (i % 4 >= static_cast<std::size_t>(components)) wanted.data[i] = 0;
            CHECK(test::rms_difference(render(scene, fewer), wanted) < 1e-6);
        }
    }
}

IMAGE_TEST_CASE("methods agree behind elements") {
    Scene scene;
    scene.set_environment(test::falling_light(4, true, 1), glm::dmat3(1), 1);
    add_elements(scene);
    Studio render(context);
    const StokesImage truth = render(scene, RenderOptions{.method = Method::reference, .samples = 64});
    const StokesImage image = render(scene, RenderOptions{.executor = Executor::cpu, .pixel_samples = 8});
    CHECK(test::rms_difference(image, truth) < 0.025 * test::rms(truth));
}

TEST_CASE("elements of a scene have ids, and are checked") {
    Scene scene;
    const Version before = scene.element_version();
    CHECK(scene.add_element(PolarizationElement{}) == 0);
    CHECK(scene.add_element(PolarizationElement{.kind = Kind::retarder}) == 1);
    CHECK(scene.element_version() > before);
    scene.remove_element(0);
    CHECK(scene.element_ids() == std::vector<std::uint32_t>{1});
    CHECK(scene.element(1).kind == Kind::retarder);
    const auto refused = ErrorCode::invalid_argument;
    check_error(refused, CALL(scene.element(0)), "no element 0; it was removed");
    check_error(refused, CALL(scene.set_element(2, PolarizationElement{})), "no element 2");
    check_error(refused, CALL(scene.set_element(1, PolarizationElement{.transmittance = 2})),
                "transmittance");
    check_error(refused, CALL(scene.add_element(PolarizationElement{.to_world = glm::dmat4(0.0)})),
                "to_world");
    const TexturePtr of_mesh = mesh_color_texture(ColorsOf::vertices);
    const PolarizationElement polarizer, retarder{.kind = Kind::retarder};
    check_error(refused, CALL(scene.add_element({polarizer, {.angle = of_mesh}})),
                "angle of an element has the colours");
    check_error(refused, CALL(scene.set_element(1, {retarder, {.retardance = of_mesh}})),
                "retardance of an element has");
    const auto colors = [](int channels) {
        return ElementTextures{.retardance = constant_texture(glm::vec4(1), channels)};
    };
    check_error(refused, CALL(scene.add_element({retarder, colors(4)})),
                "has 4 channels; it must have 1 or 3");
    CHECK(scene.channels() == 1);
    const std::uint32_t colored = scene.add_element({retarder, colors(3)});
    CHECK(scene.channels() == 3);
    scene.set_element(colored, {polarizer, colors(3)});  // without an effect
    CHECK(scene.channels() == 1);
    scene.remove_element(colored);
    CHECK(scene.channels() == 1);
    scene.set_environment(constant_environment({1, 2}), glm::dmat3(1), 1);
    check_error(refused, CALL(scene.add_element({retarder, colors(3)})),
                "the element has 3 colour channels and the scene 2");
    CHECK(scene.element(1).transmittance == 1);
    CHECK(scene.elements().size() == 1);
}

TEST_CASE(
    "angles and retardances of elements, and their textures' multiples of them, keep to a million degrees") {
    Scene scene;
    const auto refused = [&](const SceneElement& element, const char* part) {
        CAPTURE(part);
        check_error(ErrorCode::invalid_argument, CALL(scene.add_element(element)), part);
    };
    const auto retarder = [](double degrees) {
        return PolarizationElement{.kind = Kind::retarder, .retardance = glm::radians(degrees)};
    };
    for (const double sign : {-1.0, 1.0}) {
        scene.add_element(retarder(sign * 1e6));
        scene.add_element(PolarizationElement{.angle = glm::radians(sign * 1e6)});
        refused(retarder(sign * 1.1e6), "retardance of an element is");
        refused(PolarizationElement{.angle = sign * 1e300}, "angle of an element is");
    }
    refused(retarder(std::nan("")), "retardance of an element is");
    const auto image = [](int channels, std::vector<float> values) {
        return image_texture({.width = 2, .height = 1, .channels = channels, .values = std::move(values)});
    };
    const TexturePtr large = image(1, {0, -4e5F}), blue = image(3, {0, 0, 0, 0, 0, 4e5F});
    for (const TexturePtr& texture : {large, blue}) {
        scene.add_element({retarder(2), {.retardance = texture}});
        refused({retarder(3), {.retardance = texture}}, "retardance of an element times its texture");
    }
    scene.add_element({PolarizationElement{.angle = glm::radians(2.0)}, {.angle = large}});
    refused({PolarizationElement{.angle = glm::radians(3.0)}, {.angle = large}},
            "angle of an element times its texture");
    const TexturePtr board = checkerboard_texture(glm::vec3(0), glm::vec3(1e30F), 1);
    refused({retarder(1), {.retardance = board}}, "retardance of an element times its texture");
}
