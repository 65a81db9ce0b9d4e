// SPDX-License-Identifier: MIT
#include "import/polarization_element.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "import/plugin.hpp"
#include "import/readers.hpp"

namespace nicol::scene {
namespace {

// Every area light is compared with every element.
constexpr std::size_t kMostElements = 1000;
using std::numbers::pi;

std::string_view type_of(pugi::xml_node node) {
    return node.attribute("type").value();
}

/// A rectangle or a disk in the world.
class FlatShape {
public:
    explicit FlatShape(const ShapeDescription& shape)
        : round_(shape.kind == ShapeDescription::Kind::disk), center_(shape.to_world[3]) {
        const glm::dmat3 axes(shape.to_world);
        u_ = axes[0];
        v_ = axes[1];
        normal_ = glm::normalize(glm::transpose(glm::inverse(axes))[2]) * (shape.flip_normals ? -1.0 : 1.0);
        to_local_ = glm::inverse(glm::dmat3(u_, v_, normal_));
    }

    /// x = the image of the shape's x, z = normal.
    [[nodiscard]] Frame frame() const { return frame_with_x(normal_, u_); }

    /// Returns the distance of an element before this area light; 0 or less if the element does not stand
    /// before the light.
    [[nodiscard]] double distance_to(const FlatShape& element) const {
        constexpr double nearer_than = 0.1;
        const double most_parallel = std::cos(glm::radians(0.1));
        const double distance = glm::dot(element.center_ - center_, normal_);
        const bool before = distance > 0 &&
                            distance < nearer_than * std::min(glm::length(u_), glm::length(v_)) &&
                            std::abs(glm::dot(normal_, element.normal_)) >= most_parallel && lies_on(element);
        return before ? distance : 0;
    }

private:
    /// Returns whether the outline, moved along the element's normal, lies on the element; both are convex.
    [[nodiscard]] bool lies_on(const FlatShape& element) const {
        const int points = round_ ? 64 : 4;
        const double radius = round_ ? 1 : std::sqrt(2.0);
        for (int i = 0; i < points; ++i) {
            const double angle = 2 * pi * (i + 0.5) / points;
            if (!element.holds(center_ + radius * (std::cos(angle) * u_ + std::sin(angle) * v_)))
                return false;
        }
        return true;
    }

    [[nodiscard]] bool holds(const glm::dvec3& point) const {
        constexpr double rounding = 1e-6;
        const glm::dvec3 p = glm::abs(to_local_ * (point - center_));
        return (round_ ? std::hypot(p.x, p.y) : std::max(p.x, p.y)) <= 1 + rounding;
    }

