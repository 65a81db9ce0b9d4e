// SPDX-License-Identifier: MIT
#include "specular/high_order_light.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "error.hpp"
#include "harmonics/order_gains.hpp"

namespace nicol {

HighOrderLight::HighOrderLight(PshVector light, int l_low, int l_high, bool polarized)
    : light_(std::move(light)), l_low_(l_low), l_high_(l_high), polarized_(polarized) {
    if (l_low < 0 || l_high <= l_low || l_high > kMaxOrder) {
        throw Error(ErrorCode::invalid_argument,
                    "high orders from " + std::to_string(l_low) + " to " + std::to_string(l_high) +
                        "; they must ascend within 0 to " + std::to_string(kMaxOrder));
    }
}

HighOrderMaps HighOrderLight::maps(const HighOrderFactors& factors) {
    HighOrderMaps maps;
    maps.central = lobe(static_cast<std::size_t>(factors.central_lobe()));
    if (factors.spread() > 0) maps.outer = lobe(static_cast<std::size_t>(factors.outer_lobe()));
    if (factors.has_base()) maps.base = lobe(kLobeWidths.size());
    return maps;
}

const LobeMap* HighOrderLight::lobe(std::size_t index) {
    std::unique_ptr<LobeMap>& map = lobes_[index];
    if (!map) {
        const OrderGains gains = index < kLobeWidths.size()
                                     ? gaussian_gains(kLobeWidths[index], l_low_ + 1, l_high_)
                                     : cosine_gains(l_low_ + 1, l_high_);
        map = std::make_unique<LobeMap>(light_, gains, polarized_);
    }
    return map.get();
}

std::size_t HighOrderLight::bytes() const noexcept {
    std::size_t sum = 0;
    for (const auto& map : lobes_) sum += map ? map->bytes() : 0;
    return sum;
}

LobeMap convolved_map(const PshVector& light, std::span<const ConvolutionKernel> kernels, int l_low,
                      int l_high, double tolerance) {
    const int given = static_cast<int>(kernels.size());
    if (given != 1 && light.channels() != 1 && given != light.channels()) {
        throw Error(ErrorCode::invalid_argument, std::to_string(given) + " kernels cannot serve light of " +
                                                     std::to_string(light.channels()) +
                                                     " channels; there must be one or as many");
    }
    const int order = std::min(light.order(), l_high);
    const std::size_t size = 4 * psh_count(order);
    PshVector out(order, std::max(given, light.channels()));
    for (int c = 0; c < out.channels(); ++c) {
        const ConvolutionKernel& kernel = kernels[static_cast<std::size_t>(given == 1 ? 0 : c)];
        convolve(kernel, light.channel(light.channels() == 1 ? 0 : c).first(size), out.channel(c));
    }
    return {out, gaussian_gains(0, l_low + 1, l_high), true, tolerance};
}

}  // namespace nicol
