// SPDX-License-Identifier: MIT
#include "harmonics/wigner3j.hpp"

#include <algorithm>
#include <tuple>

#include "harmonics/require.hpp"

namespace nicol {
namespace {

/// Recursion l1 A(l1+1) f(l1+1) + B(l1) f(l1) + (l1+1) A(l1) f(l1-1) = 0 (Schulten and Gordon).
class Recursion {
public:
    Recursion(int l2, int l3, int m2, int m3)
        : m1_(-m2 - m3),
          difference_(static_cast<double>(l2 - l3) * (l2 - l3)),
          sum_(static_cast<double>(l2 + l3 + 1) * (l2 + l3 + 1)),
          twist_(static_cast<double>(l2) * (l2 + 1) - static_cast<double>(l3) * (l3 + 1)),
          m_difference_(m3 - m2) {}

    [[nodiscard]] double a(int l) const {
        const double ll = static_cast<double>(l) * l;
        return std::sqrt(
            std::max(0.0, (ll - difference_) * (sum_ - ll) * (ll - static_cast<double>(m1_) * m1_)));
    }
    [[nodiscard]] double b(int l) const {
        return -(2.0 * l + 1) * (twist_ * m1_ - static_cast<double>(l) * (l + 1) * m_difference_);
    }

private:
    int m1_;
    double difference_;
    double sum_;
    double twist_;
    double m_difference_;
};

constexpr double kLarge = 0x1p400;

/// Fills f[0..n) towards higher l until the values stop growing. Returns how many were filled. The values
/// keep their ratios, whatever the scale; ratios too large for double become zero.
std::size_t run(std::vector<double>& f, const auto& next) {
    f[0] = 1;
    std::size_t i = 1;
    for (; i < f.size(); ++i) {
        f[i] = next(i);
        if (std::abs(f[i]) > kLarge)
            for (std::size_t j = 0; j <= i; ++j) f[j] /= kLarge;
        if (i >= 2 && std::abs(f[i]) < std::abs(f[i - 1])) return i + 1;
    }
    return i;
}

}  // namespace

double Wigner3jRun::at(int l1) const {
    const int i = l1 - first_l1;
    return i >= 0 && i < static_cast<int>(value.size()) ? value[static_cast<std::size_t>(i)] : 0;
}

Wigner3jRun wigner_3j_run(int l2, int l3, int m2, int m3) {
    require_order(l2);
    require_order(l3);
    require(std::abs(m2) <= l2 && std::abs(m3) <= l3, "a degree m2 or m3 is larger than its order");
    Wigner3jRun out;
    out.first_l1 = std::max(std::abs(l2 - l3), std::abs(m2 + m3));
    const int last = l2 + l3;
    const auto count = static_cast<std::size_t>(last - out.first_l1 + 1);
    std::vector<double> up(count);
    std::vector<double>& down = out.value;
    down.resize(count);
    const Recursion r(l2, l3, m2, m3);
    const auto order = [&](std::size_t i) { return out.first_l1 + static_cast<int>(i); };
    const std::size_t filled = run(up, [&](std::size_t i) {
        const int l = order(i) - 1;
        // At l = 0 the recursion is 0/0. There l2 = l3 and m2 = -m3, and f(1)/f(0) is known.
        if (l == 0) return m2 / std::sqrt(static_cast<double>(l2) * (l2 + 1));
        const double before = i >= 2 ? (l + 1) * r.a(l) * up[i - 2] : 0;
        return -(r.b(l) * up[i - 1] + before) / (l * r.a(l + 1));
    });
    std::vector<double> backward(count);
    const std::size_t filled_down = run(backward, [&](std::size_t i) {
        const int l = last - static_cast<int>(i) + 1;
        const double before = i >= 2 ? l * r.a(l + 1) * backward[i - 2] : 0;
        return -(r.b(l) * backward[i - 1] + before) / ((l + 1) * r.a(l));
    });
    std::ranges::reverse_copy(backward, down.begin());
    // Between the two ends both directions are stable, so the upward recursion continues until the two meet.
    std::size_t meet = filled;
    const std::size_t low = count - filled_down;
    if (filled < count) {
        for (; meet < count && meet < low + 2; ++meet) {
            const int l = order(meet) - 1;
            up[meet] = -(r.b(l) * up[meet - 1] + (l + 1) * r.a(l) * up[meet - 2]) / (l * r.a(l + 1));
        }
        // Best-fitting ratio where both are known.
        double top = 0;
        double bottom = 0;
        for (std::size_t i = std::max(low, meet >= 3 ? meet - 3 : 0); i < meet; ++i) {
            top += up[i] * down[i];
            bottom += up[i] * up[i];
        }
        const double ratio = bottom > 0 ? top / bottom : 0;
        for (std::size_t i = 0; i + 1 < meet; ++i) down[i] = ratio * up[i];
    } else {
        down = up;
    }
    double square = 0;
    for (std::size_t i = 0; i < count; ++i) square += (2.0 * order(i) + 1) * down[i] * down[i];
    // The sign convention fixes the last value.
    const double sign = (l2 - l3 + m2 + m3) % 2 != 0 ? -1 : 1;
    const double scale = (down[count - 1] < 0 ? -sign : sign) / std::sqrt(square);
    for (double& value : down) value *= scale;
    return out;
}

}  // namespace nicol
