// SPDX-License-Identifier: MIT
#include "byte_range.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace {

/// Returns a number of digits alone; nothing for other text and for numbers that are too large.
std::optional<std::size_t> number(std::string_view text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace

WantedBytes wanted_bytes(std::string_view range, std::string_view if_range, std::string_view tag,
                         std::size_t size) {
    constexpr std::string_view unit = "bytes=";
    if (!range.starts_with(unit) || !(if_range.empty() || if_range == tag)) return Everything{};
    range.remove_prefix(unit.size());
    const std::size_t dash = range.find('-');
    if (dash == std::string_view::npos) return Everything{};
    const std::optional<std::size_t> last = number(range.substr(dash + 1));
    if (dash == 0) {  // the last bytes
        if (!last) return Everything{};
        if (*last == 0 || size == 0) return NothingThere{};
        const std::size_t count = std::min(*last, size);
        return ByteRange{.first = size - count, .count = count};
    }
    const std::optional<std::size_t> first = number(range.substr(0, dash));
    const bool endless = dash + 1 == range.size();
    if (!first || !(last || endless) || (last && *last < *first)) return Everything{};
    if (*first >= size) return NothingThere{};
    return ByteRange{.first = *first,
                     .count = endless ? size - *first : std::min(*last, size - 1) - *first + 1};
}

std::string content_range(const ByteRange& range, std::size_t size) {
    return "bytes " + std::to_string(range.first) + "-" + std::to_string(range.first + range.count - 1) +
           "/" + std::to_string(size);
}
