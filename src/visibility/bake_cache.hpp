// SPDX-License-Identifier: MIT
// Disk cache of baked visibility.
#pragma once

#include <filesystem>

#include "material/response_cache.hpp"
#include "visibility/bake.hpp"
#include "visibility/refine.hpp"

namespace nicol {

/// Returns the result of bake() from `folder`, or bakes and stores it there in a file named after the
/// geometry. Nothing is stored if the geometry has an alpha mask. Creates the folder if it is missing; an
/// empty path means no cache.
///
/// A file is used only if its format version, every byte of the geometry, the directions, the checksum and
/// its exact length match the request. Otherwise the visibility is baked and the file overwritten, with a
/// notice. Files appear complete or not at all, so processes may share a folder. A folder that cannot be
/// written causes a notice, never an error. Throws what bake() throws.
[[nodiscard]] Visibility load_or_bake(const BakeGeometry& geometry, const DirectionSet& directions,
                                      const std::filesystem::path& folder, const CacheNotice& notice = {},
                                      const BakeProgress& progress = {},
                                      BakeStatistics* statistics = nullptr);

/// Returns the result of refine() from a file of its own, cached as by load_or_bake(); `visibility` must be
/// the result of load_or_bake(). Nothing is stored if no vertex is occluded.
[[nodiscard]] Refinement load_or_refine(const BakeGeometry& geometry, const DirectionSet& directions,
                                        const Visibility& visibility, const RefineOptions& options,
                                        const std::filesystem::path& folder, const CacheNotice& notice,
                                        const BakeProgress& progress, BakeStatistics& statistics);

}  // namespace nicol
