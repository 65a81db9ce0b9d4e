// SPDX-License-Identifier: MIT
#include "light/local_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <string>
#include <string_view>

#include "arguments.hpp"
#include "light/environment.hpp"

namespace nicol {
namespace {

constexpr double kLeastAngle = 1e-4;

int channels_of(const std::vector<double>& values, const TexturePtr& texture) {
    const int of_texture = texture != nullptr ? texture->channels() : 1;
    return std::max(static_cast<int>(values.size()), of_texture);
}

void check_values(const std::vector<double>& values, std::string_view name) {
    if (values.empty()) refuse(std::string(name) + " has no value");
    for (const double value : values) {
        if (!(value >= 0 && value <= kBrightestLight))
            refuse(std::string(name) + " is " + std::to_string(value) + "; it must lie in 0 to 1e30");
    }
}

void check_texture(const TexturePtr& texture, std::size_t values) {
    if (texture == nullptr) return;
    if (texture->channels() != 1 && texture->channels() != 3)
        refuse("the texture of a light has " + std::to_string(texture->channels()) +
               " channels; it must have 1 or 3");
    if (texture->channels() == 3 && values != 1 && values != 3)
        refuse("the texture of a light has 3 channels and the light " + std::to_string(values));
    if (texture->range().x < 0) refuse("the texture of a light has negative values");
}

void check_angle(double value, double low, double high, std::string_view name) {
    if (value >= low && value <= high) return;
    refuse(std::string(name) + " is " + std::to_string(value) + "; it must lie in " + std::to_string(low) +
           " to " + std::to_string(high) + " radians");
}

void check_rigid(const glm::dmat4& m) {
    const glm::dmat3 axes(m);
    const glm::dmat3 product = glm::transpose(axes) * axes;
    constexpr double rounding = 1e-4;
    bool rigid = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1 && glm::determinant(axes) > 0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) rigid = rigid && std::abs(product[i][k] - (i == k ? 1 : 0)) <= rounding;
        rigid = rigid && std::isfinite(m[3][i]);
    }
    if (!rigid) refuse("to_world of a light must be a rotation and a shift");
}

// Margin by which outlines are smaller than the light, so that an element that just covers the light holds
// them.
constexpr double kMargin = 1e-6;

/// Returns the corners of a polygon around a circle that is seen under an angle from the axis.
std::vector<glm::dvec3> around_circle(double angle) {
    constexpr int corners = 32;
    const double radius = std::tan(angle) * (1 - kMargin) / std::cos(std::numbers::pi / corners);
    std::vector<glm::dvec3> out;
    for (int i = 0; i < corners; ++i) {
        const double at = 2 * std::numbers::pi * i / corners;
        out.emplace_back(radius * std::cos(at), radius * std::sin(at), 1);
    }
    return out;
}

double even_pattern(const LocalLight& /*light*/, const glm::dvec3& /*direction*/) {
    return 1;
}

void check_directional(const LocalLight& light) {
    check_angle(light.angular_radius, 0, std::numbers::pi / 2, "angular_radius");
}
std::vector<glm::dvec3> directional_outline(const LocalLight& light) {
    if (light.angular_radius > 0) return around_circle(light.angular_radius);
    return {glm::dvec3(0, 0, 1)};
}

void check_point(const LocalLight& /*light*/) {}
std::vector<glm::dvec3> point_outline(const LocalLight& /*light*/) {
    return {};
}

void check_spot(const LocalLight& spot) {
    check_angle(spot.cutoff_angle, kLeastAngle, std::numbers::pi / 2, "cutoff_angle");
    check_angle(spot.beam_width, 0, spot.cutoff_angle, "beam_width");
}
double spot_pattern(const LocalLight& spot, const glm::dvec3& direction) {
    if (direction.z >= std::cos(spot.beam_width)) return 1;
    if (direction.z <= std::cos(spot.cutoff_angle)) return 0;
    return (spot.cutoff_angle - std::acos(direction.z)) / (spot.cutoff_angle - spot.beam_width);
}
std::vector<glm::dvec3> spot_outline(const LocalLight& spot) {
    return around_circle(spot.cutoff_angle);
}
glm::dvec2 spot_texcoords(const LocalLight& spot, const glm::dvec2& at) {
    return 0.5 + 0.5 / std::tan(spot.cutoff_angle) * at;
}

