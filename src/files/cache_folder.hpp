// SPDX-License-Identifier: MIT
// Size limit of folders of cache files, which several processes on several machines may share.
#pragma once

#include <cstdint>
#include <filesystem>

namespace nicol {

/// Returns the number of bytes that the files of a cache folder may have together: the environment variable
/// NICOL_CACHE_LIMIT (0: no limit), or 4 GiB if the variable is not set or empty. Throws
/// Error(invalid_argument) if the variable is no whole number.
[[nodiscard]] std::uint64_t cache_limit();

/// Makes room in its folder for the cache file `file` of `bytes` bytes, at most `limit`. Removes the cache
/// files that were written or read longest ago until all fit the limit; an older version of `file` does not
/// count. Also removes temporary cache files of AtomicFile that were last written more than an hour before
/// `now`, because their writers were killed. Other files, and files that cannot be read or removed, are
/// neither counted nor touched. `now` is by the clock of the folder's file system.
void make_room(const std::filesystem::path& file, std::uint64_t bytes, std::uint64_t limit,
               std::filesystem::file_time_type now);

/// Returns whether a file has the name of a cache file: 32 hexadecimal digits and a suffix.
[[nodiscard]] bool is_cache_file(const std::filesystem::path& file);

}  // namespace nicol
