// SPDX-License-Identifier: MIT
#include "surfaces/equal_materials.hpp"

#include <iterator>
#include <utility>

namespace nicol {
namespace {

// Returns text that is equal for materials which surfaces can exchange; empty: unknown.
std::string key_of(const Material& material) {
    if (material.variation() != nullptr || material.behind() != nullptr) return {};
    const std::string content = material.content_key();
    if (content.empty()) return {};
    return content + (material.twosided() ? " two-sided " : " one-sided ") +
           std::to_string(material.channels());
}

template <class Map>
void forget(Map& known) {
    for (auto entry = known.begin(); entry != known.end();)
        entry = std::exchange(entry->second.used, false) ? std::next(entry) : known.erase(entry);
}

}  // namespace

MaterialPtr EqualMaterials::first_of(const MaterialPtr& material) {
    const auto [known, added] = firsts_.try_emplace(material, Known{material, true});
    known->second.used = true;
    if (!added) {
        if (const std::string key = key_of(*known->second.first); !key.empty()) equals_.at(key).used = true;
        return known->second.first;
    }
    if (std::string key = key_of(*material); !key.empty()) {
        Known& equal = equals_.try_emplace(std::move(key), Known{material, true}).first->second;
        equal.used = true;
        known->second.first = equal.first;
    }
    return known->second.first;
}

void EqualMaterials::forget_unused() {
    forget(firsts_);
    forget(equals_);
}

}  // namespace nicol
