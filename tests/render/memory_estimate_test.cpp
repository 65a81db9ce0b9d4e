// SPDX-License-Identifier: MIT
// Tests of what the memory limit says of light that smooth surfaces focus, and of textures of elements.
#include "render/memory_estimate.hpp"

#include "material/dielectric.hpp"
#include "methods/bounce_columns.hpp"
#include "render/scenes.hpp"
#include "surfaces/photon_paths.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr std::uint64_t kMegabyte = 1 << 20;

RenderOptions bouncing() {
    return {.bake_directions = 512, .max_depth = 4};
}

/// Returns a ball above a floor under a lamp.
Scene lit_ball(const MaterialPtr& of_ball) {
    Scene scene;
    scene.add({.mesh = test::rectangle(8), .material = diffuse({0.5}), .to_world = test::plate_at(-1.2, 3)});
    scene.add({.mesh = test::coarse_sphere(6), .material = of_ball});
    scene.add_light(LocalLight());
    return scene;
}

MaterialPtr mirror() {
    return conductor({{0.0, -100.0}});
}

}  // namespace

TEST_CASE("light that a mirror focuses leaves the limit of refinement nearly as it is") {
    const RenderOptions options = bouncing();
    const auto most = [&](const MaterialPtr& of_ball, std::uint64_t bytes) {
        MemoryLimit limit(bytes);
        limit.check(lit_ball(of_ball), options, 64, 64);
        return limit.max_vertices(options);
    };
    const std::uint64_t focused = estimate_memory(lit_ball(mirror()), options).focused;
    REQUIRE(focused > 16 * kMegabyte);
    const std::uint64_t plain = most(diffuse({0.5}), 128 * kMegabyte);
    REQUIRE(plain < most(diffuse({0.5}), MemoryLimit::kNone));
    CHECK(static_cast<double>(most(mirror(), 128 * kMegabyte + focused)) ==
          doctest::Approx(static_cast<double>(plain)).epsilon(0.1));
    CHECK(most(mirror(), 256 * kMegabyte) > plain);
}

TEST_CASE("the memory beside an image has the textures of elements, and one that several share once") {
    Scene scene = lit_ball(diffuse({0.5}));
    const RenderOptions options;
    const auto image = [&] { return image_memory(scene, options, 64, 64); };
    const auto map = [](int width, int height) {
        std::vector<float> values(static_cast<std::size_t>(width * height), 1);
        values.front() = 2;  // equal ones would be no image
        return image_texture({.width = width, .height = height, .channels = 1, .values = std::move(values)});
    };
    const PolarizationElement retarder{.kind = PolarizationElement::Kind::retarder};
    const std::uint32_t id = scene.add_element(retarder);
    const std::uint64_t plain = image();
    const TexturePtr angle = map(30, 20);
    scene.set_element(id, {retarder, {.angle = angle}});
    const std::uint64_t texels = image() - plain;
    CHECK(texels == 4 * 30 * 20);
    scene.set_element(id, {retarder, {.angle = angle, .retardance = angle}});
    CHECK(image() - plain == texels);
    const std::uint32_t other = scene.add_element(retarder);
    const std::uint64_t two = image();
    CHECK(two > plain + texels);
    scene.set_element(other, {retarder, {.retardance = angle}});
    CHECK(image() == two);
    scene.set_element(other, {retarder, {.retardance = map(50, 10)}});
    CHECK(image() - two == 4 * 50 * 10);
}

TEST_CASE("bounces under lamps alone count with their own order, which a distant light takes from them") {
    RenderOptions options = bouncing();
    options.order_low = kBounceOrder;
    RenderOptions higher = options;
    higher.order_low = kLocalBounceOrder;
    const auto total = [](const Scene& of, const RenderOptions& with) {
        return estimate_memory(of, with).total() + image_memory(of, with, 64, 64);
    };
    Scene scene = lit_ball(diffuse({0.5}));
    CHECK(total(scene, options) == total(scene, higher));
    MemoryLimit limit(128 * kMegabyte), fresh(128 * kMegabyte);
    limit.check(scene, options, 64, 64);
    const std::uint64_t before = limit.max_vertices(options);
    scene.set_environment(test::falling_light(9, true, 3), glm::dmat3(1), 1);
    CHECK(total(scene, options) < total(scene, higher));
    limit.check(scene, options, 64, 64);
    fresh.check(scene, options, 64, 64);
    CHECK(limit.max_vertices(options) == fresh.max_vertices(options));
    CHECK(limit.max_vertices(options) != before);
}

