// SPDX-License-Identifier: MIT
#include "reference/traced_scene.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/graded_mesh.hpp"
#include "material/spatial_variation.hpp"
#include "reference/light_arrival.hpp"
#include "scene/middle.hpp"

namespace nicol {

ElementsOnRay::ElementsOnRay(std::span<const SceneElement> elements, const glm::dmat4& from_world) {
    elements_.reserve(elements.size());
    for (const SceneElement& element : elements) {
        elements_.push_back({PlacedElement(element, from_world), element.textures});
        colored_ = colored_ || element.channels() > 1;
    }
}

Mueller ElementsOnRay::Element::mueller(const Frame& received, const glm::dvec2& place, int channel) const {
    const TexturePoint point{.uv = glm::vec2((1.0 + place) / 2.0)};
    const auto factor = [&](const TexturePtr& texture, int of_channel) {
        return texture == nullptr ? 1.0 : static_cast<double>(texture->at(point)[of_channel]);
    };
    const PolarizationElement& numbers = placed.element();
    return placed.mueller(received, numbers.angle * factor(textures.angle, 0),
                          numbers.retardance * factor(textures.retardance, std::min(channel, 2)));
}

std::optional<Mueller> ElementsOnRay::mueller(const Ray& ray, const Frame& received, int channel) const {
    struct Passed {
        ElementCrossing at;
        const Element* element;
    };
    std::vector<Passed> passed;
    passed.reserve(elements_.size());
    for (const Element& element : elements_) {
        const std::optional<ElementCrossing> at = element.placed.crossing(ray.origin, ray.direction);
        if (at && at->distance >= ray.nearest && at->distance < ray.farthest)
            passed.push_back({*at, &element});
    }
    if (passed.empty()) return std::nullopt;
    std::ranges::sort(passed, {}, [](const Passed& one) { return one.at.distance; });
    const auto of = [&](const Passed& one) { return one.element->mueller(received, one.at.place, channel); };
    Mueller product = of(passed.front());
    for (const Passed& next : std::span(passed).subspan(1)) product = product * of(next);
    return product;
}

namespace {

// Returns the meshes of a scene's instances in the coordinates of rays, with triangles divided that are far
// larger than an object beside them.
std::vector<Mesh> placed_meshes(const Scene& scene, const glm::dmat4& from_world) {
    std::vector<Mesh> meshes;
    std::vector<MeshExtent> extents;
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const Instance& instance = scene.instances()[i];
        meshes.push_back(placed(*instance.mesh, from_world * instance.to_world, scene.ids()[i]));
        extents.push_back(extent_of(meshes.back()));
    }
    const Details details(extents);
    for (std::size_t i = 0; i < meshes.size(); ++i)
        if (const auto divided = graded(meshes[i], details.beside(extents[i]))) meshes[i] = *divided;
    return meshes;
}

}  // namespace

TracedScene::TracedScene(const Scene& scene) : channels_(scene.channels()), ids_(scene.ids()) {
    if (!scene.instances().empty()) origin_ = middle_of(scene.instances()[largest_instance(scene)]);
    from_world_ = from_middle(origin_);
    elements_ = ElementsOnRay(scene.elements(), from_world_);
    std::vector<RaySurface> triangles;
    surfaces_.reserve(scene.instances().size());
    std::vector<Mesh> meshes = placed_meshes(scene, from_world_);
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        const Instance& instance = scene.instances()[i];
        const MaterialPtr behind = instance.material->behind();
        TracedSurface& surface =
            surfaces_.emplace_back(TracedSurface{.mesh = std::move(meshes[i]),
                                                 .front = traced(*instance.material),
                                                 .back = traced(behind ? *behind : *instance.material),
                                                 .emission = instance.emission.get(),
                                                 .roles = instance.roles});
        if (surface.emission != nullptr)
            surface.emission_axis = axis_in_world(instance.to_world, surface.emission->state);
        triangles.push_back({.positions = surface.mesh.positions,
                             .triangles = surface.mesh.triangles,
                             .present = surface.presence()});
        triangles_ += surface.mesh.triangles.size();
    }
    rays_ = std::make_shared<const RayScene>(triangles);
    // Returns the scene of some surfaces. The others keep their numbers and have no triangles.
    const auto only = [&](const auto& chosen) -> std::shared_ptr<const RayScene> {
        if (std::ranges::all_of(surfaces_, chosen)) return rays_;
        std::vector<RaySurface> some = triangles;
        for (std::size_t i = 0; i < some.size(); ++i)
            if (!chosen(surfaces_[i])) some[i].triangles = {};
        return std::make_shared<const RayScene>(some);
    };
    visible_ = only([](const TracedSurface& surface) { return surface.roles.visible; });
    blockers_ = only([](const TracedSurface& surface) { return surface.blocks(); });
}

TracedMaterial TracedScene::traced(const Material& material) {
    TracedMaterial out{.material = &material, .layers = {}};
    const auto add_layer = [&](const Material& layer) {
        const SurfaceSampler& sampler = samplers_.try_emplace(&layer, layer).first->second;
        out.layers.push_back({.material = &layer, .sampler = &sampler});
    };
    if (const SpatialVariation* const variation = material.variation()) {
        for (const MaterialLayer& layer : variation->layers) add_layer(*layer.material);
    } else {
        add_layer(material);
    }
    return out;
}

std::optional<TracedScene::Surfel> TracedScene::first_surface(const Ray& ray) const {
    const std::optional<RayHit> found = visible_->intersect(ray);
    if (!found) return std::nullopt;
    const SurfaceHit hit = surface_at(*found, ray.direction);
    return Surfel{.instance = ids_[found->surface], .position = hit.position, .normal = hit.frame[2]};
}

}  // namespace nicol
