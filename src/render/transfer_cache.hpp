// SPDX-License-Identifier: MIT
// project, relight and shade for one scene, computing again only what changes make necessary.
#pragma once

#include <tbb/task_arena.h>

#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "nicol/light_layout.hpp"
#include "nicol/render.hpp"
#include "nicol/response_table.hpp"
#include "nicol/scene.hpp"
#include "render/geometry.hpp"
#include "render/progress.hpp"
#include "transfer/shade.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

class TransferCache {
public:
    /// threads = 0: one a core.
    explicit TransferCache(int threads);

    /// Shades every vertex that can be seen; the result is in stokes(). Adds its times and counts to
    /// `statistics`.
    void update(const Scene& scene, const Projection& projection, int order, Progress& progress,
                Statistics& statistics);

    [[nodiscard]] const WorldGeometry& geometry() const noexcept { return geometry_; }
    /// Counts the times geometry() changed.
    [[nodiscard]] std::uint64_t geometry_revision() const noexcept { return geometry_revision_; }
    /// One Stokes vector a vertex for each channel of the scene.
    [[nodiscard]] const std::vector<std::vector<glm::vec4>>& stokes() const noexcept { return stokes_; }

private:
    void project_light(const Scene& scene, int order, Statistics& statistics);
    void project_materials(const Scene& scene, Progress& progress, Statistics& statistics);
    void relight(const Scene& scene, Progress& progress, Statistics& statistics);
    void shade(const Projection& projection, Progress& progress, Statistics& statistics);
    void count(Statistics& statistics) const;

    tbb::task_arena arena_;

    WorldGeometry geometry_;
    std::uint64_t geometry_revision_ = 0;

    EnvironmentPtr environment_;  // that light_ was projected from
    PshVector light_;             // in the environment's axes, unscaled; one channel where all are equal
    std::unique_ptr<LightLayout> layout_;
    std::unique_ptr<Shade> shade_;

    std::map<MaterialPtr, ResponseTable> tables_;
    int table_channels_ = 0;

    VertexLight vertex_light_;
    std::uint64_t lit_geometry_ = 0;  // revisions that vertex_light_ belongs to
    std::uint64_t lit_light_ = 0;

    std::vector<std::uint8_t> visible_;
    std::vector<std::vector<glm::vec4>> stokes_;
};

}  // namespace nicol
