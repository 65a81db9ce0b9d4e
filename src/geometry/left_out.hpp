// SPDX-License-Identifier: MIT
// Counts of the elements that a mesh reader ignores, reported in one notice.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nicol::geometry {

class LeftOut {
public:
    /// Adds `count` ignored elements; `what` names them in the plural, as in the notice.
    void add(std::string_view what, std::uint64_t count = 1);
    /// Returns "name: left out: 3 triangles without area, ..."; empty if nothing was ignored.
    [[nodiscard]] std::string notice(std::string_view name) const;

private:
    std::vector<std::pair<std::string, std::uint64_t>> counts_;
};

}  // namespace nicol::geometry
