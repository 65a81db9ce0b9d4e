// SPDX-License-Identifier: MIT
// What is not followed.
#include <algorithm>

#include "scene/readers.hpp"
#include "scene/text.hpp"

namespace nicol::scene {

void Notices::add_unfollowed(pugi::xml_node node, const std::string& what) {
    if (unfollowed_.empty()) first_place_ = document_.where(node);
    unfollowed_.push_back(what);
}

void Notices::add(pugi::xml_node node, const std::string& sentence) {
    const std::string placed = document_.where(node) + ": " + sentence + ".";
    // What several elements refer to is read for each.
    if (std::ranges::find(sentences_, placed) == sentences_.end()) sentences_.push_back(placed);
}

void Notices::add_once(pugi::xml_node node, const std::string& sentence) {
    const auto says = [ending = ": " + sentence + "."](const std::string& placed) {
        return placed.ends_with(ending);
    };
    if (std::ranges::none_of(sentences_, says)) add(node, sentence);
}

std::vector<std::string> Notices::take() {
    std::vector<std::string> all;
    if (!unfollowed_.empty()) all.push_back(first_place_ + ": not followed: " + joined(unfollowed_) + ".");
    all.insert(all.end(), sentences_.begin(), sentences_.end());
    return all;
}

}  // namespace nicol::scene
