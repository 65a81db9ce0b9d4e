// SPDX-License-Identifier: MIT
// The files that a scene names, while it is loaded.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "files/file_record.hpp"
#include "files/load_budget.hpp"
#include "import/sentences.hpp"

namespace nicol::scene {

/// Reads the files that a scene names, within a budget, and keeps a record of each file.
class SceneFiles {
public:
    SceneFiles(std::vector<FileRecord> known, const LoadBudget& budget)
        : recorder_(std::move(known), budget), budget_(budget) {}

    template <class Read>
    auto read(const std::filesystem::path& file, Read read) {
        return this->read(std::vector{file}, read);
    }
    template <class Read>
    auto read(const std::vector<std::filesystem::path>& files, Read read) {
        for (const std::filesystem::path& file : files) budget_.take_file(file);
        return recorder_.read(files, read);
    }

    /// Adds a sentence to the notices unless it is there.
    void notice(const std::string& sentence) { notices_.add(sentence); }

    [[nodiscard]] const LoadBudget& budget() const { return budget_; }
    [[nodiscard]] const std::vector<std::string>& notices() const { return notices_.all(); }
    [[nodiscard]] std::vector<FileRecord> records() { return recorder_.take(); }

private:
    FileRecorder recorder_;
    LoadBudget budget_;
    Sentences notices_;
};

}  // namespace nicol::scene