    bool round_;
    glm::dvec3 center_, u_, v_, normal_;
    glm::dmat3 to_local_;
};

bool is_flat(const ShapeDescription& shape) {
    return shape.kind == ShapeDescription::Kind::rectangle || shape.kind == ShapeDescription::Kind::disk;
}

}  // namespace

LightBehindElements behind(std::span<const PlacedElement> elements, const PolarizationState& state,
                           const Frame& frame, const glm::dmat3& to_world) {
    Stokes light = stokes_in(frame, state, glm::normalize(to_world * state.axis));
    for (const PlacedElement& element : elements) light = element.mueller(frame) * light;
    LightBehindElements out{.brightness = light[0], .state = {}};
    if (light[0] <= 0) return out;
    out.state.dolp = std::min(std::hypot(light[1], light[2]) / light[0], 1.0);
    out.state.aolp = pi / 2;
    out.state.docp = std::clamp(light[3] / light[0], -1.0, 1.0);
    // The axis of a polarizer, which absorbs however light passes: the direction of least light in the plane
    // of the last element.
    const double angle = std::atan2(light[2], light[1]) / 2 + pi / 2;
    const glm::dvec3 least = std::cos(angle) * frame[0] + std::sin(angle) * frame[1];
    const glm::dvec3& normal = elements.back().normal();
    const glm::dvec3 in_plane = glm::dot(frame[2], normal) * least - glm::dot(least, normal) * frame[2];
    out.state.axis = glm::normalize(glm::inverse(to_world) * in_plane);
    return out;
}

bool is_element_material(pugi::xml_node bsdf) {
    const std::string_view type = type_of(bsdf);
    return type == "polarizer" || type == "retarder" || type == "circular";
}

ElementDescription read_element_material(const XmlDocument& document, pugi::xml_node bsdf) {
    using Kind = PolarizationElement::Kind;
    Plugin plugin(document, bsdf);
    ElementDescription element;
    // Reads degrees. A texture of degrees is a factor on one degree.
    const auto angle = [&](const char* name, double otherwise, TextureSpecificationPtr& texture) {
        const pugi::xml_node node = plugin.texture(name);
        if (!node) return glm::radians(plugin.uniform(name, otherwise, -kNoLimit, kNoLimit));
        texture = read_texture(document, node);
        if (texture->times_colors_of)
            plugin.fail(name, "has colours of a mesh; expected an image", ErrorCode::unsupported);
        return glm::radians(1.0);
    };
    if (plugin.type() == "polarizer") {
        // Mitsuba turns polarizers clockwise, and retarders counter-clockwise.
        element.angle = -angle("theta", 0.0, element.angle_texture);
        if (!plugin.boolean("polarizing", true))
            plugin.fail("polarizing", "is false; expected true", ErrorCode::unsupported);
    } else if (plugin.type() == "retarder") {
        element.kind = Kind::retarder;
        element.angle = angle("theta", 0.0, element.angle_texture);
        element.retardance = angle("delta", 90.0, element.retardance_texture);
    } else {
        element.kind = plugin.boolean("left_handed", false) ? Kind::left_circular : Kind::right_circular;
    }
    element.transmittance = plugin.uniform("transmittance", 1.0, 0.0, 1.0);
    plugin.finish();
    static_cast<void>(plugin.objects({}));
    return element;
}

bool PolarizationElements::are(const ShapeDescription& shape, pugi::xml_node bsdf) {
    return is_element_material(bsdf) && is_flat(shape) && !shape.emission;
}

void PolarizationElements::add(pugi::xml_node place, const ShapeDescription& shape, pugi::xml_node bsdf) {
    if (elements_.size() == kMostElements)
        document_.fail(place, "more than " + std::to_string(kMostElements) + " polarization elements",
                       ErrorCode::unsupported);
    if (shape.kind == ShapeDescription::Kind::disk && type_of(bsdf) != "circular")
        document_.fail(place,
                       "a " + std::string(type_of(bsdf)) +
                           " on a disk, whose x axis goes round with the angle; expected a rectangle",
                       ErrorCode::unsupported);
    ElementDescription element = read_element_material(document_, bsdf);
    element.where = document_.where(place);
    element.outline = shape.kind == ShapeDescription::Kind::disk ? PolarizationElement::Outline::disk
                                                                 : PolarizationElement::Outline::rectangle;
    element.to_world = shape.to_world;
    if (shape.flip_normals) element.angle = -element.angle;  // y is the normal cross x
    elements_.push_back({shape, std::move(element)});
}

std::vector<ElementDescription> PolarizationElements::put_before_area_lights(
    std::vector<ShapeDescription>& shapes) const {
    struct Before {
        double distance;
        std::size_t element;
    };
    std::vector<FlatShape> elements;
    for (const Element& element : elements_) elements.emplace_back(element.shape);
    std::vector<bool> used(elements.size(), false);
    for (ShapeDescription& shape : shapes) {
        if (elements.empty() || !is_flat(shape) || !shape.emission || shape.emission->two_sided) continue;
        const FlatShape area_light(shape);
        std::vector<Before> before;
        for (std::size_t i = 0; i < elements.size(); ++i)
            if (const double distance = area_light.distance_to(elements[i]); distance > 0)
                before.push_back({distance, i});
        if (before.empty()) continue;
        std::ranges::sort(before, {}, &Before::distance);
        std::vector<PlacedElement> placed;
        for (const Before& next : before) {
            if (elements_[next.element].element.textured()) break;
            placed.emplace_back(elements_[next.element].element);
            used[next.element] = true;
        }
        if (placed.empty()) continue;
        const LightBehindElements light =
            behind(placed, shape.emission->state, area_light.frame(), glm::dmat3(shape.to_world));
        shape.emission->scale *= light.brightness;
        shape.emission->state = light.state;
    }
    std::vector<ElementDescription> others;
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (!used[i]) others.push_back(elements_[i].element);
    return others;
}

}  // namespace nicol::scene
