// SPDX-License-Identifier: MIT
#include "result_cache.hpp"

AnswerPtr ResultCache::find(const std::string& tag) {
    const auto found = by_tag_.find(tag);
    if (found == by_tag_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found->second);
    return found->second->answer;
}

void ResultCache::keep(const std::string& tag, const AnswerPtr& answer) {
    const std::size_t size = answer->content.size();
    if (size > limit_ || by_tag_.contains(tag)) return;
    entries_.push_front({.tag = tag, .answer = answer});
    by_tag_.emplace(tag, entries_.begin());
    bytes_ += size;
    while (bytes_ > limit_) {
        bytes_ -= entries_.back().answer->content.size();
        by_tag_.erase(entries_.back().tag);
        entries_.pop_back();
    }
}

void ResultCache::clear() {
    entries_.clear();
    by_tag_.clear();
    bytes_ = 0;
}
