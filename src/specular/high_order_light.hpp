// SPDX-License-Identifier: MIT
// Filtered maps of one light, shared by all materials.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "harmonics/convolution.hpp"
#include "specular/high_order.hpp"
#include "specular/high_order_factors.hpp"
#include "specular/lobe_map.hpp"

namespace nicol {

/// Orders l_low + 1 .. l_high of a light, filtered once by each lobe that a material uses.
class HighOrderLight {
public:
    /// Takes `light`, coefficients in the light's own axes; orders above its own count as zero. Throws
    /// Error(invalid_argument) for orders out of 0 <= l_low < l_high <= kMaxOrder.
    HighOrderLight(PshVector light, int l_low, int l_high, bool polarized);

    /// Returns the maps that HighOrder and shaders need for a material. The maps live as long as this object.
    [[nodiscard]] HighOrderMaps maps(const HighOrderFactors& factors);

    [[nodiscard]] std::size_t bytes() const noexcept;

private:
    const LobeMap* lobe(std::size_t index);

    PshVector light_;
    int l_low_;
    int l_high_;
    bool polarized_;
    std::array<std::unique_ptr<LobeMap>, kLobeWidths.size() + 1> lobes_;  // by lobe; last: cosine_gains()
};

/// Returns orders l_low + 1 .. l_high of a light convolved with a material's kernels, as published; the map
/// is the central map of HighOrderFactors::mirror(). `kernels`: mirrored_kernels(), one for all channels or
/// one for each. The map has the kernels' channels if the light has one channel. It is always polarized.
/// Throws Error(invalid_argument) if channels do not fit or a kernel is shorter than l_high.
[[nodiscard]] LobeMap convolved_map(const PshVector& light, std::span<const ConvolutionKernel> kernels,
                                    int l_low, int l_high, double tolerance = LobeMap::kTolerance);

}  // namespace nicol
