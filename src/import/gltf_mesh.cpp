// SPDX-License-Identifier: MIT
// Primitives.
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <unordered_map>

#include "geometry/finite.hpp"
#include "geometry/mesh_normals.hpp"
#include "import/gltf_accessor.hpp"
#include "import/gltf_readers.hpp"

namespace nicol::scene {
namespace {

class Primitive {
public:
    Primitive(const GltfDocument& document, const tinygltf::Primitive& primitive, const std::string& where,
              const GltfMaterial& material, const GltfDeformation* deformation, const LoadBudget& budget,
              geometry::LeftOut& left_out)
        : document_(document),
          primitive_(primitive),
          where_(where),
          deformation_(deformation),
          budget_(budget),
          left_out_(left_out) {
        positions_ = attribute("POSITION", 3, 3);
        if (!positions_) document_.fail(where_, "has no POSITION");
        // Light that an unlit surface emits would end where an interpolated normal turns away from the
        // viewer.
        if (!material.emission) normals_ = attribute("NORMAL", 3, 3);
        texcoords_ = attribute("TEXCOORD_" + std::to_string(material.texcoord_set), 2, 2);
        colors_ = attribute("COLOR_0", 3, 4);
        // Tangents without normals must be ignored, as glTF says.
        if (normals_) tangents_ = attribute("TANGENT", 4, 4);
        if (colors_ && !colors_->is_real())
            document_.fail(where_, "COLOR_0 has integers that are not normalized");
        if (primitive_.indices >= 0) indices_.emplace(document_, primitive_.indices, where_ + ": indices");
        if (indices_ && (indices_->components() != 1 || !indices_->is_unsigned() || indices_->is_real()))
            document_.fail(where_, "indices must be SCALAR, of integers without sign, not normalized");
        if (positions_->count() >= std::numeric_limits<std::uint32_t>::max())
            document_.fail(where_, "more than 2^32 - 2 vertices", ErrorCode::unsupported);
    }

    [[nodiscard]] std::size_t triangle_count() const {
        const std::size_t corners = corner_count();
        if (primitive_.mode == TINYGLTF_MODE_TRIANGLES) return corners / 3;
        return corners < 3 ? 0 : corners - 2;
    }

    /// Without normals that the file does not give, and without what has no area.
    Mesh mesh() {
        if (primitive_.mode == TINYGLTF_MODE_TRIANGLES)
            left_out_.add("corners of no triangle", corner_count() % 3);
        const std::size_t triangles = triangle_count();
        for (std::size_t t = 0; t < triangles; ++t) {
            budget_.step(32);
            glm::uvec3 triangle;
            for (glm::length_t k = 0; k < 3; ++k)
                triangle[k] = vertex_of(corner(t, static_cast<std::size_t>(k)));
            mesh_.triangles.push_back(triangle);
            if (texcoords_ || tangents_) mesh_.texcoord_triangles.push_back(triangle);
        }
        left_out_.add("triangles without area", geometry::remove_flat_triangles(mesh_));
        return std::move(mesh_);
    }

private:
    std::optional<GltfAccessor> attribute(const std::string& name, std::size_t least, std::size_t most) {
        const auto found = primitive_.attributes.find(name);
        if (found == primitive_.attributes.end()) return std::nullopt;
        std::optional<GltfAccessor> accessor(std::in_place, document_, found->second, where_ + ": " + name);
        if (accessor->components() < least || accessor->components() > most)
            document_.fail(where_, name + " has elements of " + std::to_string(accessor->components()) +
                                       " numbers; expected " + std::to_string(least));
        if (positions_ && accessor->count() < positions_->count())
            document_.fail(where_, name + " has " + std::to_string(accessor->count()) +
                                       " elements and POSITION " + std::to_string(positions_->count()));
        return accessor;
    }

    [[nodiscard]] std::size_t corner_count() const {
        return indices_ ? indices_->count() : positions_->count();
    }

    /// Returns the corner of the primitive that is corner k of triangle t. Every other triangle of a strip
    /// begins with its second corner, so that all triangles face the same side.
    [[nodiscard]] std::size_t corner(std::size_t t, std::size_t k) const {
        switch (primitive_.mode) {
            case TINYGLTF_MODE_TRIANGLE_STRIP:
                return k == 0 ? t : t + (k == 1 ? 1 + t % 2 : 2 - t % 2);
            case TINYGLTF_MODE_TRIANGLE_FAN:
                return k == 2 ? 0 : t + 1 + k;
            default:
                return 3 * t + k;
        }
    }

