// SPDX-License-Identifier: MIT
// Textures of images.
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
#include "texture/footprint.hpp"
#include "texture/image_levels.hpp"
#include "texture/lane_texels.hpp"
#include "texture/texture.hpp"
#include "texture/uv_transform.hpp"

namespace nicol {
namespace {

using Float4 [[gnu::vector_size(16)]] = float;

/// Loads the values of one pixel: a number for one channel, a vector for three or four channels. A vector of
/// three channels has one value too many.
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
    /// Takes a valid image.
    ImageTexture(TextureImage image, const TextureSampling& sampling)
        : filter_(sampling.filter),
          wrap_(sampling.wrap),
          shape_{.width = 0, .height = 0, .last_level = 0, .to_uv = UvTransform(sampling.to_uv)} {
        gather(image);
        if (filter_ == TextureSampling::Filter::mipmap)
            levels_ = image_levels(std::move(image));
        else
            levels_.push_back(std::move(image));
        shape_.width = levels_[0].width;
        shape_.height = levels_[0].height;
        shape_.last_level = static_cast<int>(levels_.size()) - 1;
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
    [[nodiscard]] bool needs_colors(ColorsOf) const noexcept override { return false; }
    [[nodiscard]] bool needs_footprint() const noexcept override {
        return filter_ == TextureSampling::Filter::mipmap;
    }
    [[nodiscard]] TextureDescription describe() const override {
        return {.kind = TextureDescription::Kind::image,
                .sampling = {.filter = filter_, .wrap = wrap_, .to_uv = shape_.to_uv.matrix()},
                .levels = levels_};
    }

    [[nodiscard]] glm::vec4 at(const TexturePoint& point) const override {
        if (filter_ == TextureSampling::Filter::mipmap)
            return color_of<kChannels>(
                mean_of_taps<Values>(point, [](const Cell& cell, const glm::vec2&) { return cell.value(); }));
        const glm::vec2 uv = wrapped(shape_.to_uv(point.uv));
        const TextureImage& image = levels_[0];
        if (filter_ == TextureSampling::Filter::bilinear)
            return color_of<kChannels>(Cell(*this, image, uv).value());
        const int x = std::min(static_cast<int>(uv.x * static_cast<float>(image.width)), image.width - 1);
        const int y = std::min(static_cast<int>(uv.y * static_cast<float>(image.height)), image.height - 1);
        return color_of<kChannels>(load<kChannels>(row(image, y) + kChannels * x));
    }

    void at_lanes(const TexturePoints& points, std::array<Lanes, 4>& out) const override {
        if (filter_ == TextureSampling::Filter::mipmap) {
            mipmap_at_lanes(points, out);
            return;
        }
        const std::array<Lanes, 2> uv = nicol::wrapped(points.uv, shape_.to_uv, wrap_);
        const TextureImage& image = levels_[0];
        const float* const first = image.values.data();
        if (filter_ == TextureSampling::Filter::nearest) {
            LaneIntegers at;
            find_nearest(uv, image.width, image.height, at);
            for (std::size_t i = 0; i < kLanes; ++i)
                put(load<kChannels>(first + std::ptrdiff_t{kChannels} * at[i]), i, out);
        } else {
            LaneTexels texels;
            find_texels(uv, image.width, image.height, {}, wrap_, texels);
            for (std::size_t i = 0; i < kLanes; ++i) put(between(first, texels, i), i, out);
        }
    }

    [[nodiscard]] glm::vec2 gradient(const TexturePoint& point) const override {
        const auto slope = [&](const Cell& cell, const glm::vec2& uv) {
            return wrap_ == TextureSampling::Wrap::mirror ? mirroring(uv) * cell.gradient() : cell.gradient();
        };
        if (filter_ == TextureSampling::Filter::mipmap)
            return mean_of_taps<glm::vec2>(point, slope) * shape_.to_uv.linear;
        const glm::vec2 uv = shape_.to_uv(point.uv);
        return slope(Cell(*this, levels_[0], wrapped(uv)), uv) * shape_.to_uv.linear;
    }

private:
    using Values = decltype(load<kChannels>(nullptr));

    [[nodiscard]] static const float* row(const TextureImage& level, int y) {
        return level.values.data() + static_cast<std::ptrdiff_t>(y) * level.width * kChannels;
    }

    /// Four texels around a point and the point's position between them.
    /// Texel centres are at (i + 0.5) / size.
    struct Cell {
        /// `uv` must lie within 0 and 1.
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
        /// Returns the derivatives of the first channel by u and v.
        [[nodiscard]] glm::vec2 gradient() const {
            const Values by_x = mix(b - a, d - c, at.y), by_y = mix(c - a, d - b, at.x);
            return size * glm::vec2(first_of(by_x), first_of(by_y));
        }

        glm::vec2 size, at;
        Values a, b, c, d;
    };

    /// Returns the wrapped indices of texel i and the next texel, for -1 <= i < size.
    [[nodiscard]] std::pair<int, int> neighbours(int i, int size) const {
        if (wrap_ == TextureSampling::Wrap::repeat) return {i < 0 ? size - 1 : i, i + 1 == size ? 0 : i + 1};
        return {std::max(i, 0), std::min(i + 1, size - 1)};
    }

    /// Returns `uv` wrapped to 0 to 1.
    [[nodiscard]] glm::vec2 wrapped(const glm::vec2& uv) const { return {wrapped(uv.x), wrapped(uv.y)}; }
    [[nodiscard]] float wrapped(float t) const {
        if (wrap_ == TextureSampling::Wrap::clamp) return t > 0 ? std::min(t, 1.0F) : 0.0F;
        const float within = within_int(t);
        if (wrap_ == TextureSampling::Wrap::repeat) return within - static_cast<float>(floor_to_int(within));
        const float of_two = within - 2 * static_cast<float>(floor_to_int(within / 2));
        return std::min(of_two, 2 - of_two);
    }

    /// Returns, for u and for v, 1 if the coordinate runs with the image and -1 if it runs against the image.
    [[nodiscard]] static glm::vec2 mirroring(const glm::vec2& uv) {
        return {floor_to_int(within_int(uv.x)) % 2 == 0 ? 1 : -1,
                floor_to_int(within_int(uv.y)) % 2 == 0 ? 1 : -1};
    }

    /// Returns the mean of of_cell(cell, uv) over the points of a footprint, interpolated between levels.
    template <class Result, class OfCell>
    [[nodiscard]] Result mean_of_taps(const TexturePoint& point, const OfCell& of_cell) const {
        const FootprintTaps taps = footprint_taps(point, shape_);
        const auto level = static_cast<std::size_t>(taps.level);
        Result sum{};
        for (int j = 0; j < taps.rows; ++j)
            for (int k = 0; k < taps.count; ++k) {
                const glm::vec2 uv =
                    taps.first + static_cast<float>(j) * taps.side + static_cast<float>(k) * taps.step;
                const glm::vec2 within = wrapped(uv);
                Result value = of_cell(Cell(*this, levels_[level], within), uv);
                if (taps.fraction > 0)
                    value += taps.fraction * (of_cell(Cell(*this, levels_[level + 1], within), uv) - value);
                sum += value;
            }
        return sum / static_cast<float>(taps.rows * taps.count);
    }

    void mipmap_at_lanes(const TexturePoints& points, std::array<Lanes, 4>& out) const {
        LaneFootprintTaps taps;
        footprint_taps(points, shape_, taps);
        LaneIntegers next;
        for (std::size_t i = 0; i < kLanes; ++i) next[i] = taps.level[i] + 1;
        const int rows = *std::ranges::max_element(taps.rows.value);
        const int most = *std::ranges::max_element(taps.count.value);
        const bool blended = std::ranges::any_of(taps.fraction.value, [](float f) { return f > 0; });
        std::array<Values, kLanes> sums{};
        for (int j = 0; j < rows; ++j)
            for (int k = 0; k < most; ++k) {
                const std::array<Lanes, 2> uv = nicol::wrapped(taps.first, taps.side, j, taps.step, k, wrap_);
                LaneTexels fine, coarse;
                find_texels(uv, shape_.width, shape_.height, taps.level, wrap_, fine);
                if (blended) find_texels(uv, shape_.width, shape_.height, next, wrap_, coarse);
                for (std::size_t i = 0; i < kLanes; ++i) {
                    if (j >= taps.rows[i] || k >= taps.count[i]) continue;
                    const auto level = static_cast<std::size_t>(taps.level[i]);
                    Values value = between(levels_[level].values.data(), fine, i);
                    if (taps.fraction[i] > 0)
                        value = mix(value, between(levels_[level + 1].values.data(), coarse, i),
                                    taps.fraction[i]);
                    sums[i] += value;
                }
            }
        for (std::size_t i = 0; i < kLanes; ++i)
            put(sums[i] / static_cast<float>(taps.rows[i] * taps.count[i]), i, out);
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

    /// Computes mean, range and, if there are few, the distinct values of the whole image.
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
    std::vector<TextureImage> levels_;
    MipmapShape shape_;
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
