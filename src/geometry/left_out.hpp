// SPDX-License-Identifier: MIT
// What a reader passes over, for the one notice that says so.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nicol::geometry {

class LeftOut {
public:
    /// `what`: in the plural, as it appears in the notice.
    void add(std::string_view what, std::uint64_t count = 1);
    /// "name: left out: 3 triangles without area, ..."; empty where nothing was.
    [[nodiscard]] std::string notice(std::string_view name) const;

private:
    std::vector<std::pair<std::string, std::uint64_t>> counts_;
};

}  // namespace nicol::geometry
