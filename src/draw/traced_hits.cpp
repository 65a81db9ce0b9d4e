// SPDX-License-Identifier: MIT
#include "draw/traced_hits.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "draw/alpha_masks.hpp"
#include "scene/pixel_ray.hpp"

namespace nicol {
namespace {

// Costs in the time in which llvmpipe draws one triangle, about 0.15 us of one core.
constexpr double kHierarchyOfTriangle = 3;
constexpr double kRay = 16;
constexpr double kDrawnPixel = 0.05;

// Surfaces that rays meet at one sample of an image's pixels.
class Sample {
public:
    Sample(const HitRequest& request, const DrawnTriangles& triangles, std::size_t sample)
        : request_(request),
          geometry_(request.surfaces.geometry()),
          triangles_(triangles),
          masked_(has_masks(geometry_)),
          sample_(sample) {}

    [[nodiscard]] std::optional<Hit> at(std::size_t column, std::size_t row) const {
        const glm::dvec2 place = glm::dvec2(column, row) + 0.5 + request_.offsets[sample_];
        Ray ray = pixel_ray(request_.projection, request_.width, request_.height, place.x, place.y);
        std::optional<RayHit> found = triangles_.intersect(ray);
        while (found && masked_ && !present(*found, column, row)) {
            ray.nearest = found->distance * (1 + kBehindMask);
            found = triangles_.intersect(ray);
        }
        if (!found) return std::nullopt;
        const glm::uvec3& corners = geometry_.triangles[found->triangle];
        const glm::dvec3 a(geometry_.positions[corners.x]);
        const glm::dvec3 b(geometry_.positions[corners.y]), c(geometry_.positions[corners.z]);
        return Hit{.triangle = found->triangle,
                   .front = glm::dot(glm::cross(b - a, c - a), ray.direction) < 0};
    }

private:
    // Part of a distance that a ray goes on from a place where a mask lets it pass.
    static constexpr double kBehindMask = 0x1p-20;

    // Decides as glsl/alpha_mask.glsl does.
    [[nodiscard]] bool present(const RayHit& hit, std::size_t column, std::size_t row) const {
        const float chance = chance_at(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        const float threshold =
            (static_cast<float>(sample_) + chance) / static_cast<float>(request_.offsets.size());
        return is_present(geometry_, hit.triangle, static_cast<float>(hit.b1), static_cast<float>(hit.b2),
                          threshold);
    }

    const HitRequest& request_;
    const WorldGeometry& geometry_;
    const DrawnTriangles& triangles_;
    bool masked_;
    std::size_t sample_;
};

}  // namespace

void TracedHits::find(const HitRequest& request, VisibilityBuffer& out) {
    building_.run(request.surfaces.version(), request.surfaces.material_version(), [&] {
        const WorldGeometry& geometry = request.surfaces.geometry();
        triangles_ = has_masks(geometry)
                         ? std::make_shared<const DrawnTriangles>(geometry, DrawnTriangles::Masks::block)
                         : rays_.get(request.surfaces);
    });
    out.resize(request.width, request.height, request.offsets, request.kept);
    const auto columns = static_cast<std::size_t>(request.width);
    const auto rows = static_cast<std::size_t>(request.height);
    const auto trace_row = [&](std::size_t sample, std::size_t row) {
        const Sample surfaces(request, *triangles_, sample);
        const std::span<std::uint32_t> texels = out.texels(sample).subspan(row * columns, columns);
        for (std::size_t column = 0; column < columns; ++column)
            texels[column] = VisibilityBuffer::texel(surfaces.at(column, row));
    };
    workers_.run([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows * request.offsets.size()),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              for (std::size_t i = range.begin(); i < range.end(); ++i)
                                  trace_row(i / rows, i % rows);
                          });
    });
}

void TracedHits::clear() noexcept {
    building_.reset();
    triangles_.reset();
}

bool rays_cost_less(const HitRequest& request, double images) {
    const auto triangles = static_cast<double>(request.surfaces.geometry().triangles.size());
    const double pixels = static_cast<double>(request.width) * static_cast<double>(request.height);
    const double samples = images * static_cast<double>(request.offsets.size());
    return kHierarchyOfTriangle * triangles + samples * kRay * pixels <
           samples * (triangles + kDrawnPixel * pixels);
}

}  // namespace nicol
