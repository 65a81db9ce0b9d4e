// SPDX-License-Identifier: MIT
// The files that a scene names, while it is loaded.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "files/file_record.hpp"
#include "files/load_budget.hpp"

namespace nicol::scene {

/// Reads what a scene names, within a budget, and keeps a record of each file.
class SceneFiles {
public:
    SceneFiles(std::vector<FileRecord> known, const LoadLimits& limits)
        : recorder_(std::move(known)), budget_(limits) {}

    template <class Read>
    auto read(const std::filesystem::path& file, Read read) {
        return this->read(std::vector{file}, read);
    }
    template <class Read>
    auto read(const std::vector<std::filesystem::path>& files, Read read) {
        for (const std::filesystem::path& file : files) budget_.take_file(file);
        return recorder_.read(files, read);
    }

    /// Keeps a sentence, once.
    void notice(const std::string& sentence) {
        if (std::ranges::find(notices_, sentence) == notices_.end()) notices_.push_back(sentence);
    }

    [[nodiscard]] LoadBudget& budget() { return budget_; }
    [[nodiscard]] const std::vector<std::string>& notices() const { return notices_; }
    [[nodiscard]] std::vector<FileRecord> records() { return recorder_.take(); }

private:
    FileRecorder recorder_;
    LoadBudget budget_;
    std::vector<std::string> notices_;
};

}  // namespace nicol::scene
