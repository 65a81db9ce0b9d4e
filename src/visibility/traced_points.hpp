// SPDX-License-Identifier: MIT
// Points that a refinement traced, kept for the next state of a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "geometry/key_table.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Points between vertices, and what is visible from them.
class TracedPoints {
public:
    [[nodiscard]] std::size_t size() const noexcept { return hidden_.size(); }
    /// Appends points: the origins of their rays, unit normals, visibility and HiddenLight.
    void add(std::span<const glm::vec3> origins, std::span<const glm::vec3> normals,
             const Visibility& visibility, std::span<const glm::vec4> hidden);

    /// Returns the index of the point with equal origin and normal; nothing if there is none, or if another
    /// point has the same hash.
    [[nodiscard]] std::optional<std::size_t> find(const glm::vec3& origin, const glm::vec3& normal) const;

    [[nodiscard]] const glm::vec3& origin(std::size_t point) const { return origins_[point]; }
    [[nodiscard]] const glm::vec3& normal(std::size_t point) const { return normals_[point]; }
    /// Returns the bits of a point, as Visibility::at().
    [[nodiscard]] std::span<const std::uint64_t> bits(std::size_t point) const {
        return std::span(bits_).subspan(point * words_, words_);
    }
    [[nodiscard]] bool unoccluded(std::size_t point) const { return unoccluded_[point] != 0; }
    [[nodiscard]] const glm::vec4& hidden(std::size_t point) const { return hidden_[point]; }
    [[nodiscard]] std::size_t bytes() const noexcept;
    /// Returns the visibility of the given vertices and of vertices added at points. rows: by vertex; from
    /// the first added vertex on, the number of its point plus that of given vertices.
    [[nodiscard]] Visibility appended_to(const Visibility& given, std::span<const std::size_t> rows) const;

private:
    std::size_t words_ = 0;
    std::vector<glm::vec3> origins_;
    std::vector<glm::vec3> normals_;
    std::vector<std::uint64_t> bits_;
    std::vector<std::uint8_t> unoccluded_;
    std::vector<glm::vec4> hidden_;
    KeyTable<std::uint32_t> places_;  // by hash of origin and normal
};

}  // namespace nicol
