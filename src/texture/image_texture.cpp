// SPDX-License-Identifier: MIT
// Images as textures.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "image/stokes_image.hpp"
#include "texture/image_levels.hpp"
#include "texture/lane_texels.hpp"
#include "texture/texture.hpp"
#include "texture/uv_transform.hpp"

namespace nicol {
namespace {

using Float4 [[gnu::vector_size(16)]] = float;

/// Values of one channel are alone; three, and four, lie side by side and are loaded at once, of three with
/// one value too many.
template <int channels>
auto load(const float* from) {
    if constexpr (channels == 1) {
        return *from;
    } else {
        Float4 values;
        std::memcpy(&values, from, sizeof values);
        return values;
    }
}
float first_of(float value) {
    return value;
}
float first_of(const Float4& values) {
    return values[0];
}
template <int channels, class Values>
glm::vec4 color_of(const Values& values) {
    if constexpr (channels == 1)
        return {values, values, values, 1};
    else
        return {values[0], values[1], values[2], channels == 4 ? values[3] : 1.0F};
}

template <class Values>
Values mix(const Values& a, const Values& b, float t) {
    return a + t * (b - a);
}

template <int kChannels>
class ImageTexture final : public Texture {
public:
    /// The image is valid.
    ImageTexture(TextureImage image, const TextureSampling& sampling)
        : filter_(sampling.filter), wrap_(sampling.wrap), to_uv_(sampling.to_uv) {
        gather(image);
        if (filter_ == TextureSampling::Filter::mipmap)
            levels_ = image_levels(std::move(image));
        else
            levels_.push_back(std::move(image));
        size_ = {levels_[0].width, levels_[0].height};
        for (TextureImage& level : levels_) {
            const std::size_t with_one_more = level.values.size() + (kChannels == 3 ? 1 : 0);
            level.values.reserve(with_one_more);
            level.values.resize(with_one_more);
        }
    }

    [[nodiscard]] int channels() const noexcept override { return kChannels; }
    [[nodiscard]] glm::vec4 mean() const override { return mean_; }
    [[nodiscard]] glm::vec2 range() const override { return range_; }
    [[nodiscard]] std::vector<float> values() const override { return few_values_; }
    [[nodiscard]] bool constant() const noexcept override { return false; }
    [[nodiscard]] bool needs_texcoords() const noexcept override { return true; }
    [[nodiscard]] bool needs_colors() const noexcept override { return false; }
    [[nodiscard]] bool needs_footprint() const noexcept override {
        return filter_ == TextureSampling::Filter::mipmap;
    }
    [[nodiscard]] TextureDescription describe() const override {
        return {.kind = TextureDescription::Kind::image,
                .sampling = {.filter = filter_, .wrap = wrap_, .to_uv = to_uv_.matrix()},
                .levels = levels_};
    }

    [[nodiscard]] glm::vec4 at(const TexturePoint& point) const override {
        const glm::vec2 uv = wrapped(point);
        if (filter_ == TextureSampling::Filter::nearest) {
            const int x = std::min(static_cast<int>(uv.x * size_.x), levels_[0].width - 1);
            const int y = std::min(static_cast<int>(uv.y * size_.y), levels_[0].height - 1);
            return color_of<kChannels>(load<kChannels>(row(levels_[0], y) + kChannels * x));
        }
        if (filter_ == TextureSampling::Filter::bilinear)
            return color_of<kChannels>(Cell(*this, levels_[0], uv).value());
        const auto [level, fraction] = level_of(point);
        const auto fine = Cell(*this, levels_[level], uv).value();
        if (fraction == 0) return color_of<kChannels>(fine);
        return color_of<kChannels>(mix(fine, Cell(*this, levels_[level + 1], uv).value(), fraction));
    }

    void at_lanes(const TexturePoints& points, std::array<Lanes, 4>& out) const override {
        const std::array<Lanes, 2> uv = nicol::wrapped(points.uv, to_uv_, wrap_);
        if (filter_ == TextureSampling::Filter::nearest) {
            const float* const texels = levels_[0].values.data();
            LaneIntegers at;
            find_nearest(uv, levels_[0].width, levels_[0].height, at);
            for (std::size_t i = 0; i < kLanes; ++i)
                put(load<kChannels>(texels + std::ptrdiff_t{kChannels} * at[i]), i, out);
        } else if (filter_ == TextureSampling::Filter::bilinear) {
            const TextureImage& image = levels_[0];
            LaneIntegers width, height;
            width.value.fill(image.width);
            height.value.fill(image.height);
            LaneTexels texels;
            find_texels(uv, width, height, wrap_, texels);
            for (std::size_t i = 0; i < kLanes; ++i) put(between(image.values.data(), texels, i), i, out);
        } else {
            Mixed mixed = levels_of(points);
            LaneTexels fine, coarse;
            find_texels(uv, mixed.width[0], mixed.height[0], wrap_, fine);
            find_texels(uv, mixed.width[1], mixed.height[1], wrap_, coarse);
            for (std::size_t i = 0; i < kLanes; ++i) {
                const auto level = static_cast<std::size_t>(mixed.level[i]);
                Values value = between(levels_[level].values.data(), fine, i);
                if (mixed.fraction[i] > 0)
                    value =
                        mix(value, between(levels_[level + 1].values.data(), coarse, i), mixed.fraction[i]);
                put(value, i, out);
            }
        }
    }

