// SPDX-License-Identifier: MIT
// Baked visibility kept on disk between runs.
#pragma once

#include <filesystem>

#include "material/response_cache.hpp"
#include "visibility/bake.hpp"
#include "visibility/refine.hpp"

namespace nicol {

/// bake(), or its result from `folder` if it is there; else it is kept there (as a file named after the
/// geometry), unless triangles are not whole. The folder is made if it is missing; an empty path means no
/// cache.
///
/// A file is used only if format version, every byte of the geometry, directions and checksum match the
/// request and its length is exact; anything else is baked and overwritten, with a notice. Files appear
/// complete or not at all, so processes may share a folder. A folder that cannot be written is a notice,
/// never an error. Throws what bake() throws.
[[nodiscard]] Visibility load_or_bake(const BakeGeometry& geometry, const DirectionSet& directions,
                                      const std::filesystem::path& folder, const CacheNotice& notice = {},
                                      const BakeProgress& progress = {},
                                      BakeStatistics* statistics = nullptr);

/// refine() in the same way, in a file of its own; `visibility` is load_or_bake()'s. Nothing is kept where
/// nothing is occluded.
[[nodiscard]] Refinement load_or_refine(const BakeGeometry& geometry, const DirectionSet& directions,
                                        const Visibility& visibility, const RefineOptions& options,
                                        const std::filesystem::path& folder, const CacheNotice& notice,
                                        const BakeProgress& progress, BakeStatistics& statistics);

}  // namespace nicol
