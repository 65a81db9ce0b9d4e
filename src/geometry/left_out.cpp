// SPDX-License-Identifier: MIT
#include "geometry/left_out.hpp"

#include <algorithm>

namespace nicol::geometry {

void LeftOut::add(std::string_view what, std::uint64_t count) {
    if (count == 0) return;
    const auto known = std::ranges::find(counts_, what, &std::pair<std::string, std::uint64_t>::first);
    if (known != counts_.end()) {
        known->second += count;
    } else {
        counts_.emplace_back(what, count);
    }
}

std::string LeftOut::notice(std::string_view name) const {
    std::string list;
    for (const auto& [what, count] : counts_)
        list += (list.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    return list.empty() ? list : std::string(name) + ": left out: " + list;
}

}  // namespace nicol::geometry
