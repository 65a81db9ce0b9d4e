// SPDX-License-Identifier: MIT
// What of a glTF file is read and not followed.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace nicol::scene {

/// A sentence for each kind.
class GltfNotices {
public:
    explicit GltfNotices(const std::filesystem::path& file) : name_(file.string()) {}
    /// Keeps a sentence, once.
    void add(const std::string& sentence);
    [[nodiscard]] std::vector<std::string> take() { return std::move(sentences_); }

private:
    std::string name_;
    std::vector<std::string> sentences_;
};

}  // namespace nicol::scene
