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
    const auto [entry, added] = known_.try_emplace(material);
    Known& known = entry->second;
    if (added) {
        if (std::string key = key_of(*material); !key.empty())
            known.equals = &by_content_.try_emplace(std::move(key), Equals{material}).first->second;
    }
    known.used = true;
    if (known.equals == nullptr) return material;
    known.equals->used = true;
    return known.equals->first;
}

void EqualMaterials::forget_unused() {
    forget(known_);
    forget(by_content_);  // all materials of an unused entry have just been forgotten
}

}  // namespace nicol
