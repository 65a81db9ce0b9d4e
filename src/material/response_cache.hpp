// SPDX-License-Identifier: MIT
// Response tables on disk. A file holds magic, version, length of the key, key, table, and a hash of
// everything before the hash.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "material/response_table.hpp"

namespace nicol {

/// Callback that receives one line of text if a cache file could not be used or written.
using CacheNotice = std::function<void(const std::string&)>;

/// Returns the table of a material: read from `folder` if its file is there, else built and saved there. A
/// missing folder is created; an empty path means no cache.
///
/// A file is used only if format version, content key of the material, order, kind of light, channels,
/// pairings, length and checksum are right. Otherwise the table is rebuilt and the file replaced, with a
/// notice. `known` is that of ResponseTable's constructor. Files are written atomically, so processes may
/// share a folder. A failure to write gives a notice, not an error. Materials without a content key
/// (Material::content_key()) are not cached. Throws what ResponseTable's constructor throws.
[[nodiscard]] ResponseTable load_or_build(const Material& material, const LightLayout& layout, int channels,
                                          const std::filesystem::path& folder = {},
                                          const CacheNotice& notice = {},
                                          ResponseTable::KnownRows* known = nullptr);

/// Builds the table and saves it in `folder`, unless it is there already. Throws Error(write_failed), and
/// what load_or_build() throws. The material must have a content key.
void store_response_table(const Material& material, const LightLayout& layout, int channels,
                          const std::filesystem::path& folder);

/// Table of a cache file, with its parameters.
struct StoredResponse {
    LightLayout layout;
    ResponseTable table;
};

/// Reads a file that load_or_build() wrote. Throws Error(file_not_found), Error(unsupported) for another
/// format version, and Error(invalid_file) for a file that is damaged or of another kind; each names the
/// file.
[[nodiscard]] StoredResponse read_response_table(const std::filesystem::path& file);

}  // namespace nicol
