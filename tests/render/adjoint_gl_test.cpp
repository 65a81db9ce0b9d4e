// SPDX-License-Identifier: MIT
// Tests of gradients: the inner product of a picture of some light with a picture is that of the light with
// the picture's gradient. Everything that the adjoint does not transpose is refused.
#include <numeric>

#include "gl/contexts.hpp"
#include "material/chiral_material.hpp"
#include "material/plastic.hpp"
#include "render/scenes.hpp"
#include "render/textured.hpp"

using namespace nicol;
using test::Studio;

namespace {

constexpr int kOrder = 4;

RenderOptions options() {
    return {.executor = Executor::cpu,  // the gradient's
            .bake_directions = 512,
            .order_low = kOrder,
            .order_high = kOrder,
            .shade_at = ShadeAt::pixels,
            .split_lights = 0,
            .disabled_optimisations = skip_light_components};
}

double random(std::mt19937& generator) {
    return std::uniform_real_distribution<double>(-1, 1)(generator);
}

PshVector random_light(int order, int channels, unsigned seed) {
    std::mt19937 generator(seed);
    PshVector light(order, channels);
    for (int c = 0; c < channels; ++c)
        for (int l = 0; l <= order; ++l)
            for (int m = -l; m <= l; ++m)
                for (int p = 0; p < 4; ++p)
                    if (l > 1 || p == 0 || p == 3) light.at(c, l, m, p) = random(generator);
    return light;
}

StokesImage random_picture(int width, int height, int channels) {
    std::mt19937 generator(7);
    StokesImage picture(width, height, channels);
    for (float& number : picture.data) number = static_cast<float>(random(generator));
    return picture;
}

template <class A, class B>
double product(const A& a, const B& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum;
}

/// Returns the largest difference of inner products that rounding explains.
double tolerance(const StokesImage& a, const StokesImage& b) {
    return 1e-6 * std::sqrt(product(a.data, a.data) * product(b.data, b.data));
}

TexturePtr colors() {
    return test::texture_of(
        [](const TexturePoint& p) { return glm::vec4(0.2F + 0.6F * p.uv.x, 0.5F, 0.9F - 0.5F * p.uv.y, 1); },
        3);
}

/// Returns a ball of a material over a floor, under the light.
Scene still(const MaterialPtr& ball, const PshVector& light) {
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(8), .material = ball, .to_world = test::at(0.2, 0.1, 0.1, 0.7)});
    scene.add({.mesh = test::with_texcoords(make_rectangle(12)),
               .material = diffuse(colors()),
               .to_world = test::plate_at(-1, 2)});
    scene.set_environment(psh_environment(light),
                          glm::dmat3(glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(0.3, 1, 0.2))), 1.7);
    scene.hide_emitters(true);
    return scene;
}

void add_lights(Scene& scene) {
    const PolarizationState state{.dolp = 0.8, .aolp = 0.4, .docp = -0.5, .axis = {0.3, 1, 0.2}};
    scene.add_light({.value = {20, 10, 15},
                     .to_world = look_at({1, 3, 1.5}, glm::dvec3(0), {0.1, 1, 0.2}),
                     .state = state});
    scene.add_light({.kind = LocalLight::Kind::directional,
                     .value = {2},
                     .to_world = look_at({-1, 3, 1.5}, glm::dvec3(0), {0.1, 1, 0.2}),
                     .angular_radius = 0.2});
}

struct Case {
    const char* name;
    MaterialPtr ball;
    std::function<void(RenderOptions&)> change = [](RenderOptions&) {};
};

const std::vector<Case>& cases() {
    static const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.6, 0.3, 0.1}, .alpha = 0.25});
    static const std::vector<Case> all{
        {"plastic", plastic},
        {"metal of one channel", test::some_metal(0.3)},
        {"metal without mirror symmetry", test::chiral(test::some_metal(0.4))},
        {"no shadows", plastic, [](RenderOptions& o) { o.shadows = false; }},
        {"order 10", plastic, [](RenderOptions& o) { o.order_low = o.order_high = 10; }},
        {"window", plastic, [](RenderOptions& o) { o.dering = 0.01; }},
        {"four samples", plastic, [](RenderOptions& o) { o.pixel_samples = 4; }},
        {"bounces", plastic, [](RenderOptions& o) { o.max_depth = 4; }},
        {"linear components", plastic, [](RenderOptions& o) { o.components = 3; }},
    };
    return all;
}

}  // namespace

