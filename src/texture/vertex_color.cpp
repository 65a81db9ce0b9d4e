// SPDX-License-Identifier: MIT
#include <memory>

#include "texture/texture.hpp"

namespace nicol {
namespace {

class VertexColor final : public Texture {
public:
    [[nodiscard]] int channels() const noexcept override { return 3; }
    [[nodiscard]] glm::vec4 at(const TexturePoint& point) const override { return {point.color, 1}; }
    [[nodiscard]] glm::vec2 gradient(const TexturePoint&) const override { return glm::vec2(0); }
    [[nodiscard]] glm::vec4 mean() const override { return {0.5F, 0.5F, 0.5F, 1}; }
    [[nodiscard]] glm::vec2 range() const override { return {0, 1}; }
    [[nodiscard]] bool constant() const noexcept override { return false; }
    [[nodiscard]] bool needs_texcoords() const noexcept override { return false; }
    [[nodiscard]] bool needs_colors() const noexcept override { return true; }
    [[nodiscard]] TextureDescription describe() const override {
        return {.kind = TextureDescription::Kind::vertex_color};
    }
};

}  // namespace

TexturePtr vertex_color_texture() {
    return std::make_shared<VertexColor>();
}

}  // namespace nicol
