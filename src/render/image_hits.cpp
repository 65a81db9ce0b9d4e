// SPDX-License-Identifier: MIT
#include "render/image_hits.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>

#include "stage/statistics.hpp"

namespace nicol {

void find_shown(const WorldGeometry& geometry, const VisibilityBuffer& hits,
                std::vector<std::uint8_t>& shown) {
    using Range = tbb::blocked_range<std::size_t>;
    constexpr std::size_t grain = 16384;
    shown.assign(geometry.positions.size(), 0);
    const std::size_t pixels =
        static_cast<std::size_t>(hits.width()) * static_cast<std::size_t>(hits.height());
    for (std::size_t sample = 0; sample < hits.offsets().size(); ++sample) {
        tbb::parallel_for(Range(0, pixels, grain), [&](const Range& range) {
            std::optional<std::uint32_t> before;
            for (std::size_t pixel = range.begin(); pixel < range.end(); ++pixel) {
                const std::optional<Hit> hit = hits.at(sample, pixel);
                if (!hit || hit->triangle == before) continue;
                before = hit->triangle;
                // Other threads may meet triangles with the same corners.
                const glm::uvec3& corners = geometry.triangles[hit->triangle];
                for (glm::length_t k = 0; k < 3; ++k)
                    std::atomic_ref(shown[corners[k]]).store(1, std::memory_order_relaxed);
            }
        });
    }
}

const VisibilityBuffer& ImageHits::get() {
    if (hits_ == nullptr) {
        const Stopwatch drawing;
        hits_ = &draw_(on_host_);
        run_.statistics.draw_ms += drawing.milliseconds();
    }
    return *hits_;
}

std::span<const std::uint8_t> ImageHits::shown(const WorldGeometry& geometry) {
    if (!std::exchange(found_, true)) {
        const VisibilityBuffer& hits = get();
        run_.workers.run([&] { find_shown(geometry, hits, shown_); });
    }
    return shown_;
}

}  // namespace nicol
