// SPDX-License-Identifier: MIT
// How incident light becomes reflected light: the data that project and bake prepare and executors compute
// with.
#pragma once

#include <cstdint>
#include <span>

#include "methods/executor.hpp"
#include "methods/transfer_input.hpp"
#include "stage/statistics.hpp"
#include "stage/workers.hpp"
#include "visibility/visibility_blocks.hpp"

namespace nicol {

/// Coefficients of visibility that are needed beside what a method needs.
struct VisibilityRequest {
    VisibilityBlocks blocks;
    bool filled = false;
};

/// Every function computes as far as changes of its input make it necessary, and adds its times and counts to
/// the statistics. They are called in this order, each with the same input.
class TransferMethod {
public:
    virtual ~TransferMethod() = default;

    /// project: the response of the materials.
    virtual void project(const TransferInput& input, RenderRun& run) = 0;
    /// bake: shadows. Fills `request`, which may be null, where it computes all of its vertices.
    virtual void bake(const TransferInput& input, VisibilityRequest* request, RenderRun& run) = 0;
    /// relight: the light of all vertices, kept by the executor.
    virtual void relight(const TransferInput& input, RenderExecutor& executor, RenderRun& run) = 0;
    /// shade: the Stokes vectors of the vertices with chosen[v] != 0, by the executor that has relit them.
    virtual void shade(const ShadeInput& input, RenderExecutor& executor, RenderRun& run) const = 0;
    /// Likewise of pixels.
    virtual void shade_pixels(const PixelInput& input, RenderExecutor& executor, RenderRun& run) const = 0;

    /// Adds what it keeps to the statistics.
    virtual void count(const TransferInput& input, Statistics& statistics) const = 0;
};

}  // namespace nicol
