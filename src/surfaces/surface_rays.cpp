// SPDX-License-Identifier: MIT
#include "surfaces/surface_rays.hpp"

#include <span>
#include <utility>

namespace nicol {
namespace {

RayScene rays_of(const WorldGeometry& geometry) {
    const RaySurface surface{.positions = geometry.positions,
                             .triangles = geometry.blocking.empty() ? geometry.triangles : geometry.blocking,
                             .present = presence_of(geometry)};
    return RayScene(std::span(&surface, 1));
}

/// A hierarchy and the geometry that its alpha masks refer to.
struct KeptRays {
    explicit KeptRays(std::shared_ptr<const WorldGeometry> of)
        : geometry(std::move(of)), rays(rays_of(*geometry)) {}

    std::shared_ptr<const WorldGeometry> geometry;
    RayScene rays;
};

}  // namespace

std::shared_ptr<const RayScene> SurfaceRays::get() {
    if (rays_ == nullptr) {
        const auto kept = std::make_shared<const KeptRays>(surfaces_.shared_geometry());
        rays_ = {kept, &kept->rays};
    }
    return rays_;
}

}  // namespace nicol
