// SPDX-License-Identifier: MIT
// Choice of the terms of materials that reflect samples of the environment.
#pragma once

#include "material/sampled_terms.hpp"
#include "scene/scene.hpp"
#include "stage/options.hpp"

namespace nicol {

/// Returns the terms that do not reflect harmonics. follows_rays: whether rays are followed from pixels that
/// show smooth surfaces. hidden: whether surfaces hide light from each other.
[[nodiscard]] SampledTerms sampled_terms(const Scene& scene, const RenderOptions& options, bool follows_rays,
                                         bool hidden);

}  // namespace nicol
