// SPDX-License-Identifier: MIT
// Puts a scene together from the nodes of a glTF file.
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "arguments.hpp"
#include "import/gltf_animation.hpp"
#include "import/gltf_readers.hpp"
#include "import/values.hpp"

namespace nicol {
namespace scene {
namespace {

std::string name_of(const char* list, std::size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "]";
}

/// Returns the name of a primitive.
std::string name_of(int mesh, std::size_t primitive) {
    return name_of("meshes", static_cast<std::size_t>(mesh)) + "." + name_of("primitives", primitive);
}

std::optional<GltfMoment> moment_from(const std::filesystem::path& file, const SceneParameters& parameters) {
    for (const auto& [name, value] : parameters)
        if (name != "time" && name != "animation")
            refuse(file.string() + ": the parameter " + name +
                   " is not used; those of glTF files are time and animation");
    const auto time = parameters.find("time");
    const auto animation = parameters.find("animation");
    if (time == parameters.end()) {
        if (animation == parameters.end()) return std::nullopt;
        refuse(file.string() + ": the parameter animation needs a time");
    }
    const std::optional<double> seconds = parsed_number(time->second);
    if (!seconds || !std::isfinite(*seconds))
        refuse(file.string() + ": the parameter time is \"" + time->second +
               "\"; it must be a finite number of seconds");
    return GltfMoment{.time = *seconds,
                      .animation = animation == parameters.end() ? std::string() : animation->second};
}

/// One scene. Materials are numbered in the order in which its shapes use them.
class GltfReader {
public:
    GltfReader(std::shared_ptr<const GltfDocument> document, const std::optional<GltfMoment>& moment,
               const LoadBudget& budget)
        : kept_(std::move(document)),
          document_(*kept_),
          model_(document_.model()),
          budget_(budget),
          notices_(document_.path()),
          pose_(document_, moment, budget, notices_),
          textures_(document_, notices_) {
        if (!model_.animations.empty())
            animation_ = std::make_shared<GltfAnimation>(kept_, moment ? moment->animation : std::string());
    }

    SceneDescription run() {
        read_nodes();
        if (scene_.shapes.empty())
            document_.fail("nodes", "none has a mesh of triangles; expected at least one");
        scene_.sensor =
            camera_ ? read_gltf_camera(document_, *camera_->node, camera_->where, camera_->to_world, bounds_)
                    : gltf_camera_in_front(bounds_);
        if (animation_ && camera_) animation_->set_camera(camera_->index);
        scene_.animation = std::move(animation_);
        scene_.files = document_.files();
        scene_.notices = notices_.take();
        if (std::string text = left_out_.notice(document_.path().string()); !text.empty())
            scene_.notices.push_back(std::move(text));
        return std::move(scene_);
    }

private:
    struct Made {
        std::shared_ptr<const Mesh> mesh;  ///< null: nothing to draw
        GltfBounds bounds;
    };
    struct ReadMaterial {
        GltfMaterial material;
        std::optional<std::size_t> index;  ///< into SceneDescription::materials, once a shape uses it
    };
    static constexpr std::size_t kNoNode = std::numeric_limits<std::size_t>::max();
    struct PlacedNode {
        const tinygltf::Node* node = nullptr;
        std::size_t index = kNoNode;
        std::string where;
        glm::dmat4 to_world{1.0};
    };

    /// Returns the roots of the default scene, else of the first scene, else of the file.
    [[nodiscard]] std::vector<int> roots() const {
        if (!model_.scenes.empty())
            return document_.at(model_.scenes, "scenes", std::max(model_.defaultScene, 0), "scene").nodes;
        std::vector<bool> is_child(model_.nodes.size(), false);
        for (const tinygltf::Node& node : model_.nodes)
            for (const int child : node.children)
                if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
                    is_child[static_cast<std::size_t>(child)] = true;
        std::vector<int> found;
        for (std::size_t i = 0; i < is_child.size(); ++i)
            if (!is_child[i]) found.push_back(static_cast<int>(i));
        return found;
    }

    /// Parents first, children in the order of the file.
    void read_nodes() {
        struct Waiting {
            int index;
            std::string of;
        };
        std::vector<Waiting> waiting;
        const auto wait = [&](const std::vector<int>& nodes, const std::string& of) {
            for (std::size_t i = nodes.size(); i-- > 0;) waiting.push_back({nodes[i], of});
        };
        std::vector<bool> seen(model_.nodes.size(), false);
        wait(roots(), "scene");
        while (!waiting.empty()) {
            const Waiting next = std::move(waiting.back());
            waiting.pop_back();
            const tinygltf::Node& node = document_.at(model_.nodes, "nodes", next.index, next.of);
            const auto index = static_cast<std::size_t>(next.index);
            const PlacedNode placed{&node, index, name_of("nodes", index), pose_.world(index)};
            if (seen[index]) document_.fail(placed.where, "is a root of the scene twice, or below a root");
            seen[index] = true;
            read(placed);
            wait(node.children, placed.where);
        }
    }

    void read(const PlacedNode& placed) {
        budget_.step(256);
        const tinygltf::Node& node = *placed.node;
        if (node.extensions.contains("EXT_mesh_gpu_instancing"))
            notices_.add("EXT_mesh_gpu_instancing is not followed; such a node is drawn once");
        if (node.camera >= 0 && camera_) notices_.add("only the first of several cameras is used");
        if (node.camera >= 0 && !camera_) camera_ = placed;
        if (auto light = read_gltf_light(document_, node, placed.where, placed.to_world, notices_)) {
            scene_.lights.push_back(std::move(*light));
            if (animation_) animation_->add_light(placed.index);
        }
        if (node.mesh >= 0) add_mesh(placed);
    }

