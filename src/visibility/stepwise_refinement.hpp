// SPDX-License-Identifier: MIT
// Refinement in steps, between which a caller may render.
#pragma once

#include <cstddef>
#include <memory>

#include "visibility/refine.hpp"

namespace nicol {

/// refine() in steps of some milliseconds.
class StepwiseRefinement {
public:
    /// can_refine() must be true. The geometry's arrays, the directions, the visibility and the former
    /// refinement must outlive the object and stay unchanged.
    StepwiseRefinement(const BakeGeometry& geometry, const DirectionSet& directions,
                       const Visibility& visibility, const RefineOptions& options,
                       const FormerRefinement* former);
    ~StepwiseRefinement();
    StepwiseRefinement(const StepwiseRefinement&) = delete;
    StepwiseRefinement& operator=(const StepwiseRefinement&) = delete;

    /// Runs the next step, which traces at most so many points. Returns whether steps are left.
    bool step(std::size_t points);
    /// Returns an estimate of the part that is done, 0 to 1.
    [[nodiscard]] double fraction() const;
    /// Returns the result. step() must have returned false. Adds rays and vertices to the statistics.
    [[nodiscard]] Refinement result(BakeStatistics& statistics);

private:
    class Refiner;
    std::unique_ptr<Refiner> refiner_;
};

}  // namespace nicol