    [[nodiscard]] glm::vec2 gradient(const TexturePoint& point) const override {
        const glm::vec2 uv = wrapped(point);
        glm::vec2 slope;
        if (filter_ == TextureSampling::Filter::mipmap) {
            const auto [level, fraction] = level_of(point);
            slope = Cell(*this, levels_[level], uv).gradient();
            if (fraction > 0)
                slope = glm::mix(slope, Cell(*this, levels_[level + 1], uv).gradient(), fraction);
        } else {
            slope = Cell(*this, levels_[0], uv).gradient();
        }
        if (wrap_ == TextureSampling::Wrap::mirror) slope *= mirroring(point);
        return slope * to_uv_.linear;
    }

private:
    using Values = decltype(load<kChannels>(nullptr));

    [[nodiscard]] static const float* row(const TextureImage& level, int y) {
        return level.values.data() + static_cast<std::ptrdiff_t>(y) * level.width * kChannels;
    }

    /// The four texels around a point and where it lies between them. Texel centres are at (i + 0.5) / size.
    struct Cell {
        /// uv within 0 and 1.
        Cell(const ImageTexture& texture, const TextureImage& image, const glm::vec2& uv)
            : size(image.width, image.height) {
            const glm::vec2 texel = uv * size - 0.5F;
            const int x = floor_to_int(texel.x), y = floor_to_int(texel.y);
            at = texel - glm::vec2(x, y);
            const auto [left, right] = texture.neighbours(x, image.width);
            const auto [top, bottom] = texture.neighbours(y, image.height);
            const float *const upper = row(image, top), *const lower = row(image, bottom);
            a = load<kChannels>(upper + kChannels * left);
            b = load<kChannels>(upper + kChannels * right);
            c = load<kChannels>(lower + kChannels * left);
            d = load<kChannels>(lower + kChannels * right);
        }
        [[nodiscard]] Values value() const { return mix(mix(a, b, at.x), mix(c, d, at.x), at.y); }
        /// Of the first channel by u and v.
        [[nodiscard]] glm::vec2 gradient() const {
            const Values by_x = mix(b - a, d - c, at.y), by_y = mix(c - a, d - b, at.x);
            return size * glm::vec2(first_of(by_x), first_of(by_y));
        }

        glm::vec2 size, at;
        Values a, b, c, d;
    };

    /// Of texel i and the next one, -1 <= i < size.
    [[nodiscard]] std::pair<int, int> neighbours(int i, int size) const {
        if (wrap_ == TextureSampling::Wrap::repeat) return {i < 0 ? size - 1 : i, i + 1 == size ? 0 : i + 1};
        return {std::max(i, 0), std::min(i + 1, size - 1)};
    }

    /// Within 0 and 1.
    [[nodiscard]] glm::vec2 wrapped(const TexturePoint& point) const {
        const glm::vec2 uv = to_uv_(point.uv);
        return {wrapped(uv.x), wrapped(uv.y)};
    }
    [[nodiscard]] float wrapped(float t) const {
        if (wrap_ == TextureSampling::Wrap::clamp) return t > 0 ? std::min(t, 1.0F) : 0.0F;
        const float within = within_int(t);
        if (wrap_ == TextureSampling::Wrap::repeat) return within - static_cast<float>(floor_to_int(within));
        const float of_two = within - 2 * static_cast<float>(floor_to_int(within / 2));
        return std::min(of_two, 2 - of_two);
    }

    /// Whether u and v run with the image, 1, or against it, -1.
    [[nodiscard]] glm::vec2 mirroring(const TexturePoint& point) const {
        const glm::vec2 uv = to_uv_(point.uv);
        return {floor_to_int(within_int(uv.x)) % 2 == 0 ? 1 : -1,
                floor_to_int(within_int(uv.y)) % 2 == 0 ? 1 : -1};
    }

    /// Where the longer side of a pixel's footprint is as long as a texel: a level, and how far towards the
    /// next one.
    [[nodiscard]] std::pair<std::size_t, float> level_of(const TexturePoint& point) const {
        const glm::vec2 du = size_ * (to_uv_.linear * point.du), dv = size_ * (to_uv_.linear * point.dv);
        const float squared = std::max(glm::dot(du, du), glm::dot(dv, dv));
        if (!(squared > 1)) return {0, 0.0F};
        const float level = 0.5F * std::log2(squared);
        const std::size_t last = levels_.size() - 1;
        if (level >= static_cast<float>(last)) return {last, 0.0F};
        const auto whole = static_cast<std::size_t>(level);
        return {whole, level - static_cast<float>(whole)};
    }

