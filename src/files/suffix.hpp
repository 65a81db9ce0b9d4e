// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace nicol {

/// Returns the text with its ASCII letters in lower case.
[[nodiscard]] inline std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Returns the suffix of a file's name in lower case: ".obj" for "Cube.OBJ".
[[nodiscard]] inline std::string suffix_of(const std::filesystem::path& file) {
    return lower_case(file.extension().string());
}

}  // namespace nicol
