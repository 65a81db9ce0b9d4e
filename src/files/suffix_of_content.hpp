// SPDX-License-Identifier: MIT
// Formats of files without a name.
#pragma once

#include <string_view>

namespace nicol {

/// Returns the suffix, such as ".glb", that a file with this content has. Text that begins as no other format
/// is ".obj"; other content is "".
[[nodiscard]] std::string_view suffix_of_content(std::string_view bytes);

}  // namespace nicol
