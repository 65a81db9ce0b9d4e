// SPDX-License-Identifier: MIT
// Numbers of the command line.
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "common/failure.hpp"

/// Returns the numbers of a text with commas in between. Throws Failure that names the option and what is no
/// number.
inline std::vector<double> parse_list(std::string_view option, std::string_view text) {
    std::vector<double> values;
    for (std::string_view rest = text;;) {
        const std::string_view item = rest.substr(0, rest.find(','));
        double value = 0;
        const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
        if (error != std::errc() || end != item.data() + item.size() || !std::isfinite(value))
            throw Failure(std::string(option) + ": '" + std::string(item) + "' is not a number");
        values.push_back(value);
        if (item.size() == rest.size()) return values;
        rest.remove_prefix(item.size() + 1);
    }
}
