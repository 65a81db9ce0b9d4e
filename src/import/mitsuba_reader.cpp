// SPDX-License-Identifier: MIT
// Puts a scene together from its XML.
#include <map>

#include "import/diffuse_material.hpp"
#include "import/plugin.hpp"
#include "import/polarization_element.hpp"
#include "import/readers.hpp"

namespace nicol {
namespace scene {
namespace {

/// One scene. Materials are numbered in the order in which its shapes use them.
class Reader {
public:
    explicit Reader(const XmlDocument& document)
        : document_(document), notices_(document), elements_(document) {}

    SceneDescription run() {
        for (const pugi::xml_node node : document_.elements(document_.root())) read(node);
        if (!sensor_)
            document_.fail(document_.root(), "no <sensor>; expected one of type perspective or orthographic");
        scene_.elements = elements_.put_before_area_lights(scene_.shapes);
        if (scene_.shapes.empty() && scene_.elements.empty())
            document_.fail(document_.root(), "no <shape>; expected at least one");
        for (const pugi::xml_node node : document_.left_open())
            notices_.add(node, "a $parameter that has no value, of a sampler; it is not followed");
        scene_.files = document_.files();
        scene_.notices = notices_.take();
        return std::move(scene_);
    }

private:
    void read(pugi::xml_node place) {
        document_.budget().step(256);
        const NestedObject object = checked_object(
            document_, place, "<scene>",
            {"integrator", "sensor", "emitter", "bsdf", "texture", "shape", "film", "sampler", "rfilter"});
        const pugi::xml_node node = object.node;
        const std::string_view name = node.name();
        if (name == "integrator") {
            if (integrator_) document_.fail(place, "a second integrator; expected one");
            scene_.integrator = read_integrator(document_, node, notices_);
            integrator_ = true;
        } else if (name == "sensor") {
            if (sensor_)
                notices_.add(place, "only the first of several sensors is used");
            else
                scene_.sensor = read_sensor(document_, node, notices_);
            sensor_ = true;
        } else if (name == "emitter") {
            // An area with an id serves the shapes that refer to it.
            if (node.attribute("type").value() == std::string_view("area") && node.attribute("id"))
                static_cast<void>(read_emission(document_, node, notices_));
            else
                read_emitter(document_, object, notices_, scene_);
        } else if (name == "bsdf") {
            // Checked here, listed where a shape uses it.
            if (is_element_material(node))
                static_cast<void>(read_element_material(document_, node));
            else
                static_cast<void>(read_material(document_, node, notices_));
        } else if (name == "texture") {
            static_cast<void>(read_texture(document_, node));
        } else if (name == "shape") {
            shape(place, node);
        }
        // The others serve those that refer to them.
    }

    void shape(pugi::xml_node place, pugi::xml_node node) {
        const std::string_view type = node.attribute("type").value();
        if (type == "shapegroup")
            static_cast<void>(group(node));
        else if (type == "instance")
            instance(place, node);
        else if (type == "merge")
            merge(node);
        else
            single(place, node);
    }

    struct Shape {
        ShapeDescription description;
        pugi::xml_node element;  // its bsdf; null: it is a surface
    };

    void single(pugi::xml_node place, pugi::xml_node node) { add(place, read_single(node)); }

    Shape read_single(pugi::xml_node node) {
        pugi::xml_node bsdf;
        ShapeDescription description = read_shape(document_, node, notices_, bsdf);
        if (PolarizationElements::are(description, bsdf)) return {std::move(description), bsdf};
        const bool there = bsdf && bsdf.attribute("type").value() != std::string_view("null");
        if (bsdf && !there && description.emission)
            notices_.add(bsdf, "a null bsdf of an emissive shape: it is not seen through");
        description.material = !there && description.emission ? black() : material(bsdf);
        return {std::move(description), {}};
    }

    const std::vector<Shape>& group(pugi::xml_node node) {
        const auto [entry, is_new] = groups_.try_emplace(node);
        if (is_new)
            for (const pugi::xml_node of_group : read_group(document_, node))
                entry->second.push_back(read_single(of_group));
        return entry->second;
    }

    void instance(pugi::xml_node place, pugi::xml_node node) {
        ShapeDescription instance;
        for (Shape member : group(read_instance(document_, node, instance))) {
            member.description.id = instance.id;
            member.description.to_world = instance.to_world * member.description.to_world;
            add(place, std::move(member));
        }
    }

    /// Its meshes become one in Mitsuba, which looks the same.
    void merge(pugi::xml_node node) {
        for (const pugi::xml_node of_group : read_group(document_, node)) single(of_group, of_group);
    }

    void add(pugi::xml_node place, Shape shape) {
        document_.budget().step(256);
        if (shape.element) return elements_.add(place, shape.description, shape.element);
        if (scene_.shapes.size() == kMaxShapes)
            document_.fail(place, "more than " + std::to_string(kMaxShapes) + " shapes, instances counted",
                           ErrorCode::unsupported);
        scene_.shapes.push_back(std::move(shape.description));
    }

    /// Returns the index of a material. No bsdf gives the default (grey diffuse, as in Mitsuba).
    std::size_t material(pugi::xml_node bsdf) {
        const auto [entry, is_new] = materials_.try_emplace(bsdf, scene_.materials.size());
        if (is_new)
            scene_.materials.push_back(bsdf ? read_material(document_, bsdf, notices_)
                                            : MaterialDescription(DiffuseModel()));
        return entry->second;
    }

    /// Mitsuba's for emissive shapes and name none. Those of a null bsdf are seen, but not through.
    std::size_t black() {
        if (!black_) {
            black_ = scene_.materials.size();
            DiffuseModel black;
            black.reflectance = 0.0;
            scene_.materials.emplace_back(std::move(black));
        }
        return *black_;
    }

    const XmlDocument& document_;
    Notices notices_;
    PolarizationElements elements_;
    SceneDescription scene_;
    bool sensor_ = false;
    bool integrator_ = false;
    std::map<pugi::xml_node, std::size_t> materials_;
    std::optional<std::size_t> black_;
    std::map<pugi::xml_node, std::vector<Shape>> groups_;
};

}  // namespace
}  // namespace scene

SceneDescription read_mitsuba_scene(const std::filesystem::path& file, const SceneParameters& parameters,
                                    const LoadBudget& budget) {
    const scene::XmlDocument document(file, parameters, budget);
    return scene::Reader(document).run();
}

}  // namespace nicol
