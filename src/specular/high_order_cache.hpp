// SPDX-License-Identifier: MIT
// Disk cache of fitted factors.
#pragma once

#include <filesystem>

#include "material/response_cache.hpp"
#include "specular/high_order_factors.hpp"
#include "specular/split_fit.hpp"

namespace nicol {

/// Returns the factors of a material for the orders of a basis, from `folder` or, if they are not there,
/// fitted and stored there. Files, notices and materials without a content key are treated as by
/// load_or_build() for tables. Throws what HighOrderFactors' constructor throws.
[[nodiscard]] HighOrderFactors load_or_fit(const Material& material, const SplitBasis& basis, int channels,
                                           KnownMoments* known = nullptr,
                                           const std::filesystem::path& folder = {},
                                           const CacheNotice& notice = {});

}  // namespace nicol
