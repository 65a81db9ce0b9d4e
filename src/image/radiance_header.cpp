// SPDX-License-Identifier: MIT
#include "image/radiance_header.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "files/file_error.hpp"

namespace nicol {
namespace {

/// The next number of a line above 0, 0 if there is none.
double take_factor(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value) || !(value > 0)) return 0;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return text.empty() || text.front() == ' ' || text.front() == '\t' || text.front() == '\r' ? value : 0;
}

}  // namespace

std::array<double, 3> radiance_factors(const std::filesystem::path& file, std::string_view bytes) {
    std::array<double, 3> factors{1, 1, 1};
    for (int number = 1; !bytes.empty(); ++number) {
        std::string_view line = bytes.substr(0, bytes.find('\n'));
        bytes.remove_prefix(std::min(line.size() + 1, bytes.size()));
        if (line.empty() || line == "\r") break;
        const auto starts_with = [&line](std::string_view key) {
            const bool found = line.starts_with(key);
            if (found) line.remove_prefix(key.size());
            return found;
        };
        const bool exposure = starts_with("EXPOSURE=");
        if (!exposure && !starts_with("COLORCORR=")) continue;
        const double first = take_factor(line);
        const std::array<double, 3> found = exposure
                                                ? std::array{first, first, first}
                                                : std::array{first, take_factor(line), take_factor(line)};
        for (std::size_t c = 0; c < 3; ++c) {
            factors[c] *= found[c];
            if (!(factors[c] > 0) || !std::isfinite(factors[c]))
                invalid_file(file,
                             "line " + std::to_string(number) + ": " +
                                 (exposure ? "EXPOSURE is not a number" : "COLORCORR is not three numbers") +
                                 " above 0 that floats can be divided by");
        }
    }
    return factors;
}

}  // namespace nicol
