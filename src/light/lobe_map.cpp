// SPDX-License-Identifier: MIT
#include "light/lobe_map.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "nicol/error.hpp"
#include "nicol/transform.hpp"

namespace nicol {
namespace {

constexpr double pi = std::numbers::pi;

// The filtered light up to its last order that matters.
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

// Rows at which bilinear interpolation of sharpened texels misses the tolerance times the RMS: a wave of
// degree l on texels h apart is missed by 0.04 (l h)^2.
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
    // As many columns as transform fast: powers of two, or three times these.
    for (int base = steps; base < LobeMap::kMostRows - 1 && steps * spacing < pi; base *= 2) {
        steps = base + base / 2;
        if (steps * spacing < pi) steps = 2 * base;
    }
    return steps + 1;
}

// Interpolation blurs a wave of degree l by about (l h)^2 / 12.
void sharpen(PshVector& field, double spacing) {
    std::vector<double> gains;
    for (int l = 0; l <= field.order(); ++l) gains.push_back(1 + l * (l + 1) * spacing * spacing / 12);
    scale_orders(field, gains);
}

// The angle of (x, y) within a few roundings, 0 where both are 0. The C library's is a third of a look-up.
float angle_of(float y, float x) {
    constexpr auto quarter = static_cast<float>(pi / 2);
    const float across = std::abs(x);
    const float along = std::abs(y);
    const float large = std::max(across, along);
    const float ratio = large > 0 ? std::min(across, along) / large : 0.0F;
    // At most tan(pi/8): the fit of atan(t) / t in t^2 is then good to 2e-8.
    const bool beyond = ratio > 0.41421356F;
    const float t = beyond ? (ratio - 1) / (ratio + 1) : ratio;
    const float z = t * t;
    float angle =
        t * (0.99999998F + z * (-0.33332786F + z * (0.19974082F + z * (-0.13848490F + z * 0.07976292F))));
    if (beyond) angle += quarter / 2;
    if (along > across) angle = quarter - angle;
    if (x < 0) angle = 2 * quarter - angle;
    return y < 0 ? -angle : angle;
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
    texels_.resize(static_cast<std::size_t>(layers()) * layer_size());

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
    const std::size_t count = samples.size() / (4 * width);
    for (std::size_t j = 0; j < count; ++j) {
        const auto row = static_cast<std::size_t>(first_row) + j;
        const double theta = pi * static_cast<double>(row) / (rows_ - 1);
        const double cosine = std::cos(theta);
        const double sine = std::sin(theta);
        for (std::size_t i = 0; i < width; ++i) {
            const double* s = &samples[4 * (j * width + i)];
            const std::size_t texel = 4 * (row * width + i);
            if (!polarized_) {
                const auto layer = static_cast<std::size_t>(channel / 4) * layer_size();
                texels_[layer + texel + static_cast<std::size_t>(channel % 4)] = static_cast<float>(s[0]);
                continue;
            }
            const glm::dvec2& azimuth = azimuths[i];
            const glm::dvec3 x(cosine * azimuth[0], cosine * azimuth[1], -sine);
            const glm::dvec3 y(-azimuth[1], azimuth[0], 0);
            const auto tensor = [&](int a, int b) {
                return static_cast<float>(s[1] * (x[a] * x[b] - y[a] * y[b]) +
                                          s[2] * (x[a] * y[b] + y[a] * x[b]));
            };
            float* first = &texels_[static_cast<std::size_t>(2 * channel) * layer_size() + texel];
            float* second = first + layer_size();
            first[0] = static_cast<float>(s[0]);
            first[1] = static_cast<float>(s[3]);
            first[2] = tensor(0, 0);
            first[3] = tensor(1, 1);
            second[0] = tensor(0, 1);
            second[1] = tensor(0, 2);
            second[2] = tensor(1, 2);
        }
    }
}

void LobeMap::look_up(const glm::vec3& d, const glm::vec3& x, std::span<glm::vec4> out) const {
    constexpr auto turn = static_cast<float>(2 * pi);
    const float rho = std::sqrt(d.x * d.x + d.y * d.y);
    const float azimuth = angle_of(d.y, d.x);
    const float u = (azimuth < 0 ? azimuth + turn : azimuth) / turn * static_cast<float>(columns());
    const float v = angle_of(rho, d.z) / static_cast<float>(pi) * static_cast<float>(rows_ - 1);
    const auto width = static_cast<std::size_t>(columns());
    const std::size_t left = std::min(static_cast<std::size_t>(u), width - 1);
    const std::size_t right = left + 1 == width ? 0 : left + 1;
    const std::size_t top = std::min(static_cast<std::size_t>(v), static_cast<std::size_t>(rows_ - 2));
    const float a = u - static_cast<float>(left);
    const float b = v - static_cast<float>(top);
    const std::size_t corner[4] = {4 * (top * width + left), 4 * (top * width + right),
                                   4 * ((top + 1) * width + left), 4 * ((top + 1) * width + right)};
    const float weight[4] = {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
    const auto texel = [&](int layer) {
        const float* at = texels_.data() + static_cast<std::size_t>(layer) * layer_size();
        glm::vec4 sum(0.0F);
        for (int i = 0; i < 4; ++i) {
            const float* t = at + corner[i];
            sum += weight[i] * glm::vec4(t[0], t[1], t[2], t[3]);
        }
        return sum;
    };
    if (!polarized_) {
        for (int layer = 0; layer < layers(); ++layer) {
            const glm::vec4 s0 = texel(layer);
            for (int i = 0; i < 4 && 4 * layer + i < channels_; ++i)
                out[static_cast<std::size_t>(4 * layer + i)] = {s0[i], 0, 0, 0};
        }
        return;
    }
    const glm::vec3 y(d.y * x.z - d.z * x.y, d.z * x.x - d.x * x.z, d.x * x.y - d.y * x.x);
    for (int c = 0; c < channels_; ++c) {
        const glm::vec4 p = texel(2 * c);
        const glm::vec4 q = texel(2 * c + 1);
        const auto apply = [&](const glm::vec3& w) {
            return glm::vec3(p[2] * w.x + q[0] * w.y + q[1] * w.z, q[0] * w.x + p[3] * w.y + q[2] * w.z,
                             q[1] * w.x + q[2] * w.y - (p[2] + p[3]) * w.z);
        };
        const glm::vec3 tx = apply(x);
        const glm::vec3 ty = apply(y);
        out[static_cast<std::size_t>(c)] = {
            p[0], (x.x * tx.x + x.y * tx.y + x.z * tx.z - (y.x * ty.x + y.y * ty.y + y.z * ty.z)) / 2,
            x.x * ty.x + x.y * ty.y + x.z * ty.z, p[1]};
    }
}

}  // namespace nicol
