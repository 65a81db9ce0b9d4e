// SPDX-License-Identifier: MIT
// Interface of the transfer methods: data that project and bake prepare and executors compute with.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "methods/executor.hpp"
#include "methods/transfer_input.hpp"
#include "stage/statistics.hpp"
#include "stage/workers.hpp"
#include "visibility/visibility_blocks.hpp"

namespace nicol {

/// Coefficients of visibility that are needed in addition to a method's own.
struct VisibilityRequest {
    VisibilityBlocks blocks;
    std::vector<std::uint8_t> missing;  ///< 1 for each vertex that is still to be set
};

/// Method that turns incident light into reflected light. Every function computes only what changes of its
/// input require, and adds its times and counts to the statistics. The functions are called in this order,
/// each with the same input.
class TransferMethod {
public:
    virtual ~TransferMethod() = default;

    /// Projects the response of the materials.
    virtual void project(const TransferInput& input, RenderRun& run) = 0;
    /// Bakes shadows. Sets the missing blocks of `request`, which may be null, whose coefficients are
    /// computed on the way.
    virtual void bake(const TransferInput& input, VisibilityRequest* request, RenderRun& run) = 0;
    /// Relights all vertices; the executor keeps their light.
    virtual void relight(const TransferInput& input, RenderExecutor& executor, RenderRun& run) = 0;
    /// Shades the vertices with chosen[v] != 0: computes their Stokes vectors, by the executor that has relit
    /// them.
    virtual void shade(const ShadeInput& input, RenderExecutor& executor, RenderRun& run) const = 0;
    /// Shades pixels: computes their Stokes vectors, by the executor that has relit the vertices.
    virtual void shade_pixels(const PixelInput& input, RenderExecutor& executor, RenderRun& run) const = 0;

    /// Adds the memory and counts of the kept results to the statistics.
    virtual void count(const TransferInput& input, Statistics& statistics) const = 0;
};

}  // namespace nicol
