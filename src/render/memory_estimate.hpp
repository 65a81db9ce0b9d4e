// SPDX-License-Identifier: MIT
// How much memory a scene will take, before it takes it.
#pragma once

#include <cstdint>

#include "render/render.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// Bytes at most, as Statistics counts them. Of a tolerance's orders nothing is known: those of the options
/// are taken.
struct MemoryEstimate {
    std::uint64_t visibility = 0;
    std::uint64_t transfer = 0;
    std::uint64_t buffers = 0;  ///< of vertices and triangles, without what compute shaders work on

    [[nodiscard]] std::uint64_t total() const noexcept { return visibility + transfer + buffers; }
};

/// Of the real-time methods. Takes milliseconds and allocates little, whatever the scene's size.
[[nodiscard]] MemoryEstimate estimate_memory(const Scene& scene, const RenderOptions& options);

/// Of the reference method: its hierarchy of triangles and the triangles themselves.
[[nodiscard]] MemoryEstimate estimate_reference_memory(const Scene& scene);

}  // namespace nicol
