// SPDX-License-Identifier: MIT
// Hits by rasterisation.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "draw/alpha_masks.hpp"
#include "draw/hit_finder.hpp"
#include "draw/vertex_buffers.hpp"
#include "gl/program.hpp"
#include "gl/render_target.hpp"
#include "gl/vertex_array.hpp"
#include "versioned.hpp"

namespace nicol {

/// Finder that draws all triangles once per sample.
class DrawnHits final : public HitFinder {
public:
    /// The buffers and masks must outlive the object, and belong to the surfaces of each find().
    DrawnHits(std::shared_ptr<gl::Context> context, const VertexBuffers& buffers,
              const AlphaMasks& alpha_masks)
        : context_(std::move(context)), buffers_(buffers), alpha_masks_(alpha_masks) {}

    void find(const HitRequest& request, VisibilityBuffer& out) override;
    /// Frees the target of hits that are read back.
    void clear() noexcept { read_back_.reset(); }

private:
    void find_batches(const WorldGeometry& geometry);
    void bind();
    gl::RenderTarget& read_back(int width, int height);
    gl::Program& program(int textures);
    void draw(const HitRequest& request, std::size_t sample, gl::RenderTarget& target);

    std::shared_ptr<gl::Context> context_;
    const VertexBuffers& buffers_;
    const AlphaMasks& alpha_masks_;
    std::map<int, gl::Program> programs_;        // by number of textures of an opacity
    std::vector<TriangleBatch> batches_;         // triangles without alpha masks are merged
    std::optional<gl::RenderTarget> read_back_;  // one for all samples that only the host keeps
    std::optional<gl::VertexArray> vertices_;
    Stage<Version> binding_;
    Stage<Version, Version> batching_;  // buffers, alpha masks
};

}  // namespace nicol
