// SPDX-License-Identifier: MIT
// Which files something was made of, and what they held.
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
    std::uint64_t bytes = 0;  ///< its size
    std::string digest;       ///< ContentHash of its bytes
};

/// Of a file as it is now. Throws Error(file_not_found) if it cannot be read.
/// `budget` is asked while it is read.
[[nodiscard]] FileRecord record_of(const std::filesystem::path& file, const LoadBudget& budget = {});
/// Of bytes that were read from a file.
[[nodiscard]] FileRecord record_of(const std::filesystem::path& file, const std::string& bytes);

/// Keeps a record of each file that it sees read, once each.
class FileRecorder {
public:
    explicit FileRecorder(std::vector<FileRecord> known, LoadBudget budget = {})
        : records_(std::move(known)), budget_(std::move(budget)) {
        for (const FileRecord& record : records_) recorded_.insert(record.path);
    }

    /// Calls read(), which reads `files`, and returns its result. If one of them changes meanwhile, so that
    /// its record would not be of what was read, this starts again; throws Error(invalid_file) if that is of
    /// no use. A file that is not there is left to read() to report.
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
    /// For each file what the system says of it, which changes when its content does, and its record.
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
