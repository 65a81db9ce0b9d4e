// SPDX-License-Identifier: MIT
// Materials whose terms depend on few of their parameters, so that many materials share integrals.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "material/material.hpp"

namespace nicol {

/// Material whose weights are parameters that its terms do not depend on.
class SharedTerms {
public:
    /// Returns the parameters that Material::evaluate() depends on, as text. Materials with equal texts have
    /// equal terms. Empty: unknown.
    [[nodiscard]] virtual std::string own_terms_key() const = 0;

protected:
    SharedTerms() = default;
    ~SharedTerms() = default;
};

/// Returns a text that is equal for materials with equal terms, of which the same are black. Empty if the
/// material is no SharedTerms.
[[nodiscard]] inline std::string terms_key(const Material& material) {
    const auto* shared = dynamic_cast<const SharedTerms*>(&material);
    if (shared == nullptr) return {};
    std::string key = shared->own_terms_key();
    if (key.empty()) return {};
    // Material::evaluate_lanes() may leave out black terms.
    for (int term = 0; term < material.terms(); ++term) {
        bool black = true;
        for (int c = 0; c < material.channels(); ++c) black = black && material.weight(term, c) == 0;
        key += black ? " black" : " lit";
    }
    return key;
}

/// Returns the indices of materials in groups of equal terms. Materials whose terms are unknown are alone.
[[nodiscard]] inline std::vector<std::vector<std::size_t>> groups_by_terms(
    std::span<const MaterialPtr> materials) {
    std::vector<std::vector<std::size_t>> groups;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        std::string key = terms_key(*materials[i]);
        const std::size_t next = groups.size();
        const std::size_t group = key.empty() ? next : known.try_emplace(std::move(key), next).first->second;
        if (group == next) groups.emplace_back();
        groups[group].push_back(i);
    }
    return groups;
}

/// Results for the terms of materials, kept for those that several materials of a list have.
template <class Known>
class KnownByTerms {
public:
    explicit KnownByTerms(std::span<const MaterialPtr> materials) {
        for (const MaterialPtr& material : materials) {
            const std::string key = terms_key(*material);
            if (!key.empty()) ++entries_[key].materials;
        }
    }
    /// Returns the results for a material's terms; null: no other material has the same terms.
    [[nodiscard]] Known* of(const Material& material) {
        const auto entry = entries_.find(terms_key(material));
        if (entry == entries_.end() || entry->second.materials < 2) return nullptr;
        if (!entry->second.known) entry->second.known = std::make_unique<Known>();
        return entry->second.known.get();
    }

private:
    struct Entry {
        std::size_t materials = 0;
        std::unique_ptr<Known> known;
    };
    std::map<std::string, Entry> entries_;
};

}  // namespace nicol
