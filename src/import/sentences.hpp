// SPDX-License-Identifier: MIT
// Sentences for users, each once.
#pragma once

#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace nicol::scene {

/// Sentences in the order in which they were added.
class Sentences {
public:
    /// Adds a sentence unless it is there.
    void add(const std::string& sentence) {
        if (known_.insert(sentence).second) sentences_.push_back(sentence);
    }

    [[nodiscard]] const std::vector<std::string>& all() const noexcept { return sentences_; }
    [[nodiscard]] std::vector<std::string> take() { return std::move(sentences_); }

private:
    std::unordered_set<std::string> known_;
    std::vector<std::string> sentences_;
};

}  // namespace nicol::scene
