// SPDX-License-Identifier: MIT
// Puts a scene together from its XML.
#include <map>

#include "scene/readers.hpp"
#include "scene/values.hpp"

namespace nicol {
namespace scene {
namespace {

/// One file. Materials are numbered in the order in which the file first shows or uses them.
class Reader {
public:
    explicit Reader(const XmlDocument& document) : document_(document) {}

    SceneDescription run() {
        check_attributes(document_, document_.root(), {"version", "type", "id"});
        for (const pugi::xml_node node : document_.root().children())
            if (node.type() == pugi::node_element) read(node);
        if (!sensor_)
            document_.fail(document_.root(), "no <sensor>; expected one of type perspective or orthographic");
        if (scene_.shapes.empty()) document_.fail(document_.root(), "no <shape>; expected at least one");
        if (!scene_.emitter)
            scene_.notices.push_back(document_.where(document_.root()) + ": no emitter lights the scene.");
        return std::move(scene_);
    }

private:
    void read(pugi::xml_node node) {
        const std::string_view name = node.name();
        if (name == "default") {
            check_attributes(document_, node, {"name", "value"});
        } else if (name == "integrator") {
            scene_.notices.push_back(document_.where(node) + ": integrator " +
                                     in_quotes(node.attribute("type").value()) + " is not followed.");
        } else if (name == "sensor") {
            if (sensor_)
                scene_.notices.push_back(document_.where(node) +
                                         ": only the first of several sensors is used.");
            else
                scene_.sensor = read_sensor(document_, node);
            sensor_ = true;
        } else if (name == "emitter") {
            if (scene_.emitter)
                document_.fail(node, "a second emitter; expected one that surrounds the scene",
                               ErrorCode::unsupported);
            scene_.emitter = read_emitter(document_, node);
        } else if (name == "bsdf") {
            material(node);
        } else if (name == "shape") {
            pugi::xml_node bsdf;
            ShapeDescription shape = read_shape(document_, node, bsdf);
            shape.material = bsdf ? material(target(bsdf)) : default_material();
            scene_.shapes.push_back(std::move(shape));
        } else {
            document_.fail(node,
                           "<" + std::string(name) +
                               "> in <scene>; accepted: default, integrator, sensor, emitter, bsdf, shape",
                           ErrorCode::unsupported);
        }
    }

    /// The <bsdf> that a <bsdf> or a <ref> stands for.
    pugi::xml_node target(pugi::xml_node node) const {
        if (std::string_view(node.name()) == "bsdf") return node;
        check_attributes(document_, node, {"name", "id"});
        const std::string id = node.attribute("id").value();
        const pugi::xml_node found = document_.with_id(id);
        if (!found) document_.fail(node, "<ref> to " + in_quotes(id) + ", an id that no element has");
        if (std::string_view(found.name()) != "bsdf")
            document_.fail(
                node, "<ref> to " + in_quotes(id) + ", which is a <" + found.name() + ">; expected a <bsdf>");
        return found;
    }

    std::size_t material(pugi::xml_node node) {
        const auto [entry, is_new] = materials_.try_emplace(node.offset_debug(), scene_.materials.size());
        if (is_new) scene_.materials.push_back(read_material(document_, node));
        return entry->second;
    }

    /// Mitsuba's for shapes that name none: grey and diffuse.
    std::size_t default_material() {
        const auto [entry, is_new] = materials_.try_emplace(-1, scene_.materials.size());
        if (is_new) scene_.materials.emplace_back();
        return entry->second;
    }

    const XmlDocument& document_;
    SceneDescription scene_;
    bool sensor_ = false;
    std::map<std::ptrdiff_t, std::size_t> materials_;  // by position in the file; -1 is the default
};

}  // namespace
}  // namespace scene

SceneDescription read_mitsuba_scene(const std::filesystem::path& file, const SceneParameters& parameters) {
    const scene::XmlDocument document(file, parameters);
    return scene::Reader(document).run();
}

}  // namespace nicol