void check_projector(const LocalLight& projector) {
    check_angle(projector.fov, kLeastAngle, std::numbers::pi - kLeastAngle, "fov");
    if (!(projector.aspect > 0 && std::isfinite(projector.aspect)))
        refuse("aspect is " + std::to_string(projector.aspect) + "; it must be finite and above 0");
}
// On the plane z = 1, the distance 1 / cosine contributes cosine^2, and the angle of incidence contributes
// cosine.
double projector_pattern(const LocalLight& projector, const glm::dvec3& direction) {
    const double half_width = std::tan(projector.fov / 2);
    const bool inside = direction.z > 0 && std::abs(direction.x) <= half_width * direction.z &&
                        std::abs(direction.y) * projector.aspect <= half_width * direction.z;
    return inside ? 1 / (direction.z * direction.z * direction.z) : 0;
}
std::vector<glm::dvec3> projector_outline(const LocalLight& projector) {
    const double x = std::tan(projector.fov / 2) * (1 - kMargin);
    const double y = x / projector.aspect;
    return {{x, y, 1}, {-x, y, 1}, {-x, -y, 1}, {x, -y, 1}};
}
glm::dvec2 projector_texcoords(const LocalLight& projector, const glm::dvec2& at) {
    return 0.5 - 0.5 / std::tan(projector.fov / 2) * glm::dvec2(1, projector.aspect) * at;
}

/// Everything that distinguishes the lights of one kind. Functions of directions take local axes.
struct KindRow {
    std::string_view name;
    void (*check)(const LocalLight& light);
    double (*pattern)(const LocalLight& light, const glm::dvec3& direction);
    std::vector<glm::dvec3> (*outline)(const LocalLight& light);
    /// u and v along the direction (at.x, at.y, 1); null: the kind has no texture.
    glm::dvec2 (*texcoords)(const LocalLight& light, const glm::dvec2& at);
};

/// In the order of LocalLight::Kind.
constexpr std::array kKinds = {
    KindRow{"directional light", check_directional, even_pattern, directional_outline, nullptr},
    KindRow{"point light", check_point, even_pattern, point_outline, nullptr},
    KindRow{"spot", check_spot, spot_pattern, spot_outline, spot_texcoords},
    KindRow{"projector", check_projector, projector_pattern, projector_outline, projector_texcoords}};

const KindRow& row_of(LocalLight::Kind kind) {
    return kKinds[static_cast<std::size_t>(kind)];
}

}  // namespace

int LocalLight::channels() const noexcept {
    return channels_of(value, texture);
}

int Emission::channels() const noexcept {
    return channels_of(radiance, texture);
}

void check(const LocalLight& light) {
    check_values(light.value, "the value of a light");
    check_rigid(light.to_world);
    check(light.state);
    const KindRow& kind = row_of(light.kind);
    kind.check(light);
    if (light.texture != nullptr && kind.texcoords == nullptr)
        refuse("only spots and projectors have a texture");
    check_texture(light.texture, light.value.size());
    if (light.texture != nullptr && needs_colors(*light.texture))
        refuse("the texture of a light cannot be the colours of a mesh");
}

void check(const Emission& emission) {
    check_values(emission.radiance, "the radiance of a surface");
    check(emission.state);
    check_texture(emission.texture, emission.radiance.size());
}

std::string_view light_name(LocalLight::Kind kind) {
    return row_of(kind).name;
}

double light_pattern(const LocalLight& light, const glm::dvec3& direction) {
    return row_of(light.kind).pattern(light, direction);
}

std::vector<glm::dvec3> light_outline(const LocalLight& light) {
    return row_of(light.kind).outline(light);
}

glm::dvec2 light_texcoords(const LocalLight& light, const glm::dvec3& direction) {
    return row_of(light.kind).texcoords(light, glm::dvec2(direction) / direction.z);
}

double textured_value(const std::vector<double>& value, const TexturePtr& texture, const glm::vec4& texel,
                      int channel) {
    const double plain = value.size() == 1 ? value[0] : value[static_cast<std::size_t>(channel)];
    if (texture == nullptr) return plain;
    return plain * static_cast<double>(texel[texture->channels() == 1 ? 0 : channel]);
}

}  // namespace nicol
