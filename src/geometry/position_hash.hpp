// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace nicol::geometry {

/// Returns a hash that is equal for equal vectors, also if they differ in the sign of a zero.
[[nodiscard]] inline std::size_t hash_of(const glm::vec3& v) {
    std::uint64_t hash = 0;
    for (glm::length_t i = 0; i < 3; ++i)
        hash = (hash ^ std::bit_cast<std::uint32_t>(v[i] + 0.0F)) * 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>(hash ^ (hash >> 32U));
}

/// Returns a hash of two vectors in this order.
[[nodiscard]] inline std::size_t hash_of(const glm::vec3& a, const glm::vec3& b) {
    return hash_of(a) * std::size_t{0x9e3779b97f4a7c15U} ^ hash_of(b);
}

}  // namespace nicol::geometry
