// SPDX-License-Identifier: MIT
// Records of the files that an object was read from, and of their content.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "files/load_budget.hpp"

namespace nicol {

struct FileRecord {
    std::filesystem::path path;
    std::uint64_t bytes = 0;  ///< size of the file
    std::string digest;       ///< ContentHash of the file's bytes
};

/// Returns the record of a file as it is now. Throws Error(file_not_found) if the file cannot be read.
/// `budget` is checked during reading.
[[nodiscard]] FileRecord record_of(const std::filesystem::path& file, const LoadBudget& budget = {});
/// Returns the record of bytes that were read from a file.
[[nodiscard]] FileRecord record_of(const std::filesystem::path& file, const std::string& bytes);

/// Recorder that keeps one record of each file that is read.
class FileRecorder {
public:
    explicit FileRecorder(std::vector<FileRecord> known, LoadBudget budget = {})
        : records_(std::move(known)), budget_(std::move(budget)) {
        for (const FileRecord& record : records_) recorded_.insert(record.path);
    }

    /// Calls read(), which reads `files`, and returns its result. If a file changes meanwhile, so that its
    /// record would not match the bytes that were read, the reading starts again; Error(invalid_file) is
    /// thrown after some attempts. A missing file is left to read() to report.
    template <class Read>
    auto read(std::span<const std::filesystem::path> files, Read read) {
        for (int attempt = 1;; ++attempt) {
            const State before = state_of(files);
            auto result = read();
            if (keep(files, before, attempt)) return result;
        }
    }

    [[nodiscard]] std::vector<FileRecord> take() { return std::move(records_); }

private:
    /// State of one file: the system's identity of the file, which changes with its content, and the file's
    /// record.
    struct Seen {
        std::string identity;
        FileRecord record;
    };
    using State = std::vector<Seen>;

    [[nodiscard]] State state_of(std::span<const std::filesystem::path> files) const;
    bool keep(std::span<const std::filesystem::path> files, const State& before, int attempt);

    std::vector<FileRecord> records_;
    std::set<std::filesystem::path> recorded_;  // the paths of records_
    LoadBudget budget_;
};

}  // namespace nicol
