// SPDX-License-Identifier: MIT
// The place that the files of one load come from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <string>

namespace nicol {

/// Source of files: the file system, or a caller's memory. Readers open every input file through a source, so
/// that none of them knows which kind it reads from.
class FileSource {
public:
    struct Found {
        std::uint64_t bytes = 0;  ///< size of the file
        std::string identity;     ///< differs between files, and changes when the file's content changes
    };

    virtual ~FileSource() = default;

    /// Looks up a file. Returns nothing if there is none, and for devices and pipes, which may never end.
    [[nodiscard]] virtual std::optional<Found> find(const std::filesystem::path& file) const = 0;
    /// Returns whether files may lie in the folder.
    [[nodiscard]] virtual bool has_folder(const std::filesystem::path& folder) const = 0;
    /// Opens a file at its beginning. Returns null if find() returns nothing or the file cannot be read.
    [[nodiscard]] virtual std::unique_ptr<std::istream> open(const std::filesystem::path& file) const = 0;
};

[[nodiscard]] const FileSource& file_system();

}  // namespace nicol
