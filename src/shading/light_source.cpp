// SPDX-License-Identifier: MIT
#include "shading/light_source.hpp"

#include <algorithm>
#include <cmath>

#include "light/environment.hpp"
#include "material/reflectance.hpp"
#include "shading/directional_source.hpp"
#include "shading/globe_source.hpp"
#include "shading/point_source.hpp"
#include "shading/surface_source.hpp"

namespace nicol {

LightSourcePtr light_source(const SmallLight& light, const glm::dmat4& to_axes) {
    const glm::dmat4 axes = to_axes * light.to_world;
    if (light.kind == SmallLight::Kind::directional)
        return std::make_unique<const DirectionalSource>(light, glm::dmat3(axes));
    return std::make_unique<const PointSource>(light, axes);
}

LightSourcePtr light_source(const ShiningSurface& surface) {
    if (surface.emission.texture == nullptr && !surface.emission.two_sided) {
        if (const std::optional<Globe> globe = globe_of(surface.triangles))
            return std::make_unique<const GlobeSource>(*globe, surface.emission, surface.axis);
    }
    auto source = std::make_unique<const SurfaceSource>(surface);
    if (!(source->area() > 0)) return nullptr;
    return source;
}

SourceColor::SourceColor(const std::vector<double>& value, int channels, const PolarizationState& state)
    : components_(state.circular()    ? 4
                  : state.polarized() ? 3
                                      : 1) {
    constexpr double least = 1e-8;  // so that the quotient is a float
    largest_factor_ = static_cast<float>(kBrightestLight / std::max(std::ranges::max(value), least));
    for (int c = 0; c < channels; ++c) {
        const Stokes stokes = of_channel(value, c) * state.stokes();
        std::array<float, 4>& out = stokes_.emplace_back();
        for (glm::length_t p = 0; p < 4; ++p)
            out[static_cast<std::size_t>(p)] = static_cast<float>(stokes[p]);
    }
}

void SourceColor::put(std::span<const Lanes> factors, LaneLight& out) const {
    out.components = components_;
    out.irradiance.resize(stokes_.size());
    for (std::size_t c = 0; c < stokes_.size(); ++c) {
        const Lanes& factor = factors[std::min(c, factors.size() - 1)];
        for (std::size_t p = 0; p < components_; ++p)
            for (std::size_t i = 0; i < kLanes; ++i)
                out.irradiance[c][p][i] = stokes_[c][p] * std::min(factor[i], largest_factor_);
    }
}

void put_axes(const glm::vec3& axis, LaneLight& out) {
    // Where the axis lies along the light, any direction across it will do; so near is that for floats.
    constexpr float parallel = 1e-10F;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3 towards(out.towards.x[i], out.towards.y[i], out.towards.z[i]);
        const float along = axis.x * towards.x + axis.y * towards.y + axis.z * towards.z;
        glm::vec3 x = axis - along * towards;
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

}  // namespace nicol
