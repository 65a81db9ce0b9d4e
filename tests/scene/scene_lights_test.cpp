// SPDX-License-Identifier: MIT
// Tests of a scene's local lights and emissive surfaces: ids, versions and refusals.
#include <array>

#include "function_texture.hpp"
#include "scene/scene.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

Instance square(MaterialPtr material = diffuse({0.5}), EmissionPtr emission = nullptr) {
    return {.mesh = std::make_shared<const Mesh>(make_rectangle(1)),
            .material = std::move(material),
            .emission = std::move(emission)};
}

EmissionPtr emission(const std::vector<double>& radiance) {
    return std::make_shared<const Emission>(Emission{.radiance = radiance});
}

}  // namespace

TEST_CASE("ids of lights count up by themselves, and are not given twice") {
    Scene scene;
    CHECK_FALSE(scene.has_local_lights());
    scene.add(square());
    CHECK(scene.add_light({.value = {1}}) == 0);
    CHECK(scene.add_light({.value = {2}}) == 1);
    CHECK(scene.add_light({.value = {3}}) == 2);
    scene.remove_light(1);
    CHECK(scene.light_ids() == std::vector<std::uint32_t>{0, 2});
    CHECK(scene.light(2).value[0] == 3);
    CHECK(scene.add_light({.value = {4}}) == 3);
    scene.set_light(2, {.value = {5}});
    CHECK(scene.lights()[1].value[0] == 5);
    CHECK(scene.has_local_lights());
    for (const std::uint32_t id : {0U, 2U, 3U}) scene.remove_light(id);
    CHECK_FALSE(scene.has_local_lights());
    scene.set_emission(0, emission({1}));
    CHECK(scene.has_local_lights());
    scene.set_emission(0, nullptr);
    CHECK_FALSE(scene.has_local_lights());
}

TEST_CASE("lights that do not fit the scene, or are not there, are refused by name") {
    const TexturePtr texture = texture_of([](const TexturePoint&) { return glm::vec4(1); });
    const EmissionPtr textured = std::make_shared<const Emission>(Emission{.texture = texture});
    Mesh plain = make_rectangle(1);
    plain.texcoords.clear();
    plain.texcoord_triangles.clear();
    Scene scene;
    scene.add(square(diffuse({0.1, 0.2, 0.3})));
    scene.add({.mesh = std::make_shared<const Mesh>(plain), .material = diffuse({0.5})});
    scene.add_light({});
    scene.add_light({});
    scene.remove_light(1);
    const struct {
        std::function<void()> call;
        std::vector<std::string> named;
    } cases[] = {
        {CALL(scene.add_light({.value = {1, 2}})), {"light", "2 colour channels", "3"}},
        {CALL(scene.set_light(0, {.value = {1, 2}})), {"light", "2 colour channels"}},
        {CALL(scene.add_light({.value = {-1}})), {"value of a light is -1"}},
        {CALL(scene.set_light(0, {.value = {}})), {"value of a light"}},
        {CALL(scene.set_light(1, {})), {"light 1", "removed"}},
        {CALL(scene.remove_light(1)), {"light 1", "removed"}},
        {CALL(scene.light(2)), {"light 2", "below 2"}},
        {CALL(scene.set_emission(0, emission({1, 2}))), {"emission", "2 colour channels"}},
        {CALL(scene.set_emission(0, emission({-1}))), {"radiance of a surface is -1"}},
        {CALL(scene.set_emission(7, emission({1}))), {"instance 7"}},
        {CALL(scene.set_emission(1, textured)), {"instance 1", "texture coordinates"}},
        {CALL(scene.add(square(diffuse({0.5}), emission({1, 2})))), {"emission", "2 colour channels"}},
        {CALL(scene.add(square(diffuse({0.5}), emission({})))), {"radiance of a surface"}},
    };
    const Version before = scene.local_light_version();
    for (const auto& c : cases) {
        const std::string message = error_of(c.call);
        for (const std::string& part : c.named)
            CHECK_MESSAGE(message.find(part) != std::string::npos, message, " lacks ", part);
    }
    CHECK(scene.local_light_version() == before);
    CHECK(scene.instances().size() == 2);
    CHECK(scene.lights().size() == 1);
}

TEST_CASE("every change of a light, or of what emits light, is a new version of those alone") {
    Scene scene;
    const std::uint32_t id = scene.add(square());
    const std::uint32_t light = scene.add_light({});
    const std::function<void()> changes[] = {
        CALL(scene.add_light({})),
        CALL(scene.set_light(light, {.value = {2}})),
        CALL(scene.set_emission(id, emission({1}))),
        CALL(scene.set_emission(id, emission({2}))),
        CALL(scene.set_emission(id, nullptr)),
        CALL(scene.remove_light(light)),
    };
    for (const auto& change : changes) {
        const std::pair lights(scene.local_light_version(), scene.emission_version());
        const Version others[] = {scene.geometry_version(), scene.material_version(), scene.light_version()};
        change();
        const bool of_lights = scene.local_light_version() != lights.first;
        CHECK(of_lights != (scene.emission_version() != lights.second));
        CHECK(scene.geometry_version() == others[0]);
        CHECK(scene.material_version() == others[1]);
        CHECK(scene.light_version() == others[2]);
    }
}

TEST_CASE("a light, an emission or an element with equal values is no change") {
    Scene scene;
    const std::uint32_t id = scene.add(square());
    const std::uint32_t light = scene.add_light({.value = {2}});
    const std::uint32_t element = scene.add_element(PolarizationElement{.angle = 1});
    scene.set_emission(id, emission({1}));
    const auto versions = [&] {
        return std::array{scene.local_light_version(), scene.emission_version(), scene.element_version()};
    };
    const auto before = versions();
    scene.set_light(light, {.value = {2}});
    scene.set_emission(id, emission({1}));
    scene.set_element(element, PolarizationElement{.angle = 1});
    CHECK(versions() == before);
    scene.set_light(light, {.value = {2}, .beam_width = 0.1});
    scene.set_emission(id, emission({1.5}));
    scene.set_element(element, PolarizationElement{.angle = 2});
    for (std::size_t i = 0; i < before.size(); ++i) CHECK(versions()[i] != before[i]);
}
