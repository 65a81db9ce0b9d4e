// SPDX-License-Identifier: MIT
// Checks that an image is physically realizable (Eq. 70): a fast check that most images pass, and an exact
// check for the others.
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>

#include "light/environment_checks.hpp"

namespace nicol {
namespace {

/// Largest sum of negative pixels, relative to the sum of positive pixels.
constexpr double kLargestNegative = 0.25;

using Floats = float __attribute__((vector_size(16)));
using Ints = int __attribute__((vector_size(16)));

bool any(Ints mask) {
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

/// Check of four pixels at a time against limits stricter than the exact limits, which depend on the largest
/// s0.
class FastCheck {
public:
    explicit FastCheck(const EquirectView& view) : view_(view) {}
    FastCheck(const FastCheck& other, tbb::split) : view_(other.view_) {}

    void operator()(const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y < rows.end(); ++y)
            for (int c = 0; c < view_.channels; ++c) {
                const float* row = view_.values + static_cast<std::size_t>(c) * view_.channel_stride +
                                   static_cast<std::size_t>(y) * view_.row_stride;
                if (view_.components == 4)
                    check_stokes(row);
                else
                    check_s0(row);
            }
    }

    void join(const FastCheck& other) {
        passed_ &= other.passed_;
        linear_ |= other.linear_;
        circular_ |= other.circular_;
        largest_ = larger(largest_, other.largest_);
    }

    /// Returns whether no pixel is negative, infinite, NaN or polarized too much, and no square overflowed.
    [[nodiscard]] bool passed() const {
        float largest = 0;
        for (int i = 0; i < 4; ++i) largest = std::max(largest, largest_[i]);
        return !any(~passed_) && largest > 1e-15F;
    }
    [[nodiscard]] bool linear() const { return any(linear_); }
    [[nodiscard]] bool circular() const { return any(circular_); }

private:
    static Floats larger(Floats a, Floats b) { return a > b ? a : b; }

    void check_stokes(const float* row) {
        const auto width = static_cast<std::size_t>(view_.width);
        for (std::size_t x = 0; x < width; x += 4) {
            Floats pixel[4];
            for (std::size_t k = 0; k < 4; ++k)
                std::memcpy(&pixel[k], row + std::min(x + k, width - 1) * view_.pixel_stride, sizeof(Floats));
            const Floats low_a = __builtin_shufflevector(pixel[0], pixel[1], 0, 4, 1, 5);
            const Floats low_b = __builtin_shufflevector(pixel[2], pixel[3], 0, 4, 1, 5);
            const Floats high_a = __builtin_shufflevector(pixel[0], pixel[1], 2, 6, 3, 7);
            const Floats high_b = __builtin_shufflevector(pixel[2], pixel[3], 2, 6, 3, 7);
            const Floats s0 = __builtin_shufflevector(low_a, low_b, 0, 1, 4, 5);
            const Floats s1 = __builtin_shufflevector(low_a, low_b, 2, 3, 6, 7);
            const Floats s2 = __builtin_shufflevector(high_a, high_b, 0, 1, 4, 5);
            const Floats s3 = __builtin_shufflevector(high_a, high_b, 2, 3, 6, 7);
            passed_ &= (s0 >= 0) & (s0 < 1e18F) & (s1 * s1 + s2 * s2 + s3 * s3 <= 1.02F * (s0 * s0));
            linear_ |= (s1 != 0) | (s2 != 0);
            circular_ |= s3 != 0;
            largest_ = larger(s0, largest_);
        }
    }

    void check_s0(const float* row) {
        for (std::size_t x = 0; x < static_cast<std::size_t>(view_.width); ++x) {
            const float s0 = row[x * view_.pixel_stride];
            passed_[0] &= s0 >= 0 && s0 < 1e18F ? -1 : 0;
            largest_[0] = std::max(largest_[0], s0);
        }
    }

    const EquirectView& view_;
    Ints passed_{-1, -1, -1, -1};
    Ints linear_{}, circular_{};
    Floats largest_{};
};

class ExactCheck {
public:
    ExactCheck(const EquirectView& view, double scale, std::span<const double> row_weights,
               const std::string& name, ErrorCode code)
        : view_(view), scale_(scale), row_weights_(row_weights), name_(name), code_(code) {}

