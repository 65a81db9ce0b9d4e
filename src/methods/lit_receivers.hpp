// SPDX-License-Identifier: MIT
// Direct light of local lights at receivers of bounced light.
#pragma once

#include <vector>

#include "methods/linked_surfaces.hpp"
#include "methods/transfer_input.hpp"
#include "stage/workers.hpp"

namespace nicol {

/// Returns, for each receiver and channel, [receiver][channel], the first number of even light that
/// irradiates the receiver as much as the local lights do. input.local_lights must not be null.
[[nodiscard]] std::vector<float> local_light_at_receivers(const TransferInput& input,
                                                          const LinkedSurfaces& surfaces, RenderRun& run);

}  // namespace nicol
