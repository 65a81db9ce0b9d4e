// SPDX-License-Identifier: MIT
// Estimate of the memory that a scene will take.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "harmonics/light_layout.hpp"
#include "memory_share.hpp"
#include "scene/scene.hpp"
#include "stage/options.hpp"
#include "stage/statistics.hpp"
#include "texture/texture.hpp"
#include "versioned.hpp"

namespace nicol {

/// Largest number of bytes if no vertices are added, counted as in Statistics. If orders are chosen, the
/// estimate assumes the orders of the options.
struct MemoryEstimate {
    std::uint64_t visibility = 0;
    std::uint64_t transfer = 0;
    /// Buffers of vertices and triangles, without the work space of compute shaders.
    std::uint64_t buffers = 0;
    /// Light that smooth surfaces focus, as transfer, and photons while they exist. Vertices add to neither.
    std::uint64_t focused = 0;

    [[nodiscard]] std::uint64_t total() const noexcept { return of_vertices() + focused; }
    /// Returns the part that grows with the number of vertices.
    [[nodiscard]] std::uint64_t of_vertices() const noexcept { return visibility + transfer + buffers; }
};

/// All that estimate_memory() depends on.
struct MemoryInputs {
    MemoryInputs(const Scene& scene, const RenderOptions& options);
    bool operator==(const MemoryInputs&) const = default;

    std::uint64_t paths;  ///< bytes of focused light and photons
    Version geometry;
    std::optional<LightKind> distant;
    LightKind kind;
    HighOrders high_orders;
    Method method;
    int channels;
    int order_low;
    int order_high;
    int bake_directions;
    std::uint32_t disabled_optimisations;
    bool bounces;
    bool shadows;
    bool high_order_shadows;
};

/// Returns the estimate for a scene. Takes milliseconds and allocates little, whatever the scene's size. For
/// the reference method, the estimate includes the ray hierarchy and the triangles themselves.
[[nodiscard]] MemoryEstimate estimate_memory(const Scene& scene, const RenderOptions& options);

/// Returns the largest number of bytes that samples and shading at pixels take beside a framebuffer of this
/// size with the scene's channels, counted as in Statistics.
[[nodiscard]] std::uint64_t image_memory(const Scene& scene, const RenderOptions& options, int width,
                                         int height);

/// Largest number of bytes that gradients take while they are computed.
struct GradientMemory {
    std::uint64_t of_vertices = 0;  ///< grows with the number of vertices
    std::uint64_t texels = 0;
};

/// Returns the memory that gradients take beside a picture's bake. texels: the texture of an image by whose
/// texels gradients are wanted; null: none.
[[nodiscard]] GradientMemory gradient_memory(const Scene& scene, const RenderOptions& options,
                                             const Texture* texels);

/// Limit of the memory of a scene and its image, and the account of what lies outside OpenGL.
class MemoryLimit {
public:
    static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

    /// The monitor is told nothing of OpenGL's objects, of which the context tells it.
    explicit MemoryLimit(std::uint64_t bytes = kNone, MemoryMonitor monitor = {})
        : bytes_(bytes), share_(std::move(monitor)) {}

    /// Throws Error(out_of_memory) with both numbers if the estimate exceeds the limit, and if the monitor
    /// refuses the estimate. Estimates again only if an input of the estimate has changed since the last
    /// call. gradients: what is needed beside the picture.
    void check(const Scene& scene, const RenderOptions& options, int width, int height,
               const GradientMemory& gradients = {});
    /// Asks the monitor for the memory of a bake that has refined the checked scene to so many vertices.
    /// Throws Error(out_of_memory) if the monitor refuses.
    void refined(std::uint64_t vertices);
    /// Takes over what a real-time render keeps outside OpenGL.
    void keep(const Statistics& statistics) noexcept {
        kept_ = statistics.response_bytes + statistics.visibility_bytes + statistics.transfer_bytes;
    }
    /// Tells the monitor that what is kept has taken the place of the estimate.
    void settle() noexcept { share_.settle(kept_); }

    /// Returns whether there is a limit or a monitor.
    [[nodiscard]] bool saves() const noexcept { return bytes_ != kNone || share_.monitored(); }

    /// Returns the number of bytes that the last checked image leaves to the scene.
    [[nodiscard]] std::uint64_t for_scene() const noexcept {
        return bytes_ == kNone ? kNone : bytes_ - image_;
    }

    /// Returns the largest number of vertices that the last checked scene may be refined to: the option's
    /// number, or, if the option leaves it open, 65536 or four times the present number, whichever is more;
    /// but no more than fit beside their bake.
    [[nodiscard]] std::uint64_t max_vertices(const RenderOptions& options) const;

private:
    std::uint64_t bytes_;
    MemoryShare share_;
    std::uint64_t kept_ = 0;
    std::uint64_t vertices_ = 0;
    MemoryEstimate estimate_;
    std::uint64_t image_ = 0;
    // Inputs beside those of the scene: the bytes of the image and of gradients.
    Stage<MemoryInputs, std::uint64_t, std::uint64_t> checking_;
};

}  // namespace nicol
