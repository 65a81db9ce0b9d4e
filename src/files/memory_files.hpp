// SPDX-License-Identifier: MIT
// Files in a caller's memory.
#pragma once

#include <functional>
#include <map>
#include <string_view>

#include "files/file_source.hpp"

namespace nicol {

/// One file in memory, and the files that it names, which the caller resolves. Nothing is read from the file
/// system. For use by one load, on the loading thread.
class MemoryFiles final : public FileSource {
public:
    /// Returns the content of a file, or nothing if the caller has no such file. The bytes must outlive the
    /// MemoryFiles.
    using Resolve = std::function<std::optional<std::string_view>(const std::string& name)>;

    /// `resolve` may be empty. It is called at most once per name. Names are as the files write them, joined
    /// to the folder of the naming file, without "." and "name/..".
    MemoryFiles(const std::filesystem::path& name, std::string_view bytes, Resolve resolve);

    [[nodiscard]] std::optional<Found> find(const std::filesystem::path& file) const override;
    /// Returns true, because only the caller knows its folders.
    [[nodiscard]] bool has_folder(const std::filesystem::path& folder) const override;
    [[nodiscard]] std::unique_ptr<std::istream> open(const std::filesystem::path& file) const override;

private:
    [[nodiscard]] std::optional<std::string_view> content(const std::filesystem::path& file) const;

    Resolve resolve_;
    mutable std::map<std::string, std::optional<std::string_view>> known_;
};

}  // namespace nicol
