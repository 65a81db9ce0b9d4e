// SPDX-License-Identifier: MIT
// Textures defined by functions.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "texture/texture.hpp"

namespace nicol::test {

/// A texture whose value is a function of the texture point.
class FunctionTexture : public Texture {
public:
    using Function = std::function<glm::vec4(const TexturePoint&)>;
    /// Takes the function. mean() returns its value at uv = (0.5, 0.5). `range` is that of the first channel.
    /// `colors` names the mesh colours that the function needs instead of texture coordinates.
    explicit FunctionTexture(Function function, int channels = 3, const glm::vec2& range = glm::vec2(0, 1),
                             std::optional<ColorsOf> colors = std::nullopt)
        : function_(std::move(function)), channels_(channels), range_(range), colors_(colors) {}

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
    [[nodiscard]] glm::vec2 range() const override { return range_; }
    [[nodiscard]] bool constant() const noexcept override { return false; }
    [[nodiscard]] bool needs_texcoords() const noexcept override { return !colors_; }
    [[nodiscard]] bool needs_colors(ColorsOf of) const noexcept override { return colors_ == of; }
    [[nodiscard]] TextureDescription describe() const override {
        throw std::logic_error("a function has no description");
    }

private:
    Function function_;
    int channels_;
    glm::vec2 range_;
    std::optional<ColorsOf> colors_;
};

inline TexturePtr texture_of(FunctionTexture::Function function, int channels = 3,
                             const glm::vec2& range = glm::vec2(0, 1)) {
    return std::make_shared<const FunctionTexture>(std::move(function), channels, range);
}

}  // namespace nicol::test
