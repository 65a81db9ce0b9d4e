// SPDX-License-Identifier: MIT
#include "visibility/traced_points.hpp"

#include "geometry/position_hash.hpp"

namespace nicol {
namespace {

template <class Value>
void append(std::span<const Value> from, std::vector<Value>& to) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void TracedPoints::add(std::span<const glm::vec3> origins, std::span<const glm::vec3> normals,
                       const Visibility& visibility, std::span<const glm::vec4> hidden) {
    if (hidden.empty()) return;
    words_ = visibility.at(0).size();
    for (std::size_t i = 0; i < hidden.size(); ++i)
        places_.try_emplace(geometry::hash_of(origins[i], normals[i]),
                            static_cast<std::uint32_t>(size() + i));
    append(origins, origins_);
    append(normals, normals_);
    append(visibility.bits(), bits_);
    append(visibility.unoccluded(), unoccluded_);
    append(hidden, hidden_);
}

std::optional<std::size_t> TracedPoints::find(const glm::vec3& origin, const glm::vec3& normal) const {
    const std::uint32_t* const place = places_.find(geometry::hash_of(origin, normal));
    if (place == nullptr || origins_[*place] != origin || normals_[*place] != normal) return std::nullopt;
    return *place;
}

Visibility TracedPoints::appended_to(const Visibility& given, std::span<const std::size_t> rows) const {
    std::vector<std::uint64_t> all_bits;
    all_bits.reserve(rows.size() * words_);
    append(given.bits(), all_bits);
    std::vector<std::uint8_t> open(given.unoccluded().begin(), given.unoccluded().end());
    for (const std::size_t row : rows.subspan(given.vertices())) {
        append(bits(row - given.vertices()), all_bits);
        open.push_back(unoccluded(row - given.vertices()) ? 1 : 0);
    }
    return {given.directions(), std::move(all_bits), std::move(open)};
}

std::size_t TracedPoints::bytes() const noexcept {
    return size() * (2 * sizeof(glm::vec3) + words_ * sizeof(std::uint64_t) + 1 + sizeof(glm::vec4)) +
           places_.bytes();
}

}  // namespace nicol
