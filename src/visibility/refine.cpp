// SPDX-License-Identifier: MIT
#include "visibility/refine.hpp"

#include "progress.hpp"
#include "visibility/stepwise_refinement.hpp"

namespace nicol {
namespace {

// Points between two calls of the progress callback.
constexpr std::size_t kPointsAtATime = 4096;

}  // namespace

bool can_refine(const Visibility& visibility, const RefineOptions& options) {
    return visibility.unoccluded_count() < visibility.vertices() &&
           visibility.vertices() < options.max_vertices;
}

Refinement refine(const BakeGeometry& geometry, const DirectionSet& directions, const Visibility& visibility,
                  const RefineOptions& options, const BakeProgress& progress, BakeStatistics& statistics,
                  const FormerRefinement* former) {
    if (!can_refine(visibility, options)) return {};
    const Stopwatch watch;
    StepwiseRefinement refinement(geometry, directions, visibility, options, former);
    while (refinement.step(kPointsAtATime))
        if (progress) progress(refinement.fraction());
    Refinement out = refinement.result(statistics);
    statistics.milliseconds += watch.milliseconds();
    return out;
}

}  // namespace nicol