    [[nodiscard]] ImageContents run() {
        for (int c = 0; c < view_.channels; ++c) check_channel(c);
        return contents_;
    }

private:
    struct Pixel {
        int channel, x, y;
    };

    [[nodiscard]] float value(const Pixel& at, std::size_t p) const {
        if (p >= static_cast<std::size_t>(view_.components)) return 0;
        return static_cast<float>(scale_ *
                                  view_.values[static_cast<std::size_t>(at.channel) * view_.channel_stride +
                                               static_cast<std::size_t>(at.y) * view_.row_stride +
                                               static_cast<std::size_t>(at.x) * view_.pixel_stride + p]);
    }

    void check_channel(int channel) {
        float largest = 0;
        float smallest = 0;
        Pixel darkest{channel, 0, 0};
        double negative = 0;
        double positive = 0;
        for (int y = 0; y < view_.height; ++y)
            for (int x = 0; x < view_.width; ++x) {
                const Pixel at{channel, x, y};
                for (std::size_t p = 0; p < 4; ++p)
                    if (!std::isfinite(value(at, p))) refuse(at, "is not finite");
                const float s0 = value(at, 0);
                largest = std::max(largest, s0);
                const double weighted = row_weights_[static_cast<std::size_t>(y)] * s0;
                (s0 < 0 ? negative : positive) += std::abs(weighted);
                if (s0 >= smallest) continue;
                smallest = s0;
                darkest = at;
            }
        for (int y = 0; y < view_.height; ++y)
            for (int x = 0; x < view_.width; ++x) {
                const Pixel at{channel, x, y};
                const double s0 = value(at, 0);
                const double linear = std::hypot(value(at, 1), value(at, 2));
                const double polarized = std::hypot(linear, value(at, 3));
                contents_.linear |= linear > 0;
                contents_.circular |= value(at, 3) != 0;
                if (s0 < 0 && polarized > 0) refuse(at, "has s0 < 0 and is polarized");
                if (polarized > 1.01 * std::max(s0, 0.0) + 1e-3 * largest)
                    refuse(at, "is polarized more than fully: sqrt(s1^2 + s2^2 + s3^2) exceeds s0");
            }
        if (negative > kLargestNegative * positive) refuse_negative(darkest, negative, positive);
        if (negative > 0) contents_.negative = std::max(contents_.negative, negative / positive);
    }

    [[noreturn]] void refuse_negative(const Pixel& darkest, double negative, double positive) const {
        std::string share = "all of it";
        if (positive > 0) {
            char text[64];
            (void)std::snprintf(text, sizeof text, "%.3g %% of the positive", 100 * negative / positive);
            share = text;
        }
        refuse(darkest, "has s0 < 0, as has much of the channel (" + share +
                            "); radiance cannot be negative, and only up to 25 % is attributed to "
                            "compression and set to 0");
    }

    [[noreturn]] void refuse(const Pixel& at, const std::string& what) const {
        throw Error(code_, name_ + ": channel " + std::to_string(at.channel) + ", pixel (" +
                               std::to_string(at.x) + ", " + std::to_string(at.y) + ") " + what);
    }

    const EquirectView& view_;
    double scale_;
    std::span<const double> row_weights_;
    const std::string& name_;
    ErrorCode code_;
    ImageContents contents_;
};

}  // namespace

ImageContents examine_image(const EquirectView& view, double scale, std::span<const double> row_weights,
                            const std::string& name, ErrorCode code) {
    // Beyond these scales the limits of the fast check leave the range of float.
    if (scale > 1e-15 && scale < 1e15) {
        FastCheck fast(view);
        tbb::parallel_reduce(tbb::blocked_range<int>(0, view.height), fast);
        if (fast.passed()) return {fast.linear(), fast.circular(), false};
    }
    return ExactCheck(view, scale, row_weights, name, code).run();
}

ImageContents examine_equirect(const EquirectView& view, double scale, const std::string& name,
                               ErrorCode code) {
    if (view.width < 2 || view.height < 2)
        throw Error(code, name + ": " + std::to_string(view.width) + " x " + std::to_string(view.height) +
                              " pixels; an environment needs at least 2 x 2");
    std::vector<double> weights;
    weights.reserve(static_cast<std::size_t>(view.height));
    for (int y = 0; y < view.height; ++y)
        weights.push_back(std::sin(std::numbers::pi * y / (view.height - 1)));
    return examine_image(view, scale, weights, name, code);
}

}  // namespace nicol
