// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>
#include <string>

#include "arguments.hpp"
#include "texture/texture.hpp"

namespace nicol {
namespace {

class Constant final : public Texture {
public:
    Constant(const glm::vec4& value, int channels) : value_(value), channels_(channels) {}

    [[nodiscard]] int channels() const noexcept override { return channels_; }
    [[nodiscard]] glm::vec4 at(const TexturePoint&) const override { return value_; }
    [[nodiscard]] glm::vec2 gradient(const TexturePoint&) const override { return glm::vec2(0); }
    [[nodiscard]] glm::vec4 mean() const override { return value_; }
    [[nodiscard]] glm::vec2 range() const override { return glm::vec2(value_.x); }
    [[nodiscard]] std::vector<float> values() const override { return {value_.x}; }
    [[nodiscard]] bool constant() const noexcept override { return true; }
    [[nodiscard]] bool needs_texcoords() const noexcept override { return false; }
    [[nodiscard]] bool needs_colors(ColorsOf) const noexcept override { return false; }
    [[nodiscard]] TextureDescription describe() const override {
        return {.kind = TextureDescription::Kind::constant, .colors = {value_, {}}};
    }

private:
    glm::vec4 value_;
    int channels_;
};

}  // namespace

TexturePtr constant_texture(const glm::vec4& value, int channels) {
    require(channels == 1 || channels == 3 || channels == 4,
            "a texture has " + std::to_string(channels) + " channels; it must have 1, 3 or 4");
    glm::vec4 all = value;
    if (channels == 1) all = glm::vec4(value.x);
    if (channels != 4) all.w = 1;
    for (glm::length_t c = 0; c < 4; ++c)
        require(std::isfinite(all[c]), "the value of a constant texture is not finite");
    return std::make_shared<Constant>(all, channels);
}

}  // namespace nicol
