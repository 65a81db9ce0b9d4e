// SPDX-License-Identifier: MIT
#include "visibility/visibility.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace nicol {

std::size_t Visibility::unoccluded_count() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(unoccluded_, [](std::uint8_t open) { return open != 0; }));
}

Visibility Visibility::selected(std::span<const std::uint32_t> vertices) const {
    Visibility out(directions_, vertices.size());
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, vertices.size(), 1024), [&](const Range& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            std::ranges::copy(at(vertices[i]), out.at(i).begin());
            out.set_unoccluded(i, unoccluded(vertices[i]));
        }
    });
    return out;
}

}  // namespace nicol
