// SPDX-License-Identifier: MIT
#include "visibility/visibility.hpp"

#include <algorithm>

namespace nicol {

std::size_t Visibility::unoccluded_count() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(unoccluded_, [](std::uint8_t open) { return open != 0; }));
}

}  // namespace nicol