GL_TEST_CASE("the gradient by the environment is the transpose of the picture") {
    for (const Case& of : cases()) {
        CAPTURE(of.name);
        RenderOptions chosen = options();
        of.change(chosen);
        Studio studio(context);
        const PshVector light = random_light(chosen.order_low, 3, 1);
        const Scene scene = still(of.ball, light);
        const StokesImage picture = studio(scene, chosen);
        const StokesImage gradient = random_picture(picture.width, picture.height, 3);
        const Gradients found =
            studio.renderer.adjoint(scene, test::some_camera(), chosen, gradient, {.environment = true});
        CHECK(std::abs(product(light.data(), found.environment.data()) -
                       product(picture.data, gradient.data)) < tolerance(picture, gradient));
    }
}

GL_TEST_CASE("gradients by lights and by instances are transposes of the picture") {
    for (const Case& of : cases()) {
        CAPTURE(of.name);
        RenderOptions chosen = options();
        of.change(chosen);
        if (chosen.max_depth > kDirectLightDepth) continue;  // refused
        Studio studio(context);
        Scene scene = still(of.ball, random_light(chosen.order_low, 3, 1));
        add_lights(scene);
        const StokesImage both = studio(scene, chosen);
        const StokesImage gradient = random_picture(both.width, both.height, 3);
        const Gradients found =
            studio.renderer.adjoint(scene, test::some_camera(), chosen, gradient,
                                    {.environment = true, .lights = true, .instances = true});
        std::vector<double> stokes;
        for (const LocalLight& light : scene.lights())
            for (std::size_t c = 0; c < 3; ++c)
                for (glm::length_t p = 0; p < 4; ++p)
                    stokes.push_back(light.value[light.value.size() == 1 ? 0 : c] * light.state.stokes()[p]);
        const double all = product(both.data, gradient.data), most = tolerance(both, gradient);
        const double of_environment =
            product(random_light(chosen.order_low, 3, 1).data(), found.environment.data());
        CHECK(std::abs(of_environment + product(stokes, found.lights) - all) < most);
        CHECK(std::abs(std::accumulate(found.instances.begin(), found.instances.end(), 0.0) - all) < most);
    }
}

GL_TEST_CASE("the gradient by an instance is the derivative by the reflectance of its diffuse material") {
    constexpr double reflectance = 0.5, step = 1e-2;
    Studio studio(context);
    const auto scene_of = [&](double of_floor) {
        Scene scene = still(test::some_metal(0.3), random_light(kOrder, 3, 1));
        add_lights(scene);
        scene.set_material(1, diffuse({of_floor}));
        return scene;
    };
    const Scene scene = scene_of(reflectance);
    const StokesImage above = studio(scene_of(reflectance + step), options());
    const StokesImage below = studio(scene_of(reflectance - step), options());
    const StokesImage gradient = random_picture(above.width, above.height, 3);
    const Gradients found =
        studio.renderer.adjoint(scene, test::some_camera(), options(), gradient, {.instances = true});
    const double difference =
        (product(above.data, gradient.data) - product(below.data, gradient.data)) / (2 * step);
    const double of_floor = std::accumulate(found.instances.begin() + 3, found.instances.end(), 0.0);
    CHECK(of_floor / reflectance == doctest::Approx(difference).epsilon(1e-4));
}

