// SPDX-License-Identifier: MIT
// What every method of transfer starts from.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "harmonics/psh.hpp"
#include "render/geometry.hpp"
#include "render/workers.hpp"
#include "visibility/visibility.hpp"
#include "visibility/visibility_blocks.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol {

/// An earlier state of a scene and what of it still holds.
struct Unchanged {
    std::uint64_t geometry;  ///< revisions of that state
    std::uint64_t visibility;
    /// 1 for vertices that have the same number, place, normal and visibility as then.
    std::span<const std::uint8_t> vertices;
};

/// Coefficients of visibility that someone else waits for.
struct AwaitedVisibility {
    VisibilityBlocks blocks;
    bool filled = false;
};

/// A scene as numbers. Revisions count changes; what depends on the same ones need not be computed again.
struct TransferInput {
    const WorldGeometry& geometry;
    std::uint64_t geometry_revision;  ///< of vertices and triangles
    std::uint64_t material_revision;  ///< of the materials of the geometry's ranges
    const LightLayout& layout;
    const PshVector& light;  ///< in the geometry's axes, scaled; one channel where all are equal
    std::uint64_t light_revision;
    int channels;                  ///< of the image
    const Visibility* visibility;  ///< of the vertices; null where nothing casts shadows
    const DirectionSet* directions;
    std::uint64_t visibility_revision;  ///< 0 where there is none
    /// Of reflected light: the first so many components are shaded even where they are zero ...
    std::size_t least_components = 1;
    /// ... and so many where they are not.
    std::size_t most_components = 4;
    std::optional<Unchanged> unchanged;
    /// To be filled by who computes them anyway, all and of this order; null: nobody waits.
    AwaitedVisibility* awaited = nullptr;
};

/// The state that a method's per-vertex light was made for.
struct RelightKey {
    std::uint64_t geometry = 0;
    std::uint64_t light = 0;
    std::uint64_t visibility = 0;
    int order = -1;
    LightKind kind = LightKind::unpolarized;

    RelightKey() = default;
    explicit RelightKey(const TransferInput& input)
        : geometry(input.geometry_revision),
          light(input.light_revision),
          visibility(input.visibility_revision),
          order(input.layout.order()),
          kind(input.layout.kind()) {}
    /// The state that shadows and matrices are made for.
    [[nodiscard]] RelightKey without_light() const {
        RelightKey key = *this;
        key.light = 0;
        return key;
    }
    /// The state before that input.unchanged tells of, else as `input`; none where it tells of none.
    [[nodiscard]] static std::optional<RelightKey> before(const TransferInput& input) {
        if (!input.unchanged) return std::nullopt;
        RelightKey key(input);
        key.geometry = input.unchanged->geometry;
        key.visibility = input.unchanged->visibility;
        return key;
    }
    bool operator==(const RelightKey&) const = default;
};

/// Calls body(begin, end) for the longest runs of first <= i < last with stale(i).
template <class Stale, class Body>
void for_runs(std::size_t first, std::size_t last, const Stale& stale, const Body& body) {
    for (std::size_t i = first; i < last;) {
        if (!stale(i)) {
            ++i;
            continue;
        }
        const std::size_t begin = i;
        while (i < last && stale(i)) ++i;
        body(begin, i);
    }
}

/// One Stokes vector a vertex for each channel of the image.
using VertexStokes = std::vector<std::vector<glm::vec4>>;

}  // namespace nicol