    /// The vertex of the mesh at a corner. Primitives often share accessors of which each uses a part.
    std::uint32_t vertex_of(std::size_t corner) {
        const std::size_t index = indices_ ? static_cast<std::size_t>(indices_->number(corner, 0)) : corner;
        if (index >= positions_->count())
            document_.fail(where_, "index " + std::to_string(corner) + " is " + std::to_string(index) +
                                       ", but there are only " + std::to_string(positions_->count()) +
                                       " vertices");
        const auto [entry, is_new] =
            vertices_.try_emplace(index, static_cast<std::uint32_t>(mesh_.positions.size()));
        if (is_new) add(index);
        return entry->second;
    }

    void add(std::size_t index) {
        GltfDeformation::Vertex vertex{.position = vector(*positions_, index),
                                       .normal = normals_ ? vector(*normals_, index) : glm::dvec3(0),
                                       .tangent = tangents_ ? vector(*tangents_, index) : glm::dvec3(0)};
        if (deformation_ != nullptr) vertex = (*deformation_)(index, vertex);
        const glm::vec3 position(vertex.position);
        if (!is_finite(position))
            document_.fail(where_, "POSITION of vertex " + std::to_string(index) + " is not finite");
        mesh_.positions.push_back(position);
        if (normals_) {
            glm::vec3 normal(vertex.normal);
            if (!is_finite(normal)) {
                left_out_.add("normals that are not finite");
                normal = glm::vec3(0);
            }
            mesh_.normals.push_back(normal);
        }
        if (colors_) {
            const glm::vec3 color(vector(*colors_, index));
            mesh_.colors.push_back(is_finite(color) ? color : glm::vec3(1));
        }
        if (texcoords_) {
            const glm::vec2 uv(texcoords_->number(index, 0), texcoords_->number(index, 1));
            mesh_.texcoords.push_back(is_finite(uv) ? uv : glm::vec2(0));
        }
        if (tangents_) {
            if (!texcoords_) mesh_.texcoords.emplace_back(0);
            const glm::vec3 along(vertex.tangent);
            const float length = glm::length(along);
            const bool valid = std::isfinite(length) && length > 0;
            mesh_.tangents.emplace_back(valid ? along / length : glm::vec3(0),
                                        tangents_->number(index, 3) < 0 ? -1.0F : 1.0F);
        }
    }

    static glm::dvec3 vector(const GltfAccessor& from, std::size_t i) {
        return {from.number(i, 0), from.number(i, 1), from.number(i, 2)};
    }

    const GltfDocument& document_;
    const tinygltf::Primitive& primitive_;
    const std::string& where_;
    const GltfDeformation* deformation_;  // null: vertices stay
    const LoadBudget& budget_;
    geometry::LeftOut& left_out_;
    std::optional<GltfAccessor> positions_, normals_, texcoords_, colors_, tangents_, indices_;
    std::unordered_map<std::size_t, std::uint32_t> vertices_;
    Mesh mesh_;
};

}  // namespace

std::shared_ptr<const Mesh> read_gltf_primitive(const GltfDocument& document,
                                                const tinygltf::Primitive& primitive,
                                                const std::string& where, const GltfMaterial& material,
                                                const GltfDeformation* deformation, const LoadBudget& budget,
                                                geometry::LeftOut& left_out) {
    if (primitive.mode >= TINYGLTF_MODE_POINTS && primitive.mode < TINYGLTF_MODE_TRIANGLES) {
        left_out.add("primitives of points or lines");
        return nullptr;
    }
    if (primitive.mode < 0 || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
        document.fail(where, "mode is " + std::to_string(primitive.mode) + "; expected 0 to 6");
    Primitive reader(document, primitive, where, material, deformation, budget, left_out);
    budget.take_mesh(document.path(), 0, reader.triangle_count());
    Mesh mesh = reader.mesh();
    if (mesh.triangles.empty()) {
        left_out.add("primitives of no triangle with an area");
        return nullptr;
    }
    if (mesh.normals.empty())
        mesh = with_face_normals(mesh);
    else
        geometry::complete_normals(mesh);
    budget.take_mesh(document.path(), mesh.positions.size(), 0);
    return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace nicol::scene
