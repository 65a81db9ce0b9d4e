// SPDX-License-Identifier: MIT
// Cache of answers by entity tag, which evicts the least recently used ones.
#pragma once

#include <list>
#include <string>
#include <unordered_map>

#include "dispatcher.hpp"

class ResultCache {
public:
    /// Makes a cache of at most `limit` bytes of contents; 0: none.
    explicit ResultCache(std::size_t limit) : limit_(limit) {}

    /// Returns an answer, or null if there is none.
    AnswerPtr find(const std::string& tag);
    /// Keeps an answer unless it is larger than the limit.
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
    std::list<Entry> entries_;  ///< most recently used ones first
    std::unordered_map<std::string, std::list<Entry>::iterator> by_tag_;
};
