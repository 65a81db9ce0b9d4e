// SPDX-License-Identifier: MIT
// Textures that are functions, and meshes with texture coordinates.
#pragma once

#include <functional>
#include <stdexcept>
#include <utility>

#include "geometry/mesh.hpp"
#include "material/layered.hpp"
#include "test.hpp"

namespace nicol::test {

/// A texture whose value is a function of the point.
class FunctionTexture : public Texture {
public:
    using Function = std::function<glm::vec4(const TexturePoint&)>;
    explicit FunctionTexture(Function function, bool of_colors = false, int channels = 3)
        : function_(std::move(function)), of_colors_(of_colors), channels_(channels) {}

    [[nodiscard]] int channels() const noexcept override { return channels_; }
    [[nodiscard]] glm::vec4 at(const TexturePoint& point) const override { return function_(point); }
    [[nodiscard]] glm::vec2 gradient(const TexturePoint& point) const override {
        constexpr float h = 1e-3F;
        const auto along = [&](const glm::vec2& d) {
            TexturePoint before = point;
            TexturePoint after = point;
            before.uv -= d;
            after.uv += d;
            return (at(after).x - at(before).x) / (2 * h);
        };
        return {along({h, 0}), along({0, h})};
    }
    [[nodiscard]] glm::vec4 mean() const override { return function_({.uv = glm::vec2(0.5)}); }
    [[nodiscard]] glm::vec2 range() const override { return {0, 1}; }
    [[nodiscard]] bool constant() const noexcept override { return false; }
    [[nodiscard]] bool needs_texcoords() const noexcept override { return !of_colors_; }
    [[nodiscard]] bool needs_colors() const noexcept override { return of_colors_; }
    [[nodiscard]] TextureDescription describe() const override {
        throw std::logic_error("a function has no description");
    }

private:
    Function function_;
    bool of_colors_;
    int channels_;
};

inline TexturePtr texture_of(FunctionTexture::Function function, int channels = 3) {
    return std::make_shared<const FunctionTexture>(std::move(function), false, channels);
}
/// A normal map that leaves normals as they are, though it does not say so.
inline TexturePtr flat_normals() {
    return texture_of([](const TexturePoint&) { return glm::vec4(0.5F, 0.5F, 1, 1); });
}
inline TexturePtr vertex_colors() {
    return std::make_shared<const FunctionTexture>(
        [](const TexturePoint& point) { return glm::vec4(point.color, 1); }, true);
}

/// A mesh with texture coordinates that are linear in x and y: of a rectangle or cube 0 to 1, v downwards.
/// Every triangle has its own.
inline std::shared_ptr<const Mesh> with_texcoords(const Mesh& mesh) {
    Mesh out = mesh;
    out.texcoords.clear();
    out.texcoord_triangles.clear();
    for (const glm::uvec3& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(out.texcoords.size());
        for (const glm::length_t k : {2, 0, 1}) {
            const glm::vec3& p = mesh.positions[t[k]];
            out.texcoords.emplace_back(0.5F + 0.5F * p.x, 0.5F - 0.5F * p.y);
        }
        out.texcoord_triangles.emplace_back(first + 1, first + 2, first);
    }
    return std::make_shared<const Mesh>(std::move(out));
}

}  // namespace nicol::test
