// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "texture/texture.hpp"

namespace nicol {
namespace {

class Product final : public Texture {
public:
    Product(TexturePtr first, TexturePtr second) : first_(std::move(first)), second_(std::move(second)) {}

    [[nodiscard]] int channels() const noexcept override {
        return std::max(first_->channels(), second_->channels());
    }
    [[nodiscard]] glm::vec4 at(const TexturePoint& point) const override {
        return first_->at(point) * second_->at(point);
    }
    void at_lanes(const TexturePoints& points, std::array<Lanes, 4>& out) const override {
        std::array<Lanes, 4> second;
        first_->at_lanes(points, out);
        second_->at_lanes(points, second);
        for (std::size_t c = 0; c < out.size(); ++c)
            for (std::size_t i = 0; i < kLanes; ++i) out[c][i] *= second[c][i];
    }
    [[nodiscard]] glm::vec2 gradient(const TexturePoint&) const override { return glm::vec2(0); }
    [[nodiscard]] glm::vec4 mean() const override { return first_->mean() * second_->mean(); }
    [[nodiscard]] glm::vec2 range() const override {
        const glm::vec2 a = first_->range(), b = second_->range();
        const auto [least, most] = std::minmax({a.x * b.x, a.x * b.y, a.y * b.x, a.y * b.y});
        return {least, most};
    }
    [[nodiscard]] bool constant() const noexcept override {
        return first_->constant() && second_->constant();
    }
    [[nodiscard]] bool needs_texcoords() const noexcept override {
        return first_->needs_texcoords() || second_->needs_texcoords();
    }
    [[nodiscard]] bool needs_colors(ColorsOf of) const noexcept override {
        return first_->needs_colors(of) || second_->needs_colors(of);
    }
    [[nodiscard]] bool needs_footprint() const noexcept override {
        return first_->needs_footprint() || second_->needs_footprint();
    }
    [[nodiscard]] TextureDescription describe() const override {
        return {.kind = TextureDescription::Kind::product, .factors = {first_, second_}};
    }

private:
    TexturePtr first_, second_;
};

}  // namespace

TexturePtr product_texture(TexturePtr first, TexturePtr second) {
    for (const TexturePtr& factor : {first, second}) {
        require(factor != nullptr, "a factor of a product of textures is null; give one");
        require(factor->channels() != 4, "a factor of a product of textures has 4 channels; expected 1 or 3");
    }
    return std::make_shared<Product>(std::move(first), std::move(second));
}

}  // namespace nicol
