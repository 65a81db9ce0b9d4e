// SPDX-License-Identifier: MIT
// <emitter>: choice of the kind, and parameters that all kinds have.
#include <glm/trigonometric.hpp>

#include "import/plugin.hpp"
#include "import/readers.hpp"

namespace nicol::scene {

namespace {

/// Finishes an emitter: parameters of Mitsuba's sampling have no effect, and no other may be left over.
void finish(Plugin& plugin, pugi::xml_node node, Notices& notices) {
    plugin.pass_over({"sampling_weight"});
    for (const char* name : {"mis_compensation", "sampling_weight"})
        if (plugin.has(name)) notices.add_unfollowed(node, name);
    plugin.finish();
    static_cast<void>(plugin.objects({}));
}

}  // namespace

void read_emitter(const XmlDocument& document, const NestedObject& object, Notices& notices,
                  SceneDescription& scene) {
    Plugin plugin(document, object.node);
    if (auto environment = read_environment(plugin)) {
        if (scene.environment)
            document.fail(object.place, "a second emitter that surrounds the scene; expected one",
                          ErrorCode::unsupported);
        scene.environment = std::move(environment);
    } else if (auto light = read_light(document, plugin)) {
        scene.lights.push_back(std::move(*light));
    } else {
        plugin.fail_type("envmap, constant, psh, sky, " + light_type_names(),
                         plugin.type() == "area" ? "it belongs into a <shape>" : "");
    }
    finish(plugin, object.node, notices);
}

EmissionDescription read_emission(const XmlDocument& document, pugi::xml_node node, Notices& notices) {
    Plugin plugin(document, node);
    if (plugin.type() != "area") plugin.fail_type("area", "others are in <scene>");
    EmissionDescription emission;
    emission.radiance = read_color(document, plugin, "radiance", 1.0, kNoLimit);
    emission.two_sided = plugin.boolean("two_sided", false);
    emission.state = read_polarization(plugin);
    finish(plugin, node, notices);
    return emission;
}

PolarizationState read_polarization(Plugin& plugin) {
    PolarizationState state;
    state.dolp = plugin.number("dolp", state.dolp);
    state.aolp = glm::radians(plugin.number("aolp", 0.0));
    state.docp = plugin.number("docp", state.docp);
    state.axis = plugin.vector("polarization_axis", state.axis);
    try {
        check(state);
    } catch (const Error& error) {
        plugin.fail("", error.what());
    }
    return state;
}

}  // namespace nicol::scene
