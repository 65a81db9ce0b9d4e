// SPDX-License-Identifier: MIT
#include "material/texture_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nicol {
namespace {

// Most values of a texture that are returned as they are.
constexpr std::size_t kMostValues = 16;
// Places along each side of the texture at which its values are sampled.
constexpr int kSide = 96;
// Candidates for numbers lie so many to a step of the given ratio.
constexpr int kFineness = 4;
// Largest steps, in candidates: 1.75 steps of the ratio where the texture has values, 2 where it has none.
constexpr int kWidest = 7;
constexpr int kWidestEmpty = 8;
// Mean of (4 u (1 - u))^2 for u of 0 to 1: the square error of linear interpolation at evenly spread values,
// relative to the largest.
constexpr double kMeanSquare = 8.0 / 15;

// Returns the first channel at places that are spread evenly, ascending.
std::vector<double> sampled(const Texture& texture) {
    std::vector<double> out;
    out.reserve(std::size_t{kSide} * kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            // Rows are shifted, so that a pattern along an axis is met at all of its phases.
            const float u = (static_cast<float>(x) + (static_cast<float>(y) + 0.5F) / kSide) / kSide;
            const float v = (static_cast<float>(y) + 0.5F) / kSide;
            out.push_back(static_cast<double>(texture.at({.uv = {u, v}}).x));
        }
    std::ranges::sort(out);
    return out;
}

// Returns numbers in even steps of the logarithm.
std::vector<double> even(double low, double high, int steps) {
    std::vector<double> out;
    out.reserve(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i < steps; ++i) out.push_back(low * std::pow(high / low, i / static_cast<double>(steps)));
    out.push_back(high);
    return out;
}

/// Sums over the samples between neighbouring candidates, from which the square error between any two
/// candidates follows: positions in steps from the first candidate, and their powers.
class Samples {
public:
    Samples(std::span<const double> values, std::span<const double> candidates) : sums_(candidates.size()) {
        const double low = std::log(candidates.front());
        const double scale = static_cast<double>(candidates.size() - 1) / (std::log(candidates.back()) - low);
        for (const double value : values) {
            const double x =
                std::clamp((std::log(value) - low) * scale, 0.0, static_cast<double>(candidates.size() - 1));
            const auto from = std::min(static_cast<std::size_t>(x), candidates.size() - 2);
            double power = 1;
            for (double& sum : sums_[from + 1]) {
                sum += power;
                power *= x;
            }
        }
        for (std::size_t i = 1; i < sums_.size(); ++i)
            for (std::size_t p = 0; p < 5; ++p) sums_[i][p] += sums_[i - 1][p];
    }

    [[nodiscard]] double count(std::size_t a, std::size_t b) const { return sums_[b][0] - sums_[a][0]; }

    // Returns the sum of the square errors of samples between candidates a and b, relative to that half-way
    // between numbers of the given ratio: of (4 (x - a) (b - x) / kFineness^2)^2.
    [[nodiscard]] double error(std::size_t a, std::size_t b) const {
        const auto p = static_cast<double>(a), q = static_cast<double>(b);
        const double s = p + q, m = p * q;  // (x - p) (q - x) = -x^2 + s x - m
        const std::array<double, 5> factors{m * m, -2 * s * m, s * s + 2 * m, -2 * s, 1};
        double sum = 0;
        for (std::size_t i = 0; i < 5; ++i) sum += factors[i] * (sums_[b][i] - sums_[a][i]);
        constexpr double step = 4.0 / (kFineness * kFineness);
        return std::max(sum, 0.0) * step * step;
    }

private:
    std::vector<std::array<double, 5>> sums_;  // of all samples before each candidate
};

// Returns the fewest candidates, the first and the last among them, whose sum of square errors is `allowed`
// at most.
std::vector<double> fewest(std::span<const double> candidates, const Samples& samples, double allowed) {
    const std::size_t n = candidates.size();
    constexpr double never = std::numeric_limits<double>::infinity();
    // least[i]: least error of numbers up to candidate i; before[k][i]: number before, if i is number k.
    std::vector<double> least(n, never);
    least[0] = 0;
    std::vector<std::vector<std::size_t>> before;
    while (!(least[n - 1] <= allowed) && before.size() < n) {
        std::vector<double> next(n, never);
        std::vector<std::size_t>& from = before.emplace_back(n, 0);
        for (std::size_t b = 1; b < n; ++b)
            for (std::size_t a = b - std::min<std::size_t>(b, kWidestEmpty); a < b; ++a) {
                if (b - a > kWidest && samples.count(a, b) > 0) continue;
                const double error = least[a] + samples.error(a, b);
                if (!(error < next[b])) continue;
                next[b] = error;
                from[b] = a;
            }
        least = std::move(next);
    }
    std::vector<double> out{candidates[n - 1]};
    std::size_t at = n - 1;
    for (std::size_t k = before.size(); k > 0; --k) {
        at = before[k - 1][at];
        out.push_back(candidates[at]);
    }
    std::ranges::reverse(out);
    return out;
}

}  // namespace

std::vector<double> texture_numbers(const Texture& texture, double least, double ratio,
                                    std::optional<std::size_t> most) {
    const auto inside = [least](double value) { return std::clamp(value, least, 1.0); };
    std::vector<double> out;
    for (const float value : texture.values()) out.push_back(inside(static_cast<double>(value)));
    if (out.empty() || out.size() > most.value_or(kMostValues)) {
        const double low = inside(static_cast<double>(texture.range().x));
        const double high = inside(static_cast<double>(texture.range().y));
        const int steps = static_cast<int>(std::ceil(std::log(high / low) / std::log(ratio)));
        out = even(low, high, steps);
        if (steps > 2 && !needs_colors(texture)) {
            std::vector<double> values = sampled(texture);
            for (double& value : values) value = inside(value);
            const std::vector<double> candidates = even(low, high, kFineness * steps);
            out = fewest(candidates, Samples(values, candidates),
                         kMeanSquare * static_cast<double>(values.size()));
        }
        if (most && out.size() > *most) out = even(low, high, static_cast<int>(*most) - 1);
    }
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

}  // namespace nicol
