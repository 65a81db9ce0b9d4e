// SPDX-License-Identifier: MIT
// Filtered light at the taps of the stencil of HighOrderFactors, for sixteen vertices at once.
#pragma once

#include <cstddef>
#include <span>

#include "specular/high_order_factors.hpp"
#include "specular/lane_mirror.hpp"
#include "specular/lane_reflection.hpp"
#include "specular/lobe_map.hpp"

namespace nicol {

/// Maps that a material's factors multiply; null if the factors do not use a map. All maps have equal
/// channels and kind.
struct HighOrderMaps {
    const LobeMap* central = nullptr;
    const LobeMap* outer = nullptr;  ///< null unless factors.spread() > 0
    const LobeMap* base = nullptr;   ///< null unless factors.has_base()
};

/// Light at the taps, in memory of the calling thread; only one object per thread may exist at a time.
class LaneTaps {
public:
    /// Takes the spread of the factors; base: whether the factors have a base tap.
    LaneTaps(const HighOrderMaps& maps, double spread, bool base);

    void sample(const LaneMirror& mirror);
    /// Returns the taps of a channel of the image.
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
