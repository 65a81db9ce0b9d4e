// SPDX-License-Identifier: MIT
// Keeping a folder of cache files small. Several processes may use it, on several machines.
#pragma once

#include <cstdint>
#include <filesystem>

namespace nicol {

/// Bytes that the files of a cache folder may have together: the environment variable NICOL_CACHE_LIMIT, 0:
/// any; 4 GiB where it is not set or empty. Throws Error(invalid_argument) if it is no whole number.
[[nodiscard]] std::uint64_t cache_limit();

/// Makes room for a cache file of `bytes` bytes, at most `limit`, in its folder: removes those that were
/// written or read longest ago until all fit the limit, where an older `file` does not count. Removes
/// temporary files, too, that no one has written to for an hour before `now`, which writers that were killed
/// left: those of AtomicFile, of cache files. Other files are neither counted nor touched, and neither is
/// what cannot be read or removed. `now` is by the clock of the folder's file system.
void make_room(const std::filesystem::path& file, std::uint64_t bytes, std::uint64_t limit,
               std::filesystem::file_time_type now);

/// Whether a file has the name of a cache file: 32 hexadecimal digits and a suffix.
[[nodiscard]] bool is_cache_file(const std::filesystem::path& file);

}  // namespace nicol
