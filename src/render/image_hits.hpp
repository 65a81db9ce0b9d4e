// SPDX-License-Identifier: MIT
// Hits of one image, and the vertices that it shows.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "draw/visibility_buffer.hpp"
#include "stage/workers.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Function that draws the triangles of the surfaces at the pixels of an image. on_host: whether the host
/// needs the hits as well, whatever the executor.
using DrawHits = std::function<const VisibilityBuffer&(bool on_host)>;

/// Sets shown[v] to 1 for each corner of a triangle that is hit at any sample of `hits`, which are kept on
/// the host, else to 0. Runs on the calling thread's TBB arena.
void find_shown(const WorldGeometry& geometry, const VisibilityBuffer& hits,
                std::vector<std::uint8_t>& shown);

/// Hits of one image, drawn when they are first asked for.
class ImageHits {
public:
    /// Keeps references to its arguments. shown: memory for the flags of shown().
    ImageHits(const DrawHits& draw, std::vector<std::uint8_t>& shown, RenderRun& run)
        : draw_(draw), shown_(shown), run_(run) {}

    /// Has the hits kept on the host as well, whatever the executor. They must not be drawn yet, unless the
    /// executor reads them there.
    void keep_on_host() noexcept { on_host_ = true; }

    /// Returns the hits. Their time counts as drawing.
    const VisibilityBuffer& get();
    /// Returns the flags of find_shown().
    std::span<const std::uint8_t> shown(const WorldGeometry& geometry);

private:
    const DrawHits& draw_;
    std::vector<std::uint8_t>& shown_;
    RenderRun& run_;
    const VisibilityBuffer* hits_ = nullptr;
    bool on_host_ = false;
    bool found_ = false;
};

}  // namespace nicol
