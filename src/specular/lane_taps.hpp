// SPDX-License-Identifier: MIT
// Filtered light at the taps of the stencil of HighOrderFactors, sixteen vertices at once.
#pragma once

#include <cstddef>
#include <span>

#include "specular/high_order_factors.hpp"
#include "specular/lane_mirror.hpp"
#include "specular/lane_reflection.hpp"
#include "specular/lobe_map.hpp"

namespace nicol {

/// The maps a material's factors are multiplied with; null where the factors do not use one. All have the
/// same channels and kind.
struct HighOrderMaps {
    const LobeMap* central = nullptr;
    const LobeMap* outer = nullptr;  ///< where factors.spread() > 0
    const LobeMap* base = nullptr;   ///< where factors.has_base()
};

/// Memory of the calling thread; one object at a time.
class LaneTaps {
public:
    /// spread: of the factors; base: whether they have one.
    LaneTaps(const HighOrderMaps& maps, double spread, bool base);

    void sample(const LaneMirror& mirror);
    /// Of a channel of the image.
    [[nodiscard]] ChannelTaps channel(std::size_t channel) const;

private:
    HighOrderMaps maps_;
    bool outer_;
    bool base_;
    float cosine_;
    float sine_;
    std::span<Lanes> at_central_, up_, down_, right_, left_, at_base_;
};

}  // namespace nicol