    // The levels that sixteen points lie between.
    struct Mixed {
        LaneIntegers level;
        Lanes fraction;  // of the next one
        std::array<LaneIntegers, 2> width, height;
    };
    [[nodiscard]] Mixed levels_of(const TexturePoints& points) const {
        Mixed out;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const auto [level, fraction] = level_of({.uv = {},
                                                     .du = {points.du[0][i], points.du[1][i]},
                                                     .dv = {points.dv[0][i], points.dv[1][i]},
                                                     .color = {}});
            out.level[i] = static_cast<std::int32_t>(level);
            out.fraction[i] = fraction;
            for (std::size_t k = 0; k < 2; ++k) {
                const TextureImage& image = levels_[std::min(level + k, levels_.size() - 1)];
                out.width[k][i] = image.width;
                out.height[k][i] = image.height;
            }
        }
        return out;
    }

    [[nodiscard]] static Values between(const float* image, const LaneTexels& texels, std::size_t i) {
        const auto texel = [&](const LaneIntegers& at) {
            return load<kChannels>(image + std::ptrdiff_t{kChannels} * at[i]);
        };
        return mix(mix(texel(texels.upper_left), texel(texels.upper_right), texels.right[i]),
                   mix(texel(texels.lower_left), texel(texels.lower_right), texels.right[i]), texels.down[i]);
    }
    static void put(const Values& value, std::size_t i, std::array<Lanes, 4>& out) {
        const glm::vec4 color = color_of<kChannels>(value);
        for (glm::length_t c = 0; c < 4; ++c) out[static_cast<std::size_t>(c)][i] = color[c];
    }

    /// What is asked of the whole image.
    void gather(const TextureImage& image) {
        const std::vector<float>& values = image.values;
        glm::dvec4 sum(0);
        range_ = {values[0], values[0]};
        std::set<float> few;
        constexpr std::size_t most = 16;
        for (std::size_t i = 0; i < values.size(); i += kChannels) {
            for (std::size_t c = 0; c < kChannels; ++c)
                sum[static_cast<glm::length_t>(c)] += static_cast<double>(values[i + c]);
            range_ = {std::min(range_.x, values[i]), std::max(range_.y, values[i])};
            if (few.size() <= most && (i == 0 || values[i] != values[i - kChannels])) few.insert(values[i]);
        }
        const auto mean = glm::vec4(sum / (static_cast<double>(values.size()) / kChannels));
        mean_ = color_of<kChannels>(load<kChannels>(&mean.x));
        if (few.size() <= (filter_ == TextureSampling::Filter::nearest ? most : 1))
            few_values_.assign(few.begin(), few.end());
    }

    TextureSampling::Filter filter_;
    TextureSampling::Wrap wrap_;
    UvTransform to_uv_;
    std::vector<TextureImage> levels_;
    glm::vec2 size_{};  // of the finest, texels
    glm::vec4 mean_{};
    glm::vec2 range_{};
    std::vector<float> few_values_;
};

void check(const TextureImage& image) {
    const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height);
    require(image.channels == 1 || image.channels == 3 || image.channels == 4,
            "a texture image has " + std::to_string(image.channels) + " channels; it must have 1, 3 or 4");
    require(image.width >= 1 && image.height >= 1 && image.width <= kMaxImageSide &&
                image.height <= kMaxImageSide,
            "a texture image of " + size + " pixels; each side must lie in 1 to " +
                std::to_string(kMaxImageSide));
    const auto columns = static_cast<std::size_t>(image.width), rows = static_cast<std::size_t>(image.height);
    require(columns * rows <= kMaxImagePixels, "a texture image of " + size + " pixels; at most " +
                                                   std::to_string(kMaxImagePixels) + " are possible");
    require_size(image.values.size(), columns * rows * static_cast<std::size_t>(image.channels),
                 "a texture image");
    const auto bad = std::ranges::find_if(image.values, [](float v) { return !std::isfinite(v); });
    if (bad == image.values.end()) return;
    const auto pixel =
        static_cast<std::size_t>(bad - image.values.begin()) / static_cast<std::size_t>(image.channels);
    refuse("a texture image: pixel (" + std::to_string(pixel % columns) + ", " +
           std::to_string(pixel / columns) + ") is not finite");
}

bool is_constant(const TextureImage& image) {
    return std::equal(image.values.begin() + image.channels, image.values.end(), image.values.begin());
}

}  // namespace

TexturePtr image_texture(TextureImage image, const TextureSampling& sampling) {
    check(image);
    if (is_constant(image)) {
        static_cast<void>(UvTransform(sampling.to_uv));
        glm::vec4 value(0);
        for (int c = 0; c < image.channels; ++c) value[c] = image.values[static_cast<std::size_t>(c)];
        return constant_texture(value, image.channels);
    }
    switch (image.channels) {
        case 1:
            return std::make_shared<ImageTexture<1>>(std::move(image), sampling);
        case 3:
            return std::make_shared<ImageTexture<3>>(std::move(image), sampling);
        default:
            return std::make_shared<ImageTexture<4>>(std::move(image), sampling);
    }
}

}  // namespace nicol
