// SPDX-License-Identifier: MIT
// Tests of mipmaps against means over pixel footprints.
#include "texture/footprint.hpp"

#include <glm/geometric.hpp>

#include "test.hpp"

using namespace nicol;
using Filter = TextureSampling::Filter;
using Wrap = TextureSampling::Wrap;

namespace {

constexpr int kSide = 64;

/// Returns waves of 9 texels and more in several directions, with standard deviation 1.
TextureImage waves() {
    TextureImage image{.width = kSide, .height = kSide, .channels = 1};
    constexpr int crests[6][2] = {{7, 0}, {0, 7}, {3, 3}, {-4, 5}, {6, 2}, {-2, 3}};
    for (int i = 0; i < kSide * kSide; ++i) {
        float sum = 0;
        for (const auto& [x, y] : crests)
            sum += std::sin(glm::radians(360.0F) * static_cast<float>(x * (i % kSide) + y * (i / kSide)) /
                                kSide +
                            static_cast<float>(x));
        image.values.push_back(sum / std::sqrt(3.0F));
    }
    return image;
}

glm::vec2 rotated(const glm::vec2& v, float angle) {
    return {std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y};
}

/// Returns a pixel footprint in texels: a rectangle, or a parallelogram of equal second moments, whose longer
/// axis has this angle.
TexturePoint covering(const glm::vec2& uv, float shorter, float ratio, float angle, float shear) {
    const auto side = [&](float a) {
        return rotated({shorter * ratio * std::cos(a), shorter * std::sin(a)}, angle) / float{kSide};
    };
    return {.uv = uv, .du = side(shear), .dv = side(shear + glm::radians(90.0F))};
}

/// Returns the mean of value(point) over the parallelogram.
template <class Value>
auto mean(const TexturePoint& over, const Value& value) {
    constexpr int count = 32;
    decltype(value(over)) sum(0);
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            const float x = (static_cast<float>(i) + 0.5F) / count - 0.5F;
            const float y = (static_cast<float>(j) + 0.5F) / count - 0.5F;
            sum += value({.uv = over.uv + x * over.du + y * over.dv});
        }
    return sum / float{count * count};
}

MipmapShape shape(int last_level = 6) {
    return {.width = kSide, .height = kSide, .last_level = last_level, .to_uv = UvTransform(glm::dmat3(1))};
}

}  // namespace

TEST_CASE("a mipmap's value and slope are the means over the footprint, however stretched") {
    const TextureImage image = waves();
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror}) {
        const TexturePtr fine = image_texture(image, {.wrap = wrap});
        const TexturePtr mipmap = image_texture(image, {.filter = Filter::mipmap, .wrap = wrap});
        for (const float shorter : {0.4F, 1.0F, 2.3F})
            for (const float ratio : {1.0F, 2.0F, 4.0F, 10.0F})
                for (const float angle : {0.0F, 0.5F, 2.0F}) {
                    CAPTURES(shorter, ratio, angle);
                    std::mt19937 random(5);
                    std::uniform_real_distribution<float> place(-1, 2);
                    float error = 0, slope_error = 0;
                    constexpr int points = 40;
                    for (int i = 0; i < points; ++i) {
                        const float u = place(random), v = place(random), shear = place(random);
                        const TexturePoint point = covering({u, v}, shorter, ratio, angle, shear);
                        const float value = mean(point, [&](const TexturePoint& p) { return fine->at(p).x; });
                        const glm::vec2 slope =
                            mean(point, [&](const TexturePoint& p) { return fine->gradient(p); });
                        const float wrong = mipmap->at(point).x - value;
                        const glm::vec2 wrong_slope = mipmap->gradient(point) - slope;
                        error += wrong * wrong / points;
                        slope_error += glm::dot(wrong_slope, wrong_slope) / points;
                    }
                    CHECK(std::sqrt(error) < (ratio < 4 ? 0.02F : 0.09F));
                    // Typical slopes are 35.
                    CHECK(std::sqrt(slope_error) < (ratio > 8 ? 8 : 4.5F));
                }
    }
}

TEST_CASE("as many places as a footprint is stretched have its second moments") {
    const struct {
        float shorter, ratio;
        int rows, count;
    } cases[] = {{0.3F, 1, 1, 1}, {0.4F, 1, 2, 2},  {1, 1, 2, 2},        {6, 1.2F, 2, 2},  {6, 1.3F, 2, 3},
                 {4, 4, 2, 8},    {2, 7.9F, 2, 16}, {2, 8.1F, 1, 8},     {0.1F, 10, 1, 2}, {0.1F, 40, 1, 8},
                 {1, 16, 1, 16},  {2, 100, 1, 16},  {1e-3F, 1e4F, 1, 16}};
    for (const auto& row : cases)
        for (const float angle : {0.0F, 0.3F, 1.6F, 2.5F})
            for (const float shear : {0.0F, 0.7F}) {
                CAPTURES(row.shorter, row.ratio, angle, shear);
                const glm::vec2 uv(0.3F, 0.7F);
                const FootprintTaps taps =
                    footprint_taps(covering(uv, row.shorter, row.ratio, angle, shear), shape());
                CHECK(taps.count == row.count);
                CHECK(taps.rows == row.rows);
                const auto n = static_cast<float>(taps.count), rows = static_cast<float>(taps.rows);
                CHECK(glm::distance(taps.first + 0.5F * (n - 1) * taps.step + 0.5F * (rows - 1) * taps.side,
                                    uv) < 1e-6F);
                const float longer = row.shorter * row.ratio, shorter = std::max(row.shorter, longer / 16);
                const float width = shorter / rows;
                // The longer axis of a square is arbitrary.
                const float turned = row.ratio > 1 ? angle : std::atan2(taps.step.y, taps.step.x);
                const glm::vec2 step = float{kSide} * rotated(taps.step, -turned);
                const glm::vec2 side = float{kSide} * rotated(taps.side, -turned);
                CHECK(std::abs(step.y) < 1e-3F * (std::abs(step.x) + row.shorter));
                CHECK(std::abs(side.x) < 1e-3F * (std::abs(side.y) + row.shorter));
                const float along = n > 1 ? longer * longer - width * width : 0;
                CHECK((n * n - 1) * step.x * step.x == doctest::Approx(along).epsilon(1e-2));
                CHECK(std::abs(side.y) == doctest::Approx(rows > 1 ? width : 0).epsilon(1e-3));
                const float squared =
                    n > rows ? width * width : 0.5F * (longer * longer + shorter * shorter) / (rows * rows);
                const float expected = std::max(0.5F * std::log2(0.875F + 0.5F * squared), 0.0F);
                CHECK(std::abs(static_cast<float>(taps.level) + taps.fraction - expected) < 0.01F);
            }
}

TEST_CASE("a footprint without bounds takes the last level") {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    for (const float far : {1e12F, 1e38F, infinite, -infinite, std::nanf("")})
        for (const TexturePoint& point : {TexturePoint{.uv = {}, .du = {far, far}, .dv = {-far, far}},
                                          TexturePoint{.uv = {}, .du = {far, 1}},
                                          TexturePoint{.uv = {}, .du = {0, 0}, .dv = {-far, far}}}) {
            CAPTURE(far);
            const FootprintTaps taps = footprint_taps(point, shape(5));
            CHECK(taps.level == 5);
            CHECK(taps.fraction == 0);
            CHECK(taps.count >= 1);
            CHECK(taps.count <= 16);
            for (const glm::vec2& place : {taps.first, taps.step, taps.side}) {
                CHECK(std::isfinite(place.x));
                CHECK(std::isfinite(place.y));
            }
        }
}
