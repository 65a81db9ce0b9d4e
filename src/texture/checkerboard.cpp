// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "texture/texture.hpp"
#include "texture/uv_transform.hpp"

namespace nicol {
namespace {

class Checkerboard final : public Texture {
public:
    Checkerboard(const glm::vec3& color0, const glm::vec3& color1, int channels, const UvTransform& to_uv)
        : colors_{glm::vec4(color0, 1), glm::vec4(color1, 1)}, channels_(channels), to_uv_(to_uv) {}

    [[nodiscard]] int channels() const noexcept override { return channels_; }
    [[nodiscard]] glm::vec4 at(const TexturePoint& point) const override {
        const glm::vec2 uv = to_uv_(point.uv);
        const int squares = floor_to_int(within_int(2 * uv.x)) + floor_to_int(within_int(2 * uv.y));
        return colors_[squares % 2 == 0 ? 0 : 1];
    }
    [[nodiscard]] glm::vec2 gradient(const TexturePoint&) const override { return glm::vec2(0); }
    [[nodiscard]] glm::vec4 mean() const override { return 0.5F * (colors_[0] + colors_[1]); }
    [[nodiscard]] glm::vec2 range() const override {
        return {std::min(colors_[0].x, colors_[1].x), std::max(colors_[0].x, colors_[1].x)};
    }
    [[nodiscard]] std::vector<float> values() const override {
        const glm::vec2 both = range();
        if (both.x == both.y) return {both.x};
        return {both.x, both.y};
    }
    [[nodiscard]] bool constant() const noexcept override { return false; }
    [[nodiscard]] bool needs_texcoords() const noexcept override { return true; }
    [[nodiscard]] bool needs_colors(ColorsOf) const noexcept override { return false; }
    [[nodiscard]] bool needs_footprint() const noexcept override { return false; }
    [[nodiscard]] TextureDescription describe() const override {
        return {.kind = TextureDescription::Kind::checkerboard,
                .sampling = {.to_uv = to_uv_.matrix()},
                .colors = colors_};
    }

private:
    std::array<glm::vec4, 2> colors_;
    int channels_;
    UvTransform to_uv_;
};

}  // namespace

TexturePtr checkerboard_texture(const glm::vec3& color0, const glm::vec3& color1, int channels,
                                const glm::dmat3& to_uv) {
    require(channels == 1 || channels == 3,
            "a checkerboard has " + std::to_string(channels) + " channels; it must have 1 or 3");
    glm::vec3 colors[] = {color0, color1};
    for (glm::vec3& color : colors) {
        if (channels == 1) color = glm::vec3(color.x);
        require(std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z),
                "a colour of a checkerboard is not finite");
    }
    const UvTransform transform(to_uv);
    if (colors[0] == colors[1]) return constant_texture(glm::vec4(colors[0], 1), channels);
    return std::make_shared<Checkerboard>(colors[0], colors[1], channels, transform);
}

}  // namespace nicol