TEST_CASE("a refined scene asks for the memory of focused light once") {
    const RenderOptions options = bouncing();
    const Scene scene = lit_ball(mirror());
    const MemoryEstimate estimate = estimate_memory(scene, options);
    const std::uint64_t image = image_memory(scene, options, 64, 64);
    std::uint64_t vertices = 0;
    for (const Instance& instance : scene.instances()) vertices += instance.mesh->positions.size();
    std::int64_t asked = 0;
    MemoryLimit limit(MemoryLimit::kNone, [&](std::int64_t bytes) {
        asked += bytes;
        return true;
    });
    const std::uint64_t constant = estimate.focused + image, rest = estimate.visibility + estimate.transfer;
    limit.check(scene, options, 64, 64);
    CHECK(asked == static_cast<std::int64_t>(constant + rest));
    limit.refined(4 * vertices);
    CHECK(asked == static_cast<std::int64_t>(constant + 4 * rest));
}

TEST_CASE(
    "the estimate counts both sides of surfaces that focus light, and none where no rays are followed") {
    RenderOptions options = bouncing();
    const auto focused = [&](const MaterialPtr& of_ball) {
        return estimate_memory(lit_ball(of_ball), options).focused;
    };
    CHECK(focused(mirror()) == most_focused_bytes(1, 1, 1));
    CHECK(focused(twosided(mirror())) == most_focused_bytes(2, 1, 1));
    CHECK(focused(diffuse({0.5})) == 0);
    options.executor = Executor::compute;
    CHECK(focused(mirror()) == 0);
    // Threads render glass, whatever executor is asked for.
    CHECK(focused(dielectric({.int_ior = 1.5, .ext_ior = 1})) == most_focused_bytes(1, 1, 1));
}

TEST_CASE("the limit counts gradients beside the picture") {
    RenderOptions options = bouncing();
    options.max_depth = kDirectLightDepth;
    const Scene scene = lit_ball(diffuse({0.5}));
    TextureImage image{.width = 8, .height = 4, .channels = 3, .values = {}};
    for (int i = 0; i < 8 * 4 * 3; ++i) image.values.push_back(0.01F * static_cast<float>(i));
    const TexturePtr mipmap = image_texture(image, {.filter = TextureSampling::Filter::mipmap});
    const TexturePtr bilinear = image_texture(image, {.filter = TextureSampling::Filter::bilinear});
    const GradientMemory light = gradient_memory(scene, options, nullptr);
    const GradientMemory texels = gradient_memory(scene, options, mipmap.get());
    CHECK(light.texels == 0);
    CHECK(texels.of_vertices == 2 * light.of_vertices);
    // Levels of 8 x 4, 4 x 2, 2 x 1 and 1 x 1 texels, and one and a half times the first.
    CHECK(texels.texels == (32 + 8 + 2 + 1 + 32 + 16) * 3 * sizeof(double));
    CHECK(gradient_memory(scene, options, bilinear.get()).texels == 32 * 3 * sizeof(double));

    const std::uint64_t picture =
        estimate_memory(scene, options).total() + image_memory(scene, options, 64, 64);
    const std::uint64_t all = picture + texels.of_vertices + texels.texels;
    MemoryLimit enough(all), least(all - 1);
    enough.check(scene, options, 64, 64, texels);
    least.check(scene, options, 64, 64);
    check_error(ErrorCode::out_of_memory, CALL(least.check(scene, options, 64, 64, texels)),
                std::to_string(all));

    options.shadows = false;
    CHECK(gradient_memory(scene, options, mipmap.get()).of_vertices == 0);
}
