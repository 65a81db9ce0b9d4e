// SPDX-License-Identifier: MIT
// Normals of a surface that deforms while its bake lags behind.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nicol {

/// Normals with which later steps used the visibility of vertices. These steps keep visibility in the frame
/// of its vertex, with which it turns: as long as a deforming surface has turned little, that is nearly as
/// good as another projection of the same visibility, and costs nothing.
class UsedNormals {
public:
    /// All vertices' visibility is used with their normals.
    void reset(std::span<const glm::vec3> normals);
    /// Takes over a change. former: for each vertex, its index before the change, or kNoVertex; set to
    /// kNoVertex if it has turned too far since its visibility was used. deformed: whether a vertex belongs
    /// to an object that has deformed. Returns 0 for such vertices, else 1.
    [[nodiscard]] std::vector<std::uint8_t> follow(std::span<const glm::vec3> normals,
                                                   std::span<std::uint32_t> former,
                                                   const std::function<bool(std::uint32_t)>& deformed);

    /// Returns whether a vertex has turned since its visibility was used.
    [[nodiscard]] bool turned(std::size_t vertex, const glm::vec3& normal) const {
        return normals_[vertex] != normal;
    }
    void use(std::size_t vertex, const glm::vec3& normal) { normals_[vertex] = normal; }

private:
    std::vector<glm::vec3> normals_;
};

}  // namespace nicol
