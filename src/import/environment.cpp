// SPDX-License-Identifier: MIT
// <emitter>s that surround the scene.
#include <cmath>
#include <glm/geometric.hpp>

#include "import/plugin.hpp"
#include "import/readers.hpp"

namespace nicol::scene {

namespace {

void read_sky(Plugin& plugin, EnvironmentDescription& environment) {
    environment.kind = EnvironmentDescription::Kind::sky;
    environment.radiance = plugin.color("radiance", 1.0);
    environment.dop_max = plugin.number("dop_max", environment.dop_max, 0.0, 1.0);
    const glm::dvec3 sun = plugin.vector("sun_direction", std::nullopt);
    const double length = glm::length(sun);
    if (!(length > 0.0) || !std::isfinite(length))
        plugin.fail("sun_direction", "has no direction; expected a vector towards the sun");
    environment.sun_direction = sun / length;
    environment.ground_albedo = plugin.color("ground_albedo", environment.ground_albedo, 1.0);
    environment.sun = plugin.boolean("sun", environment.sun);
    environment.turbidity = plugin.number("turbidity", 0.0);
    if (environment.turbidity == 0.0) return;
    environment.turbidity = plugin.number("turbidity", 0.0, 1.7, 10.0);
    if (sun.y < 0.0)
        plugin.fail("sun_direction", "points below the horizon, where a sky with turbidity has no sun");
}

}  // namespace

std::optional<EnvironmentDescription> read_environment(Plugin& plugin) {
    using Kind = EnvironmentDescription::Kind;
    EnvironmentDescription environment;
    if (plugin.type() == "envmap" || plugin.type() == "psh") {
        environment.kind = plugin.type() == "psh" ? Kind::psh : Kind::envmap;
        environment.filename = plugin.filename("filename");
        environment.scale = plugin.number("scale", 1.0, 0.0, kNoLimit);
    } else if (plugin.type() == "constant") {
        environment.kind = Kind::constant;
        environment.radiance = plugin.color("radiance", 1.0);
    } else if (plugin.type() == "sky") {
        read_sky(plugin, environment);
    } else {
        return std::nullopt;
    }
    environment.to_world = plugin.transform("to_world");
    // Steers Mitsuba's sampling of the environment.
    plugin.pass_over({"mis_compensation"});
    return environment;
}

}  // namespace nicol::scene
