// SPDX-License-Identifier: MIT
#include "specular/lobe_map.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

#include "error.hpp"
#include "harmonics/transform.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Returns the filtered light up to its last significant order.
PshVector filtered(const PshVector& light, std::span<const double> gains) {
    double largest = 0;
    for (const double gain : gains) {
        if (!std::isfinite(gain)) throw Error(ErrorCode::invalid_argument, "a gain of a lobe is not finite");
        largest = std::max(largest, std::abs(gain));
    }
    int order = std::min(light.order(), static_cast<int>(gains.size()) - 1);
    while (order > 0 && std::abs(gains[static_cast<std::size_t>(order)]) <= 1e-6 * largest) --order;
    PshVector out = with_order(light, order);
    scale_orders(out, gains.first(static_cast<std::size_t>(order) + 1));
    return out;
}

// Returns the number of rows at which bilinear interpolation of sharpened texels errs by the tolerance times
// the RMS: the error for a wave of degree l on texels h apart is 0.04 (l h)^2.
int rows_for(const PshVector& field, double tolerance) {
    double power = 0;
    double bent = 0;
    for (int c = 0; c < field.channels(); ++c) {
        const std::span<const double> f = field.channel(c);
        std::size_t i = 0;
        for (int l = 0; l <= field.order(); ++l) {
            double of_order = 0;
            for (; i < 4 * psh_count(l); ++i) of_order += f[i] * f[i];
            power += of_order;
            bent += of_order * std::pow(l, 4);
        }
    }
    int steps = LobeMap::kLeastRows - 1;
    if (power == 0) return steps + 1;
    const double spacing = std::sqrt(tolerance / (0.04 * std::sqrt(bent / power)));
    // Column counts are powers of two, or three times these, because their transforms are fast.
    for (int base = steps; base < LobeMap::kMostRows - 1 && steps * spacing < pi; base *= 2) {
        steps = base + base / 2;
        if (steps * spacing < pi) steps = 2 * base;
    }
    return steps + 1;
}

// Sharpens the field, because interpolation attenuates a wave of degree l by about (l h)^2 / 12.
void sharpen(PshVector& field, double spacing) {
    std::vector<double> gains;
    for (int l = 0; l <= field.order(); ++l) gains.push_back(1 + l * (l + 1) * spacing * spacing / 12);
    scale_orders(field, gains);
}

}  // namespace

LobeMap::LobeMap(const PshVector& light, std::span<const double> gains, bool polarized, double tolerance)
    : channels_(light.channels()), polarized_(polarized) {
    if (gains.empty()) throw Error(ErrorCode::invalid_argument, "a lobe without gains");
    if (!(tolerance > 0)) throw Error(ErrorCode::invalid_argument, "the tolerance of a map must be above 0");
    PshVector field = filtered(light, gains);
    if (!polarized) {
        const std::span<double> f = field.data();
        for (std::size_t i = 0; i < f.size(); ++i)
            if (i % 4 != 0) f[i] = 0;
    }
    rows_ = rows_for(field, tolerance);
    sharpen(field, pi / (rows_ - 1));
    texels_.resize(4 * static_cast<std::size_t>(layers()) * static_cast<std::size_t>(rows_) *
                   (static_cast<std::size_t>(columns()) + 1));

    const int order = field.order();
    constexpr int block = 8;
    LegendreTransform legendre(order, clenshaw_curtis_rows(rows_));
    FourierRows rows(order, rows_);
    struct Work {
        FourierTransform transform;
        std::vector<double> samples;
    };
    tbb::enumerable_thread_specific<Work> work([&] {
        return Work{FourierTransform(order, columns()),
                    std::vector<double>(4 * block * static_cast<std::size_t>(columns()))};
    });
    std::vector<glm::dvec2> azimuths;
    for (int i = 0; i < columns(); ++i) {
        const double phi = 2 * pi * i / columns();
        azimuths.emplace_back(std::cos(phi), std::sin(phi));
    }
    for (int c = 0; c < channels_; ++c) {
        legendre.synthesize(field.channel(c), rows);
        tbb::parallel_for(0, (rows_ + block - 1) / block, [&](int b) {
            Work& local = work.local();
            const int count = std::min(block, rows_ - b * block);
            const auto samples =
                std::span(local.samples)
                    .first(4 * static_cast<std::size_t>(count) * static_cast<std::size_t>(columns()));
            local.transform.synthesize(rows, b * block, samples);
            store(c, b * block, samples, azimuths);
        });
    }
}

void LobeMap::store(int channel, int first_row, std::span<const double> samples,
                    std::span<const glm::dvec2> azimuths) {
    const auto width = static_cast<std::size_t>(columns());
    const std::size_t size = 4 * static_cast<std::size_t>(layers());
    const std::size_t count = samples.size() / (4 * width);
    for (std::size_t j = 0; j < count; ++j) {
        const auto row = static_cast<std::size_t>(first_row) + j;
        const double theta = pi * static_cast<double>(row) / (rows_ - 1);
        const double cosine = std::cos(theta);
        const double sine = std::sin(theta);
        for (std::size_t i = 0; i <= width; ++i) {
            const double* s = &samples[4 * (j * width + i % width)];
            float* const texel = &texels_[size * (row * (width + 1) + i)];
            if (!polarized_) {
                texel[channel] = static_cast<float>(s[0]);
                continue;
            }
            const glm::dvec2& azimuth = azimuths[i % width];
            const glm::dvec3 x(cosine * azimuth[0], cosine * azimuth[1], -sine);
            const glm::dvec3 y(-azimuth[1], azimuth[0], 0);
            const auto tensor = [&](int a, int b) {
                return static_cast<float>(s[1] * (x[a] * x[b] - y[a] * y[b]) +
                                          s[2] * (x[a] * y[b] + y[a] * x[b]));
            };
            float* const own = texel + 8 * channel;
            own[0] = static_cast<float>(s[0]);
            own[1] = static_cast<float>(s[3]);
            own[2] = tensor(0, 0);
            own[3] = tensor(1, 1);
            own[4] = tensor(0, 1);
            own[5] = tensor(0, 2);
            own[6] = tensor(1, 2);
        }
    }
}

std::vector<float> LobeMap::layers_apart(int first, int count) const {
    const auto width = static_cast<std::size_t>(columns());
    const auto all = static_cast<std::size_t>(layers());
    std::vector<float> out;
    out.reserve(4 * static_cast<std::size_t>(count) * static_cast<std::size_t>(rows_) * width);
    for (auto layer = static_cast<std::size_t>(first); layer < static_cast<std::size_t>(first + count);
         ++layer) {
        for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
            for (std::size_t i = 0; i < width; ++i) {
                const float* const texel = &texels_[4 * ((row * (width + 1) + i) * all + layer)];
                out.insert(out.end(), texel, texel + 4);
            }
        }
    }
    return out;
}

}  // namespace nicol