GL_TEST_CASE("the gradient by texels is the derivative by a texture") {
    using Filter = TextureSampling::Filter;
    struct Textured {
        const char* name;
        MaterialPtr (*make)(const TexturePtr& texture);
        int channels = 3;
        Filter filter = Filter::mipmap;
    };
    const std::vector<Textured> all{
        {"diffuse", [](const TexturePtr& t) { return diffuse(t); }},
        {"grey, nearest", [](const TexturePtr& t) { return diffuse(t); }, 1, Filter::nearest},
        {"plastic, whose coat reflects inside again",
         [](const TexturePtr& t) {
             return plastic({.diffuse_reflectance = t, .alpha = 0.3, .nonlinear = true});
         }},
        {"weight of a blend",
         [](const TexturePtr& t) {
             return blend(diffuse({0.7, 0.2, 0.1}), test::some_metal(0.4), t);
         },
         1, Filter::bilinear},
        {"product with another texture, on a perturbed surface",
         [](const TexturePtr& t) {
             return normal_mapped(
                 scaled(diffuse(t),
                        image_texture({.width = 2, .height = 1, .channels = 1, .values = {0.4F, 0.9F}})),
                 test::texture_of(
                     [](const TexturePoint& p) { return glm::vec4(0.5F + 0.2F * p.uv.x, 0.5F, 0.9F, 1); }));
         }},
    };
    // Texels of 0.3 to 0.7, and of the same picture a little changed.
    constexpr int side = 6;
    const auto image_of = [](int channels, float change) {
        std::mt19937 generator(5);
        TextureImage image{.width = side, .height = side, .channels = channels, .values = {}};
        for (int i = 0; i < side * side * channels; ++i) {
            const auto value = static_cast<float>(0.5 + 0.2 * random(generator));
            image.values.push_back(value + change * static_cast<float>(random(generator)));
        }
        return image;
    };
    for (const Textured& of : all)
        for (const bool shadows : {true, false}) {
            CAPTURE(of.name);
            CAPTURE(shadows);
            RenderOptions chosen = options();
            chosen.shadows = shadows;
            Studio studio(context);
            constexpr float step = 0.01F;
            const auto value_of = [&](float change, Gradients* found) {
                const TexturePtr texture =
                    image_texture(image_of(of.channels, change), {.filter = of.filter});
                Scene scene = still(test::some_metal(0.3), random_light(kOrder, 3, 1));
                add_lights(scene);
                scene.set_material(1, of.make(texture));
                const StokesImage picture = studio(scene, chosen);
                const StokesImage gradient = random_picture(picture.width, picture.height, 3);
                if (found != nullptr)
                    *found = studio.renderer.adjoint(scene, test::some_camera(), chosen, gradient,
                                                     {.instances = true, .texture = texture});
                return product(picture.data, gradient.data);
            };
            Gradients found;
            value_of(0, &found);
            const std::vector<float> from = image_of(of.channels, 0).values;
            std::vector<float> change = image_of(of.channels, 1).values;
            REQUIRE(found.texels.size() == from.size());
            for (std::size_t i = 0; i < from.size(); ++i) change[i] -= from[i];
            const double difference =
                (value_of(step, nullptr) - value_of(-step, nullptr)) / (2 * double{step});
            CHECK(product(found.texels, change) == doctest::Approx(difference).epsilon(1e-4));
        }
}

GL_TEST_CASE("the adjoint refuses textures that it has no gradient of") {
    const auto image = [](float other) {
        return image_texture({.width = 2, .height = 1, .channels = 1, .values = {0.5F, other}});
    };
    const TexturePtr wanted = image(0.6F);
    struct Refusal {
        const char* word;
        MaterialPtr floor;
        TexturePtr texture;
        ErrorCode code = ErrorCode::unsupported;
    };
    const MaterialPtr white = diffuse({0.5});
    for (const Refusal& refusal :
         std::vector<Refusal>{{"equal texels", white, image(0.5F)},
                              {"texture of an image", white, mesh_color_texture(ColorsOf::vertices)},
                              {"opacity", masked(scaled(white, wanted), wanted), wanted},
                              {"normals", bump_mapped(scaled(white, wanted), wanted, 1), wanted},
                              {"multiplies", scaled(white, product_texture(wanted, image(0.7F))), wanted},
                              {"roughness", rough_conductor({.eta = {{0.2, -3.0}}, .alpha = wanted}), wanted},
                              {"no instance", white, wanted, ErrorCode::invalid_argument}}) {
        CAPTURE(refusal.word);
        Studio studio(context);
        Scene scene = still(test::some_metal(0.3), random_light(kOrder, 3, 1));
        scene.set_material(1, refusal.floor);
        check_error(refusal.code,
                    CALL(studio.renderer.adjoint(scene, test::some_camera(), options(), StokesImage(8, 8, 3),
                                                 {.texture = refusal.texture})),
                    refusal.word);
    }
    Scene scene = still(test::some_metal(0.3), random_light(kOrder, 3, 1));
    scene.set_material(1, scaled(white, wanted));
    scene.set_emission(0, std::make_shared<const Emission>(Emission{.radiance = {1}, .texture = wanted}));
    Studio studio(context);
    const auto check_refused = [&](const char* word) {
        check_error(ErrorCode::unsupported,
                    CALL(studio.renderer.adjoint(scene, test::some_camera(), options(), StokesImage(8, 8, 3),
                                                 {.texture = wanted})),
                    word);
    };
    check_refused("emit");
    scene.set_emission(0, nullptr);
    scene.add_light({.kind = LocalLight::Kind::projector, .texture = product_texture(image(0.7F), wanted)});
    check_refused("projects");
}