    void add_mesh(const PlacedNode& placed) {
        const tinygltf::Node& node = *placed.node;
        const tinygltf::Mesh& mesh = document_.at(model_.meshes, "meshes", node.mesh, placed.where);
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
            const Made& made = primitive(placed, p);
            const bool deforms = GltfDeformation::deforms(node, mesh.primitives[p]);
            // Nothing of a mesh that deforms may be left at one time only.
            if (!made.mesh && !(animation_ && deforms)) continue;
            // Vertices that follow joints have places in the scene.
            const glm::dmat4 to_world = node.skin < 0 ? placed.to_world : glm::dmat4(1.0);
            const bool placed_well = is_gltf_placement(to_world);
            if (!placed_well) left_out_.add("instances that their transform makes flat");
            const bool present = placed_well && made.mesh;
            // An instance may be flat at one time only.
            if (!present && !animation_) continue;
            if (scene_.shapes.size() == kMaxShapes)
                document_.fail(placed.where, "more than " + std::to_string(kMaxShapes) + " shapes",
                               ErrorCode::unsupported);
            ShapeDescription shape;
            shape.kind = ShapeDescription::Kind::mesh;
            shape.id = node.name.empty() ? mesh.name : node.name;
            shape.mesh = made.mesh;
            shape.present = present;
            if (present) shape.to_world = to_world;
            ReadMaterial& of = material(mesh.primitives[p], name_of(node.mesh, p));
            shape.material = index_of(of);
            shape.emission = of.material.emission;
            if (present) bounds_.add(made.bounds, to_world);
            if (animation_) add_to_animation(placed, made, mesh.primitives[p], name_of(node.mesh, p));
            scene_.shapes.push_back(std::move(shape));
        }
    }

    void add_to_animation(const PlacedNode& placed, const Made& made, const tinygltf::Primitive& primitive,
                          const std::string& where) {
        GltfAnimation::Part part{.node = placed.index,
                                 .skinned = placed.node->skin >= 0,
                                 .mesh = made.mesh,
                                 .bounds = made.bounds,
                                 .primitive = &primitive,
                                 .where = where,
                                 .deforming = std::nullopt};
        if (GltfDeformation::deforms(*placed.node, primitive))
            part.deforming = material(primitive, where).material;
        animation_->add_part(std::move(part));
    }

    const Made& primitive(const PlacedNode& placed, std::size_t index) {
        const int mesh = placed.node->mesh;
        const tinygltf::Primitive& source = model_.meshes[static_cast<std::size_t>(mesh)].primitives[index];
        const bool deforms = GltfDeformation::deforms(*placed.node, source);
        const auto [entry, is_new] = made_.try_emplace({mesh, index, deforms ? placed.index : kNoNode});
        if (is_new) {
            const std::string where = name_of(mesh, index);
            if (source.extensions.contains("KHR_draco_mesh_compression"))
                notices_.add("KHR_draco_mesh_compression is not followed; what is there beside it is drawn");
            if (source.extensions.contains("KHR_materials_variants"))
                notices_.add(
                    "KHR_materials_variants is not followed; surfaces have their default material, or " +
                    std::string("that of the first variant where they have none"));
            std::optional<GltfDeformation> deformation;
            if (deforms) deformation.emplace(document_, pose_, placed.index, source, where);
            Made& made = entry->second;
            made.mesh = read_gltf_primitive(document_, source, where, material(source, where).material,
                                            deformation ? &*deformation : nullptr, budget_, left_out_);
            if (made.mesh) made.bounds = bounds_of(*made.mesh);
        }
        return entry->second;
    }

    ReadMaterial& material(const tinygltf::Primitive& primitive, const std::string& where) {
        const GltfSurface surface(document_, primitive, where);
        const auto known = materials_.find(surface);
        if (known != materials_.end()) return known->second;
        ReadMaterial read{read_gltf_material(document_, surface, textures_, notices_), {}};
        return materials_.emplace(surface, std::move(read)).first->second;
    }

    std::size_t index_of(ReadMaterial& read) {
        if (!read.index) {
            read.index = scene_.materials.size();
            scene_.materials.push_back(read.material.description);
        }
        return *read.index;
    }

    std::shared_ptr<const GltfDocument> kept_;
    const GltfDocument& document_;
    const tinygltf::Model& model_;
    const LoadBudget& budget_;
    GltfNotices notices_;
    GltfPose pose_;
    GltfTextures textures_;
    geometry::LeftOut left_out_;
    SceneDescription scene_;
    GltfBounds bounds_;
    std::optional<PlacedNode> camera_;
    std::shared_ptr<GltfAnimation> animation_;  // null: the file has no animations
    // By mesh, primitive and the node that deforms it, or kNoNode.
    std::map<std::tuple<int, std::size_t, std::size_t>, Made> made_;
    std::map<GltfSurface, ReadMaterial> materials_;
};

}  // namespace

}  // namespace scene

SceneDescription read_gltf_scene(const std::filesystem::path& file, const SceneParameters& parameters,
                                 const LoadBudget& budget) {
    const std::optional<scene::GltfMoment> moment = scene::moment_from(file, parameters);
    return scene::GltfReader(std::make_shared<const scene::GltfDocument>(file, budget), moment, budget).run();
}

}  // namespace nicol
