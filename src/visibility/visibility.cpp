// SPDX-License-Identifier: MIT
#include "visibility/visibility.hpp"

#include <algorithm>

namespace nicol {

std::size_t Visibility::unoccluded_count() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(unoccluded_, [](std::uint8_t open) { return open != 0; }));
}

Visibility Visibility::selected(std::span<const std::uint32_t> vertices) const {
    Visibility out(directions_, vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        std::ranges::copy(at(vertices[i]), out.at(i).begin());
        out.set_unoccluded(i, unoccluded(vertices[i]));
    }
    return out;
}

}  // namespace nicol
