// SPDX-License-Identifier: MIT
#include "transfer/surface_links.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "visibility/bake_origins.hpp"

namespace nicol {
namespace {

// Returns a number of 0 to count - 1 that depends on the vertex and the stratum as if by chance.
std::size_t choice(std::size_t vertex, std::size_t stratum, std::size_t count) {
    std::uint64_t x = (vertex * kLinkStrata + stratum + 1) * 0x9e3779b97f4a7c15U;
    x = (x ^ x >> 32U) * 0xd6e8feb86659fd93U;
    return static_cast<std::size_t>((x >> 32U) * count >> 32U);
}

// Does the same for a part of a stratum.
std::size_t choice_in_part(std::size_t vertex, std::size_t part, std::size_t count) {
    std::uint64_t x = (vertex * kLinkStrata * kPartsOfStratum + part + 1) * 0x9e3779b97f4a7c15U;
    x = (x ^ x >> 30U) * 0xbf58476d1ce4e5b9U;
    x = (x ^ x >> 27U) * 0x94d049bb133111ebU;
    return static_cast<std::size_t>((x >> 32U) * count >> 32U);
}

}  // namespace

LinkSearch::LinkSearch(const BakeGeometry& geometry, const TriangleSides& sides,
                       const DirectionSet& directions, const Visibility& visibility)
    : directions_(directions),
      visibility_(visibility),
      stratum_size_((directions.size() + kLinkStrata - 1) / kLinkStrata) {
    normals_.reserve(geometry.normals.size());
    for (const glm::vec3& normal : geometry.normals) normals_.push_back(glm::normalize(normal));
    origins_ = bake_origins(geometry, normals_);
    points_ = std::make_unique<const SurfacePoints>(geometry, sides);
}

LinkSearch::~LinkSearch() = default;

float LinkSearch::find_blocked(std::size_t vertex, std::size_t first, std::size_t last,
                               std::vector<std::uint32_t>& blocked) const {
    blocked.clear();
    float solid_angle = 0;
    for (std::size_t d = first; d < std::min(last, directions_.size()); ++d) {
        if (visibility_.seen(vertex, d) || !(glm::dot(directions_.directions()[d], normals_[vertex]) > 0))
            continue;
        blocked.push_back(static_cast<std::uint32_t>(d));
        solid_angle += directions_.weights()[d];
    }
    return solid_angle;
}

float LinkSearch::add(std::size_t vertex, SurfaceLink link, std::vector<SurfaceLink>& links) const {
    const std::optional<RayHit> hit =
        points_->find({.origin = glm::dvec3(origins_[vertex]),
                       .direction = glm::dvec3(directions_.directions()[link.direction])});
    if (!hit) return 0;
    link.triangle = hit->triangle;
    link.b1 = static_cast<float>(hit->b1);
    link.b2 = static_cast<float>(hit->b2);
    links.push_back(link);
    return static_cast<float>(hit->distance);
}

float LinkSearch::find(std::size_t vertex, std::vector<SurfaceLink>& links) const {
    links.clear();
    if (visibility_.unoccluded(vertex)) return 0;
    std::vector<std::uint32_t> blocked;
    blocked.reserve(stratum_size_);
    float nearness = 0, all = 0;  // sums of solid angles, over distances and alone
    for (std::size_t stratum = 0; stratum < kLinkStrata; ++stratum) {
        const std::size_t first = stratum * stratum_size_;
        SurfaceLink link{};
        link.solid_angle = link.coarse_solid_angle =
            find_blocked(vertex, first, first + stratum_size_, blocked);
        if (blocked.empty()) continue;
        link.direction = blocked[choice(vertex, stratum, blocked.size())];
        const float distance = add(vertex, link, links);
        if (!(distance > 0)) continue;
        nearness += link.solid_angle / distance;
        all += link.solid_angle;
    }
    return links.empty() ? 0 : all / nearness;
}

void LinkSearch::refine(std::size_t vertex, std::vector<SurfaceLink>& links) const {
    const std::size_t part_size = (stratum_size_ + kPartsOfStratum - 1) / kPartsOfStratum;
    std::vector<std::uint32_t> blocked;
    blocked.reserve(stratum_size_);
    std::size_t next = 0;  // coarse link
    const std::size_t coarse = links.size();
    for (std::size_t stratum = 0; stratum < kLinkStrata; ++stratum) {
        const std::size_t begin = stratum * stratum_size_, end = begin + stratum_size_;
        find_blocked(vertex, begin, end, blocked);
        if (blocked.empty()) continue;
        const std::uint32_t chosen = blocked[choice(vertex, stratum, blocked.size())];
        std::size_t part = stratum * kPartsOfStratum;
        for (std::size_t first = begin; first < end; first += part_size, ++part) {
            const std::size_t last = std::min(first + part_size, end);
            SurfaceLink link{};
            link.solid_angle = find_blocked(vertex, first, last, blocked);
            if (blocked.empty()) continue;
            if (chosen >= first && chosen < last) {
                // The coarse link, which is missing if nothing leaves light there.
                if (next < coarse && links[next].direction == chosen)
                    links[next++].solid_angle = link.solid_angle;
                continue;
            }
            link.direction = blocked[choice_in_part(vertex, part, blocked.size())];
            add(vertex, link, links);
        }
    }
}

}  // namespace nicol
