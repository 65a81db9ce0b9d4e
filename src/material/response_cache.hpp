// SPDX-License-Identifier: MIT
// Response tables kept on disk between runs: magic, version, length of the key, key, the table's numbers, and
// the hash of all that.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "material/response_table.hpp"

namespace nicol {

/// Told in one line, for people, when a cache file had to be passed over or could not be written.
using CacheNotice = std::function<void(const std::string&)>;

/// The table of a material, from `folder` if it is there, else built and kept there (as a file named after
/// its content). The folder is made if it is missing; an empty path means no cache.
///
/// A file serves only if format version, content key of the material, order, kind of light, channels and
/// checksum are those asked for and its length is exact; anything else is rebuilt and overwritten, with a
/// notice. Files appear complete or not at all, so processes may share a folder. A folder that cannot be
/// written is a notice, never an error. Materials without a content key (Material::content_key()) are built
/// each time. Throws what ResponseTable's constructor throws.
[[nodiscard]] ResponseTable load_or_build(const Material& material, const LightLayout& layout, int channels,
                                          const std::filesystem::path& folder = {},
                                          const CacheNotice& notice = {});

/// A table as a file of the cache has it, with what it was made for.
struct StoredResponse {
    LightLayout layout;
    ResponseTable table;
};

/// Reads any file that load_or_build() keeps, whatever its name. Throws Error(file_not_found),
/// Error(unsupported) for another format version, and Error(invalid_file) for all that is damaged or was
/// never such a file; each names the file.
[[nodiscard]] StoredResponse read_response_table(const std::filesystem::path& file);

}  // namespace nicol
