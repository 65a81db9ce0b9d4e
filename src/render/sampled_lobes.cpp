// SPDX-License-Identifier: MIT
#include "render/sampled_lobes.hpp"

#include "material/followed_terms.hpp"
#include "render/wanted_executor.hpp"

namespace nicol {

SampledTerms sampled_terms(const Scene& scene, const RenderOptions& options, bool follows_rays, bool hidden) {
    const EnvironmentPtr& environment = scene.distant_light();
    if (environment == nullptr) return follows_rays ? SampledTerms::smooth : SampledTerms::none;
    if (options.bsdf_samples == 0 || options.method != Method::factored ||
        options.high_orders == HighOrders::convolution)
        return SampledTerms::none;
    // Light without pixels has no detail that narrow lobes would miss, but what hides this light has.
    if (!hidden && environment->pixels().values == nullptr) return SampledTerms::anisotropic;
    // Rays that follow lobes show what glass sends to these. Harmonics would show the light straight behind
    // the glass as well.
    const bool see_glass = hidden && follows_rays && wants_lobes(options) && scene.transmits();
    return {SampledTerms::anisotropic_narrow, see_glass ? kWidestFollowedLobe : kNarrowestLobe};
}

}  // namespace nicol
