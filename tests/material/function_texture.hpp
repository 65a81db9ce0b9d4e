// SPDX-License-Identifier: MIT
// A texture that is any function of u and v.
#pragma once

#include <functional>
#include <stdexcept>
#include <utility>

#include "material/texture.hpp"

namespace nicol {

class FunctionTexture final : public Texture {
public:
    /// `range`: of the first channel. `mean`: what mean() says.
    FunctionTexture(int channels, std::function<glm::vec4(glm::vec2)> of, glm::vec4 mean,
                    glm::vec2 range = glm::vec2(0, 1))
        : channels_(channels), of_(std::move(of)), mean_(mean), range_(range) {}

    [[nodiscard]] int channels() const noexcept override { return channels_; }
    [[nodiscard]] glm::vec4 at(const TexturePoint& point) const override { return of_(point.uv); }
    [[nodiscard]] glm::vec2 gradient(const TexturePoint& point) const override {
        constexpr float step = 1e-3F;
        const auto along = [&](glm::vec2 by) {
            return (of_(point.uv + by).x - of_(point.uv - by).x) / (2 * step);
        };
        return {along({step, 0}), along({0, step})};
    }
    [[nodiscard]] glm::vec4 mean() const override { return mean_; }
    [[nodiscard]] glm::vec2 range() const override { return range_; }
    [[nodiscard]] bool constant() const noexcept override { return false; }
    [[nodiscard]] bool needs_texcoords() const noexcept override { return true; }
    [[nodiscard]] bool needs_colors() const noexcept override { return false; }
    [[nodiscard]] TextureDescription describe() const override {
        throw std::logic_error("a function has no description");
    }

private:
    int channels_;
    std::function<glm::vec4(glm::vec2)> of_;
    glm::vec4 mean_;
    glm::vec2 range_;
};

/// u in every channel.
inline TexturePtr ramp_texture() {
    return std::make_shared<FunctionTexture>(
        1, [](glm::vec2 uv) { return glm::vec4(uv.x, uv.x, uv.x, 1); }, glm::vec4(0.5F, 0.5F, 0.5F, 1));
}

}  // namespace nicol
