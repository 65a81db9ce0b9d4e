// SPDX-License-Identifier: MIT
// <emitter>.
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/plugin.hpp"
#include "scene/readers.hpp"

namespace nicol::scene {

EmitterDescription read_emitter(const XmlDocument& document, pugi::xml_node node) {
    using Kind = EmitterDescription::Kind;
    constexpr double no_limit = std::numeric_limits<double>::max();
    Plugin plugin(document, node);
    EmitterDescription emitter;
    if (plugin.type() == "envmap" || plugin.type() == "psh") {
        emitter.kind = plugin.type() == "psh" ? Kind::psh : Kind::envmap;
        emitter.filename = plugin.filename("filename");
        emitter.scale = plugin.number("scale", 1.0, 0.0, no_limit);
    } else if (plugin.type() == "constant") {
        emitter.kind = Kind::constant;
        emitter.radiance = plugin.color("radiance", 1.0);
    } else if (plugin.type() == "sky") {
        emitter.kind = Kind::sky;
        emitter.radiance = plugin.color("radiance", 1.0);
        emitter.dop_max = plugin.number("dop_max", emitter.dop_max, 0.0, 1.0);
        const glm::dvec3 sun = plugin.vector("sun_direction", std::nullopt);
        const double length = glm::length(sun);
        if (!(length > 0.0) || !std::isfinite(length))
            plugin.fail("sun_direction", "has no direction; expected a vector towards the sun");
        emitter.sun_direction = sun / length;
    } else {
        plugin.fail_type("envmap, constant, psh, sky");
    }
    emitter.to_world = plugin.transform("to_world");
    // They steer Mitsuba's sampling.
    plugin.pass_over({"mis_compensation", "sampling_weight"});
    plugin.finish();
    static_cast<void>(plugin.objects({}));
    return emitter;
}

}  // namespace nicol::scene
