// SPDX-License-Identifier: MIT
#include "import/elements_before_lights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "import/polarization_element.hpp"
#include "import/xml_file.hpp"

namespace nicol::scene {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Margin of the boxes that an element must cover, so that an element of exactly their size covers them.
constexpr double kRounding = 1e-6;

struct Box {
    glm::dvec3 least{kInfinity};
    glm::dvec3 most{-kInfinity};

    void add(const glm::dvec3& point) {
        least = glm::min(least, point);
        most = glm::max(most, point);
    }
    [[nodiscard]] std::array<glm::dvec3, 8> corners() const {
        const glm::dvec3 middle = 0.5 * (least + most);
        const glm::dvec3 half = (1 - kRounding) / 2 * (most - least);
        std::array<glm::dvec3, 8> out;
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = middle +
                     half * glm::dvec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
        return out;
    }
};

/// Shapes that lights may light, in the world.
struct LitShapes {
    std::vector<glm::dvec3> corners;  // of a box in the axes of each shape
    glm::dvec3 middle{0.0};           // of the corners: their mean, which is behind all that they are behind
};

LitShapes lit_shapes(const SceneDescription& description, const Scene& scene) {
    LitShapes out;
    std::map<const Mesh*, Box> boxes;
    for (std::size_t i = 0; i < description.shapes.size(); ++i) {
        if (description.materials[description.shapes[i].material].model->black()) continue;
        const Instance& instance = scene.instances()[i];
        const auto [entry, is_new] = boxes.try_emplace(instance.mesh.get());
        if (is_new)
            for (const glm::vec3& position : instance.mesh->positions) entry->second.add(position);
        for (const glm::dvec3& corner : entry->second.corners())
            out.corners.emplace_back(instance.to_world * glm::dvec4(corner, 1));
    }
    for (const glm::dvec3& corner : out.corners)
        out.middle += corner / static_cast<double>(out.corners.size());
    return out;
}

/// Light that travels along a straight line, of which a part counts.
struct Way {
    glm::dvec3 origin;
    glm::dvec3 direction;
    double first = 0;  // in directions from the origin
    double last = kInfinity;

    [[nodiscard]] bool meets(const PlacedElement& element) const {
        const std::optional<ElementCrossing> at = element.crossing(origin, direction);
        return at && at->distance > first && at->distance < last;
    }
};

/// Paths of the light of one light to the shapes that it lights.
class Beam {
public:
    /// lit: with corners; it must live as long.
    Beam(const LocalLight& light, const LitShapes& lit)
        : distant_(light.kind == LocalLight::Kind::directional),
          origin_(light.to_world[3]),
          corners_(lit.corners),
          directions_(light_outline(light)) {
        const glm::dmat3 axes(light.to_world);
        for (glm::dvec3& direction : directions_) direction = axes * direction;
        if (distant_)
            middle_ = parallel(lit.middle, axes[2]);
        else
            middle_ = directions_.empty() ? to(lit.middle) : Way{origin_, axes[2]};
    }

    [[nodiscard]] const Way& middle() const { return middle_; }

    /// Returns a point where light passes beside the element, or nothing if the element covers the light. It
    /// suffices to test the ways that enclose all of the light, because elements are convex.
    [[nodiscard]] std::optional<glm::dvec3> beside(const PlacedElement& element) const {
        const auto misses = [&](const Way& way) { return !way.meets(element); };
        if (directions_.empty()) {
            for (const glm::dvec3& corner : corners_)
                if (misses(to(corner))) return corner;
        } else if (distant_) {
            for (const glm::dvec3& corner : corners_)
                for (const glm::dvec3& direction : directions_)
                    if (misses(parallel(corner, direction))) return corner;
        } else {
            for (const glm::dvec3& direction : directions_)
                if (misses({origin_, direction})) return origin_ + direction;
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] Way to(const glm::dvec3& point) const { return {origin_, point - origin_, 0, 1}; }
    /// To a point from infinitely far.
    static Way parallel(const glm::dvec3& point, const glm::dvec3& direction) {
        return {point, direction, -kInfinity, 0};
    }

    bool distant_;  // light comes from infinitely far
    glm::dvec3 origin_;
    std::span<const glm::dvec3> corners_;
    std::vector<glm::dvec3> directions_;  // around all of the light; empty: all directions
    Way middle_;
};

std::string name_of(const LightDescription& light) {
    const std::string kind(light_name(light.parameters.kind));
    return light.id.empty() ? kind : kind + " " + in_quotes(light.id);
}

/// Returns the notice of an element that covers only a part of a light.
std::string notice_of_part(const ElementDescription& element, const LightDescription& light,
                           const glm::dvec3& beside) {
    return element.where + ": the polarization element does not cover the " + name_of(light) +
           ", whose light passes beside it towards (" + std::to_string(beside.x) + ", " +
           std::to_string(beside.y) + ", " + std::to_string(beside.z) + "): all of it stays unchanged.";
}

}  // namespace

void put_elements_before_lights(const SceneDescription& description, Scene& scene, SceneFiles& files) {
    if (description.elements.empty()) return;
    const LitShapes lit = lit_shapes(description, scene);
    if (lit.corners.empty()) return;
    bool other_light = scene.environment() != nullptr;
    for (const Instance& instance : scene.instances()) other_light = other_light || instance.emission;
    const std::vector<PlacedElement> placed(description.elements.begin(), description.elements.end());
    std::string part;
    for (std::size_t l = 0; l < description.lights.size(); ++l) {
        const std::uint32_t id = scene.light_ids()[l];
        LocalLight light = scene.light(id);
        const Beam beam(light, lit);
        const Way& middle = beam.middle();
        std::vector<std::size_t> before;
        for (std::size_t p = 0; p < placed.size(); ++p) {
            files.budget().check_time(description.files.front().path);
            const std::optional<glm::dvec3> beside = beam.beside(placed[p]);
            if (!beside) before.push_back(p);
            other_light = other_light || beside;
            if (beside && part.empty() && middle.meets(placed[p]))
                part = notice_of_part(description.elements[p], description.lights[l], *beside);
        }
        std::ranges::stable_sort(before, {}, [&](std::size_t p) {
            const std::optional<ElementCrossing> at = placed[p].crossing(middle.origin, middle.direction);
            return at ? at->distance : 0;
        });
        std::vector<PlacedElement> passed;
        for (const std::size_t p : before) {
            if (description.elements[p].textured()) break;
            passed.push_back(placed[p]);
        }
        other_light = other_light || passed.size() < before.size();
        if (passed.empty()) continue;
        const Frame frame = theta_phi_frame(glm::normalize(middle.direction));
        const LightBehindElements light_behind =
            behind(passed, light.state, frame, glm::dmat3(light.to_world));
        for (double& value : light.value) value *= light_behind.brightness;
        light.state = light_behind.state;
        scene.set_light(id, std::move(light));
    }
    if (other_light)
        files.notice(
            description.elements.front().where +
            ": polarization elements act on what the camera sees through them and, without textures, on the "
            "lights that they cover: they cast no shadow, and other light passes them unchanged on its way "
            "to surfaces.");
    if (!part.empty()) files.notice(part);
}

}  // namespace nicol::scene
