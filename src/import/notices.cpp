// SPDX-License-Identifier: MIT
// Reports the elements of a scene file that the reader ignores.
#include "import/readers.hpp"
#include "import/text.hpp"

namespace nicol::scene {

void Notices::add_unfollowed(pugi::xml_node node, const std::string& what) {
    if (unfollowed_.empty()) first_place_ = document_.where(node);
    unfollowed_.push_back(what);
}

void Notices::add(pugi::xml_node node, const std::string& sentence) {
    // An object to which several elements refer is read for each of them.
    sentences_.add(document_.where(node) + ": " + sentence + ".");
}

void Notices::add_once(pugi::xml_node node, const std::string& sentence) {
    if (said_.insert(sentence).second) add(node, sentence);
}

std::vector<std::string> Notices::take() {
    std::vector<std::string> all;
    if (!unfollowed_.empty()) all.push_back(first_place_ + ": not followed: " + joined(unfollowed_) + ".");
    all.insert(all.end(), sentences_.all().begin(), sentences_.all().end());
    return all;
}

}  // namespace nicol::scene
