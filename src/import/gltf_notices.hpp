// SPDX-License-Identifier: MIT
// Notices of the parts of a glTF file that are read and not followed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "import/sentences.hpp"

namespace nicol::scene {

/// Notices of one file, one sentence for each kind of ignored part.
class GltfNotices {
public:
    explicit GltfNotices(const std::filesystem::path& file) : name_(file.string()) {}
    /// Adds a sentence unless it is there.
    void add(const std::string& sentence) { sentences_.add(name_ + ": " + sentence + "."); }
    [[nodiscard]] std::vector<std::string> take() { return sentences_.take(); }

private:
    std::string name_;
    Sentences sentences_;
};

}  // namespace nicol::scene
