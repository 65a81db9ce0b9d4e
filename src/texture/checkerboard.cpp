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

// Returns the mean, over an interval, of a wave that is 1 from 0 to 1 and -1 from 1 to 2, and so on.
float mean_of_wave(float middle, float width) {
    const float within = middle - 2 * std::floor(0.5F * middle);
    constexpr float narrow = 1e-4F;  // narrower intervals have no digits left
    if (!(width >= narrow)) return within < 1 ? 1.0F : -1.0F;
    const auto integral = [](float x) {  // from 0 to x
        const float t = x - 2 * std::floor(0.5F * x);
        return t < 1 ? t : 2 - t;
    };
    return (integral(within + 0.5F * width) - integral(within - 0.5F * width)) / width;
}

class Checkerboard final : public Texture {
public:
    Checkerboard(const glm::vec3& color0, const glm::vec3& color1, int channels, const UvTransform& to_uv)
        : colors_{glm::vec4(color0, 1), glm::vec4(color1, 1)}, channels_(channels), to_uv_(to_uv) {}

    [[nodiscard]] int channels() const noexcept override { return channels_; }
    [[nodiscard]] glm::vec4 at(const TexturePoint& point) const override {
        // The footprint, a parallelogram, is the sum of small ones, each of which counts as a rectangle along
        // u and v.
        constexpr int parts = 4;
        const auto limited = [](const glm::vec2& v) { return glm::vec2(within_int(v.x), within_int(v.y)); };
        const glm::vec2 at = limited(2.0F * to_uv_(point.uv));
        const glm::vec2 right = limited(2.0F / parts * (to_uv_.linear * point.du));
        const glm::vec2 down = limited(2.0F / parts * (to_uv_.linear * point.dv));
        const glm::vec2 size = glm::abs(right) + glm::abs(down);
        float sum = 0;
        for (int i = 0; i < parts; ++i)
            for (int k = 0; k < parts; ++k) {
                const glm::vec2 middle = at + (static_cast<float>(i) - 0.5F * (parts - 1)) * right +
                                         (static_cast<float>(k) - 0.5F * (parts - 1)) * down;
                sum += mean_of_wave(middle.x, size.x) * mean_of_wave(middle.y, size.y);
            }
        const float second = 0.5F - 0.5F / (parts * parts) * sum;
        return (1 - second) * colors_[0] + second * colors_[1];
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
