// SPDX-License-Identifier: MIT
#include "specular/known_moments.hpp"

#include <cstddef>

namespace nicol {

std::vector<std::vector<TapRows>> KnownMoments::at(const Material& material, double theta_out,
                                                   std::span<const Tap> taps,
                                                   std::span<const ZonalKernel> kernels,
                                                   std::size_t columns) {
    const auto place = [=](const Tap& tap) {
        return Place{theta_out, tap.lobe, tap.frame[2].x, tap.frame[2].y};
    };
    std::vector<std::vector<TapRows>> out(taps.size());
    std::vector<Tap> missing;
    std::vector<std::size_t> indices;
    {
        const std::scoped_lock lock(mutex_);
        for (std::size_t i = 0; i < taps.size(); ++i) {
            const auto known = known_.find(place(taps[i]));
            if (known != known_.end()) {
                out[i] = known->second;
                continue;
            }
            missing.push_back(taps[i]);
            indices.push_back(i);
        }
    }
    if (missing.empty()) return out;
    std::vector<std::vector<TapRows>> moments = tap_moments(material, theta_out, missing, kernels, columns);
    const std::scoped_lock lock(mutex_);
    for (std::size_t k = 0; k < missing.size(); ++k) {
        known_.try_emplace(place(missing[k]), moments[k]);
        out[indices[k]] = std::move(moments[k]);
    }
    return out;
}

}  // namespace nicol
