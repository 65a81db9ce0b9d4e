// SPDX-License-Identifier: MIT
// <emitter>.
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/plugin.hpp"
#include "scene/readers.hpp"

namespace nicol::scene {

namespace {

void read_sky(Plugin& plugin, EmitterDescription& emitter) {
    emitter.kind = EmitterDescription::Kind::sky;
    emitter.radiance = plugin.color("radiance", 1.0);
    emitter.dop_max = plugin.number("dop_max", emitter.dop_max, 0.0, 1.0);
    const glm::dvec3 sun = plugin.vector("sun_direction", std::nullopt);
    const double length = glm::length(sun);
    if (!(length > 0.0) || !std::isfinite(length))
        plugin.fail("sun_direction", "has no direction; expected a vector towards the sun");
    emitter.sun_direction = sun / length;
    emitter.ground_albedo = plugin.color("ground_albedo", emitter.ground_albedo, 1.0);
    emitter.turbidity = plugin.number("turbidity", 0.0);
    if (emitter.turbidity == 0.0) return;
    emitter.turbidity = plugin.number("turbidity", 0.0, 1.7, 10.0);
    if (sun.y < 0.0)
        plugin.fail("sun_direction", "points below the horizon, where a sky with turbidity has no sun");
}

}  // namespace

EmitterDescription read_emitter(const XmlDocument& document, pugi::xml_node node, Notices& notices) {
    using Kind = EmitterDescription::Kind;
    Plugin plugin(document, node);
    EmitterDescription emitter;
    if (plugin.type() == "envmap" || plugin.type() == "psh") {
        emitter.kind = plugin.type() == "psh" ? Kind::psh : Kind::envmap;
        emitter.filename = plugin.filename("filename");
        emitter.scale = plugin.number("scale", 1.0, 0.0, kNoLimit);
    } else if (plugin.type() == "constant") {
        emitter.kind = Kind::constant;
        emitter.radiance = plugin.color("radiance", 1.0);
    } else if (plugin.type() == "sky") {
        read_sky(plugin, emitter);
    } else {
        plugin.fail_type("envmap, constant, psh, sky", "only light from all around is");
    }
    emitter.to_world = plugin.transform("to_world");
    // They steer Mitsuba's sampling.
    for (const char* name : {"mis_compensation", "sampling_weight"}) {
        plugin.pass_over({name});
        if (plugin.has(name)) notices.add_unfollowed(node, name);
    }
    plugin.finish();
    static_cast<void>(plugin.objects({}));
    return emitter;
}

}  // namespace nicol::scene
