// SPDX-License-Identifier: MIT
// Answers of the past by entity tag, the least recently used going first.
#pragma once

#include <list>
#include <string>
#include <unordered_map>

#include "dispatcher.hpp"

class ResultCache {
public:
    /// Keeps at most so many bytes of contents; 0: none.
    explicit ResultCache(std::size_t limit) : limit_(limit) {}

    /// Null where it is not there.
    AnswerPtr find(const std::string& tag);
    /// An answer larger than the limit is not kept.
    void keep(const std::string& tag, const AnswerPtr& answer);
    void clear();
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

private:
    struct Entry {
        std::string tag;
        AnswerPtr answer;
    };
    std::size_t limit_;
    std::size_t bytes_ = 0;
    std::list<Entry> entries_;  ///< most recently used first
    std::unordered_map<std::string, std::list<Entry>::iterator> by_tag_;
};
