// SPDX-License-Identifier: MIT
// Numbers as text.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace nicol {

/// Returns the shortest text from which a number is read back exactly.
[[nodiscard]] inline std::string shortest_text(double number) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

}  // namespace nicol
