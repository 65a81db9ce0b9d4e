// SPDX-License-Identifier: MIT
#include <memory>

#include "texture/texture.hpp"

namespace nicol {
namespace {

class MeshColor final : public Texture {
public:
    explicit MeshColor(ColorsOf of) : of_(of) {}

    [[nodiscard]] int channels() const noexcept override { return 3; }
    [[nodiscard]] glm::vec4 at(const TexturePoint& point) const override { return {point.color, 1}; }
    [[nodiscard]] glm::vec2 gradient(const TexturePoint&) const override { return glm::vec2(0); }
    [[nodiscard]] glm::vec4 mean() const override { return {0.5F, 0.5F, 0.5F, 1}; }
    [[nodiscard]] glm::vec2 range() const override { return {0, 1}; }
    [[nodiscard]] bool constant() const noexcept override { return false; }
    [[nodiscard]] bool needs_texcoords() const noexcept override { return false; }
    [[nodiscard]] bool needs_colors(ColorsOf of) const noexcept override { return of == of_; }
    [[nodiscard]] TextureDescription describe() const override {
        return {.kind = TextureDescription::Kind::mesh_color};
    }

private:
    ColorsOf of_;
};

}  // namespace

TexturePtr mesh_color_texture(ColorsOf of) {
    return std::make_shared<MeshColor>(of);
}

}  // namespace nicol
