// SPDX-License-Identifier: MIT
// How much memory a scene will take, before it takes it.
#pragma once

#include <cstdint>
#include <limits>

#include "harmonics/light_layout.hpp"
#include "render/render.hpp"
#include "scene/scene.hpp"
#include "versioned.hpp"

namespace nicol {

/// Bytes at most where no vertices are added, as Statistics counts them. Where orders are chosen, those of
/// the options are assumed.
struct MemoryEstimate {
    std::uint64_t visibility = 0;
    std::uint64_t transfer = 0;
    std::uint64_t buffers = 0;  ///< of vertices and triangles, without what compute shaders work on

    [[nodiscard]] std::uint64_t total() const noexcept { return visibility + transfer + buffers; }
};

/// Takes milliseconds and allocates little, whatever the scene's size. Of the reference method: the hierarchy
/// of triangles and the triangles themselves.
[[nodiscard]] MemoryEstimate estimate_memory(const Scene& scene, const RenderOptions& options);

/// What a scene may take at most.
class MemoryLimit {
public:
    static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

    explicit MemoryLimit(std::uint64_t bytes = kNone) : bytes_(bytes) {}

    [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }
    /// Throws Error(out_of_memory) with both numbers where the estimate exceeds the limit. Estimates again
    /// only where something that the estimate depends on has changed since the last call.
    void check(const Scene& scene, const RenderOptions& options);

    /// How many vertices the scene that was last checked may be refined to: as the option says, or where that
    /// leaves it open 65536 or four times as many as there are; but no more than fit beside their bake.
    [[nodiscard]] std::uint64_t max_vertices(const RenderOptions& options) const;

private:
    std::uint64_t bytes_;
    std::uint64_t vertices_ = 0;
    MemoryEstimate estimate_;
    // Geometry, channels, components of the light, and the options that matter.
    Stage<Version, int, LightKind, Method, int, int, HighOrders, bool, bool, int, std::uint32_t> checking_;
};

}  // namespace nicol
