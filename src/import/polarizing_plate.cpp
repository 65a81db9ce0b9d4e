// SPDX-License-Identifier: MIT
#include "import/polarizing_plate.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string>
#include <string_view>

#include "import/plugin.hpp"

namespace nicol::scene {
namespace {

// Every lamp is compared with every plate.
constexpr std::size_t kMostPlates = 1000;
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

    /// How far a plate stands before this lamp; 0 or less if it does not.
    [[nodiscard]] double distance_to(const FlatShape& plate) const {
        constexpr double nearer_than = 0.1;
        const double most_parallel = std::cos(glm::radians(0.1));
        const double distance = glm::dot(plate.center_ - center_, normal_);
        const bool before = distance > 0 &&
                            distance < nearer_than * std::min(glm::length(u_), glm::length(v_)) &&
                            std::abs(glm::dot(normal_, plate.normal_)) >= most_parallel && lies_on(plate);
        return before ? distance : 0;
    }

private:
    /// Of the outline, moved along the plate's normal: both are convex.
    [[nodiscard]] bool lies_on(const FlatShape& plate) const {
        const int points = round_ ? 64 : 4;
        const double radius = round_ ? 1 : std::sqrt(2.0);
        for (int i = 0; i < points; ++i) {
            const double angle = 2 * pi * (i + 0.5) / points;
            if (!plate.holds(center_ + radius * (std::cos(angle) * u_ + std::sin(angle) * v_))) return false;
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

LightBehindPlates behind(std::span<const PlacedPlate> plates, const PolarizationState& state,
                         const Frame& frame, const glm::dmat3& to_world) {
    Stokes light = stokes_in(frame, state, glm::normalize(to_world * state.axis));
    for (const PlacedPlate& plate : plates) light = plate.mueller(frame) * light;
    LightBehindPlates out{.brightness = light[0], .state = {}};
    if (light[0] <= 0) return out;
    out.state.dolp = std::min(std::hypot(light[1], light[2]) / light[0], 1.0);
    out.state.aolp = pi / 2;
    out.state.docp = std::clamp(light[3] / light[0], -1.0, 1.0);
    // Where there is least light, in the plane of the last plate: a polarizer's axis, which absorbs however
    // light passes.
    const double angle = std::atan2(light[2], light[1]) / 2 + pi / 2;
    const glm::dvec3 least = std::cos(angle) * frame[0] + std::sin(angle) * frame[1];
    const glm::dvec3& normal = plates.back().normal();
    const glm::dvec3 in_plane = glm::dot(frame[2], normal) * least - glm::dot(least, normal) * frame[2];
    out.state.axis = glm::normalize(glm::inverse(to_world) * in_plane);
    return out;
}

bool is_plate_material(pugi::xml_node bsdf) {
    const std::string_view type = type_of(bsdf);
    return type == "polarizer" || type == "retarder" || type == "circular";
}

PolarizingPlate read_plate_material(const XmlDocument& document, pugi::xml_node bsdf) {
    using Kind = PolarizingPlate::Kind;
    Plugin plugin(document, bsdf);
    PolarizingPlate plate;
    const auto angle = [&](const char* name, double otherwise) {
        return glm::radians(plugin.uniform(name, otherwise, -kNoLimit, kNoLimit));
    };
    if (plugin.type() == "polarizer") {
        // Mitsuba turns polarizers clockwise, and retarders counter-clockwise.
        plate.angle = -angle("theta", 0.0);
        if (!plugin.boolean("polarizing", true))
            plugin.fail("polarizing", "is false; expected true", ErrorCode::unsupported);
    } else if (plugin.type() == "retarder") {
        plate.kind = Kind::retarder;
        plate.angle = angle("theta", 0.0);
        plate.retardance = angle("delta", 90.0);
    } else {
        plate.kind = plugin.boolean("left_handed", false) ? Kind::left_circular : Kind::right_circular;
    }
    plate.transmittance = plugin.uniform("transmittance", 1.0, 0.0, 1.0);
    plugin.finish();
    static_cast<void>(plugin.objects({}));
    return plate;
}

bool PolarizingPlates::are(const ShapeDescription& shape, pugi::xml_node bsdf) {
    return is_plate_material(bsdf) && is_flat(shape) && !shape.emission;
}

void PolarizingPlates::add(pugi::xml_node place, const ShapeDescription& shape, pugi::xml_node bsdf) {
    if (plates_.size() == kMostPlates)
        document_.fail(place, "more than " + std::to_string(kMostPlates) + " polarizing plates",
                       ErrorCode::unsupported);
    if (shape.kind == ShapeDescription::Kind::disk && type_of(bsdf) != "circular")
        document_.fail(place,
                       "a " + std::string(type_of(bsdf)) +
                           " on a disk, whose x axis goes round with the angle; expected a rectangle",
                       ErrorCode::unsupported);
    PolarizingPlate plate = read_plate_material(document_, bsdf);
    plate.outline = shape.kind == ShapeDescription::Kind::disk ? PolarizingPlate::Outline::disk
                                                               : PolarizingPlate::Outline::rectangle;
    plate.to_world = shape.to_world;
    if (shape.flip_normals) plate.angle = -plate.angle;  // y is the normal cross x
    plates_.push_back({place, shape, plate});
}

std::vector<PlateDescription> PolarizingPlates::put_before_lamps(
    std::vector<ShapeDescription>& shapes) const {
    struct Before {
        double distance;
        std::size_t plate;
    };
    std::vector<FlatShape> plates;
    for (const Plate& plate : plates_) plates.emplace_back(plate.shape);
    std::vector<bool> used(plates.size(), false);
    for (ShapeDescription& shape : shapes) {
        if (plates.empty() || !is_flat(shape) || !shape.emission || shape.emission->two_sided) continue;
        const FlatShape lamp(shape);
        std::vector<Before> before;
        for (std::size_t i = 0; i < plates.size(); ++i)
            if (const double distance = lamp.distance_to(plates[i]); distance > 0)
                before.push_back({distance, i});
        if (before.empty()) continue;
        std::ranges::sort(before, {}, &Before::distance);
        std::vector<PlacedPlate> placed;
        for (const auto& [distance, plate] : before) {
            placed.emplace_back(plates_[plate].plate);
            used[plate] = true;
        }
        const LightBehindPlates light =
            behind(placed, shape.emission->state, lamp.frame(), glm::dmat3(shape.to_world));
        shape.emission->scale *= light.brightness;
        shape.emission->state = light.state;
    }
    std::vector<PlateDescription> others;
    for (std::size_t i = 0; i < plates.size(); ++i)
        if (!used[i]) others.push_back({plates_[i].plate, document_.where(plates_[i].place)});
    return others;
}

}  // namespace nicol::scene
