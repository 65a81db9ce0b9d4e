// SPDX-License-Identifier: MIT
#include "surfaces/surface_rays.hpp"

#include <span>

namespace nicol {

std::shared_ptr<const RayScene> SurfaceRays::of(const SceneGeometry& surfaces) {
    building_.run(surfaces.version(), [&] {
        clear();
        geometry_ = surfaces.shared_geometry();
        const RaySurface surface{.positions = geometry_->positions,
                                 .triangles = geometry_->triangles,
                                 .present = presence_of(*geometry_)};
        rays_ = std::make_shared<const RayScene>(std::span(&surface, 1));
    });
    return rays_;
}

void SurfaceRays::clear() noexcept {
    building_.reset();
    rays_.reset();
    geometry_.reset();
}

}  // namespace nicol
