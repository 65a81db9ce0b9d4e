// SPDX-License-Identifier: MIT
// How much memory a scene will take, before it takes it.
#pragma once

#include <cstdint>
#include <limits>

#include "harmonics/light_layout.hpp"
#include "scene/scene.hpp"
#include "stage/options.hpp"
#include "stage/statistics.hpp"
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

/// Bytes that samples and shading at pixels take at most beside a framebuffer of this size and the scene's
/// channels, as Statistics counts them.
[[nodiscard]] std::uint64_t image_memory(const Scene& scene, const RenderOptions& options, int width,
                                         int height);

/// What a scene and its image may take at most.
class MemoryLimit {
public:
    static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

    explicit MemoryLimit(std::uint64_t bytes = kNone) : bytes_(bytes) {}

    /// Throws Error(out_of_memory) with both numbers where the estimate exceeds the limit. Estimates again
    /// only where something that the estimate depends on has changed since the last call.
    void check(const Scene& scene, const RenderOptions& options, int width, int height);

    /// What the image that was last checked leaves to the scene.
    [[nodiscard]] std::uint64_t for_scene() const noexcept {
        return bytes_ == kNone ? kNone : bytes_ - image_;
    }

    /// How many vertices the scene that was last checked may be refined to: as the option says, or where that
    /// leaves it open 65536 or four times as many as there are; but no more than fit beside their bake.
    [[nodiscard]] std::uint64_t max_vertices(const RenderOptions& options) const;

private:
    std::uint64_t bytes_;
    std::uint64_t vertices_ = 0;
    MemoryEstimate estimate_;
    std::uint64_t image_ = 0;
    // Geometry, channels, components of the light, the options that matter, and the image's bytes.
    Stage<Version, int, LightKind, Method, int, int, HighOrders, bool, bool, int, std::uint32_t,
          std::uint64_t>
        checking_;
};

}  // namespace nicol