GL_TEST_CASE("gradients by texels need memory that a limit leaves to those by lights") {
    const TexturePtr texture =
        image_texture({.width = 2, .height = 1, .channels = 1, .values = {0.5F, 0.6F}});
    Scene scene = still(test::some_metal(0.3), random_light(kOrder, 3, 1));
    scene.set_material(1, scaled(diffuse({0.5}), texture));
    const RenderOptions chosen = options();
    const GradientMemory gradients = gradient_memory(scene, chosen, nullptr);
    Studio studio(context);
    studio.renderer.set_memory_limit(MemoryLimit(estimate_memory(scene, chosen).total() +
                                                 image_memory(scene, chosen, 8, 8) + gradients.of_vertices));
    const auto run = [&](const WantedGradients& wanted) {
        return studio.renderer.adjoint(scene, test::some_camera(), chosen, StokesImage(8, 8, 3), wanted);
    };
    CHECK(run({.environment = true}).environment.order() == kOrder);
    check_error(ErrorCode::out_of_memory, CALL(run({.texture = texture})), "memory_limit");
}

GL_TEST_CASE("the adjoint refuses what it does not transpose") {
    struct Refusal {
        const char* word;  ///< of the message
        std::function<void(RenderOptions&, Scene&)> change;
        ErrorCode code = ErrorCode::unsupported;
        WantedGradients wanted = {.environment = true, .lights = true, .instances = true};
    };
    const std::vector<Refusal> refusals{
        {"physical", [](auto& o, auto&) { o.physical = true; }},
        {"order_low", [](auto& o, auto&) { o.choose_orders = true; }},
        {"order_high", [](auto& o, auto&) { o.order_high = 9; }},
        {"shade_at", [](auto& o, auto&) { o.shade_at = ShadeAt::vertices; }},
        {"shade_at",
         [](auto& o, auto& s) {
             o.shade_at = ShadeAt::automatic, o.tolerance = 1e3;
             s.remove(1), s.remove_light(0), s.remove_light(1);
         }},
        {"pixel_samples", [](auto& o, auto&) { o.pixel_samples = 5; }},
        {"filter", [](auto& o, auto&) { o.filter.kind = ReconstructionFilter::Kind::tent; }},
        {"method", [](auto& o, auto&) { o.method = Method::reference; }},
        {"time_budget_ms", [](auto& o, auto&) { o.time_budget_ms = 5; }},
        {"max_depth", [](auto& o, auto&) { o.max_depth = 3; }},
        {"mirrors",
         [](auto&, auto& s) {
             s.set_material(0, rough_conductor({.eta = {{0.2, -3.0}}, .alpha = 0}));
         }},
        {"elements", [](auto&, auto& s) { s.add_element(PolarizationElement{}); }},
        {"background", [](auto&, auto& s) { s.hide_emitters(false); }},
        {"split_lights",
         [](auto& o, auto& s) {
             o.split_lights = 1;
             s.set_environment(test::lamp(), glm::dmat3(1), 1);
         }},
        {"emissive", [](auto&, auto& s) { s.set_emission(1, std::make_shared<const Emission>()); }},
        {"environment", [](auto&, auto& s) { s.set_environment(nullptr, glm::dmat3(1), 1); },
         ErrorCode::invalid_argument},
        {"light 1", [](auto&, auto& s) { s.set_light(1, {.value = {0}}); }, ErrorCode::invalid_argument},
    };
    for (const Refusal& refusal : refusals) {
        CAPTURE(refusal.word);
        RenderOptions chosen = options();
        Scene scene = still(test::some_metal(0.3), random_light(kOrder, 3, 1));
        add_lights(scene);
        refusal.change(chosen, scene);
        Studio studio(context);
        check_error(refusal.code,
                    CALL(studio.renderer.adjoint(scene, test::some_camera(), chosen, StokesImage(8, 8, 3),
                                                 refusal.wanted)),
                    refusal.word);
    }
    Studio studio(context);
    const Scene scene = still(test::some_metal(0.3), random_light(kOrder, 3, 1));
    check_error(ErrorCode::invalid_argument,
                CALL(studio.renderer.adjoint(scene, test::some_camera(), options(), StokesImage(8, 8, 1),
                                             {.environment = true})),
                "1 colour channels");
}
