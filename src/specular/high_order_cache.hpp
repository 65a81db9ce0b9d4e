// SPDX-License-Identifier: MIT
// Fitted factors kept on disk between runs.
#pragma once

#include <filesystem>

#include "material/response_cache.hpp"
#include "specular/high_order_factors.hpp"

namespace nicol {

/// The factors of a material for orders l_low + 1 .. l_high, from `folder` if they are there, else fitted and
/// kept there: for files, notices and materials without a content key what load_or_build() says of tables
/// holds. Throws what HighOrderFactors' constructor throws.
[[nodiscard]] HighOrderFactors load_or_fit(const Material& material, int l_low, int l_high, int channels,
                                           const std::filesystem::path& folder = {},
                                           const CacheNotice& notice = {});

}  // namespace nicol
