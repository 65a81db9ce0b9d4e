// SPDX-License-Identifier: MIT
#include "shading/light_source.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "light/environment.hpp"
#include "material/reflectance.hpp"
#include "shading/simple_sources.hpp"
#include "shading/surface_source.hpp"

namespace nicol {
namespace {

bool dark(const std::vector<double>& value) {
    return std::ranges::all_of(value, [](double of_channel) { return of_channel == 0; });
}

}  // namespace

LightSourcePtr light_source(const LocalLight& light, const glm::dmat4& to_axes) {
    if (dark(light.value)) return nullptr;
    const glm::dmat4 axes = to_axes * light.to_world;
    return simple_source(
        light, {light.value, light.texture, light.state, glm::dmat3(axes) * light.state.axis}, axes);
}

LightSourcePtr unit_sources(const LocalLight& light, int channels, const glm::dmat4& to_axes) {
    const glm::dmat4 axes = to_axes * light.to_world;
    return simple_source(
        light, SourceColor::units(channels, light.texture, glm::dmat3(axes) * light.state.axis), axes);
}

LightSourcePtr light_source(const EmissiveSurface& surface) {
    if (dark(surface.emission.radiance)) return nullptr;
    if (surface.emission.texture == nullptr && !surface.emission.two_sided) {
        if (LightSourcePtr sphere = sphere_source(surface)) return sphere;
    }
    auto source = std::make_unique<const SurfaceSource>(surface);
    if (!(source->area() > 0)) return nullptr;
    return source;
}

SourceColor::SourceColor(const std::vector<double>& value, TexturePtr texture, const PolarizationState& state,
                         const glm::dvec3& axis)
    : texture_(std::move(texture)),
      axis_(glm::normalize(axis)),
      components_(state.circular()    ? 4
                  : state.polarized() ? 3
                                      : 1) {
    constexpr double least = 1e-8;  // keeps the quotient in the range of float
    brightest_ = static_cast<float>(std::ranges::max(value));
    largest_factor_ = static_cast<float>(kBrightestLight / std::max(std::ranges::max(value), least));
    const int of_texture = texture_ != nullptr ? texture_->channels() : 1;
    for (int c = 0; c < std::max(static_cast<int>(value.size()), of_texture); ++c) {
        const Stokes stokes = of_channel(value, c) * state.stokes();
        std::array<float, 4>& out = stokes_.emplace_back();
        for (glm::length_t p = 0; p < 4; ++p)
            out[static_cast<std::size_t>(p)] = static_cast<float>(stokes[p]);
    }
}

SourceColor SourceColor::units(int channels, TexturePtr texture, const glm::dvec3& axis) {
    SourceColor out({1}, std::move(texture), {}, axis);
    out.components_ = 4;
    out.stokes_.clear();
    for (std::size_t p = 0; p < 4; ++p) {
        std::array<float, 4> unit{};
        unit[p] = 1;
        out.stokes_.insert(out.stokes_.end(), static_cast<std::size_t>(channels), unit);
    }
    return out;
}

void SourceColor::put(const Lanes& factor, LaneLight& out) const {
    put_factors({&factor, 1}, out);
}

void SourceColor::put(const Lanes& factor, const TexturePoints& at, LaneLight& out) const {
    if (texture_ == nullptr) return put(factor, out);
    std::array<Lanes, 4> texels;
    texture_->at_lanes(at, texels);
    const std::size_t colors = texture_->channels() == 3 ? 3 : 1;
    for (std::size_t c = 0; c < colors; ++c)
        for (std::size_t i = 0; i < kLanes; ++i) texels[c][i] *= factor[i];
    put_factors(std::span(texels).first(colors), out);
}

void SourceColor::put_factors(std::span<const Lanes> factors, LaneLight& out) const {
    out.components = components_;
    out.irradiance.resize(stokes_.size());
    for (std::size_t c = 0; c < stokes_.size(); ++c) {
        const Lanes& factor = factors[c % factors.size()];
        for (std::size_t p = 0; p < components_; ++p)
            for (std::size_t i = 0; i < kLanes; ++i)
                out.irradiance[c][p][i] = stokes_[c][p] * std::min(factor[i], largest_factor_);
    }
    if (components_ > 1) put_axes(out);
}

void SourceColor::put_axes(LaneLight& out) const {
    // Any direction orthogonal to the light is valid if the axis lies along the light, within float
    // precision.
    constexpr float parallel = 1e-10F;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3 towards = vector_at(out.towards, i);
        const float along = axis_.x * towards.x + axis_.y * towards.y + axis_.z * towards.z;
        glm::vec3 x = axis_ - along * towards;
        float square = x.x * x.x + x.y * x.y + x.z * x.z;
        if (square <= parallel) {
            x = glm::vec3(theta_phi_frame(-glm::dvec3(towards))[0]);
            square = 1;
        }
        const float scale = 1 / std::sqrt(square);
        out.x.x[i] = scale * x.x;
        out.x.y[i] = scale * x.y;
        out.x.z[i] = scale * x.z;
    }
}

float irradiance_of_ball(const glm::vec3& from, const glm::vec3& centre, float radius) {
    const float distance = std::max(radius, glm::distance(from, centre));
    return std::numbers::pi_v<float> * radius * radius / (distance * distance);
}

float angular_radius_of_ball(const glm::vec3& from, const glm::vec3& centre, float radius) {
    const float distance = glm::distance(from, centre);
    return distance > radius ? std::asin(radius / distance) : std::numbers::pi_v<float> / 2;
}

}  // namespace nicol
