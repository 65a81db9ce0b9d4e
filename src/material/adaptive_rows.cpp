// SPDX-License-Identifier: MIT
#include "material/adaptive_rows.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace nicol {
namespace {

// Computes the row at `angle` by the cubic through the four nearest of the rows that are `step` apart.
void interpolate(const AngleTable& table, int step, int angle) {
    const int first = std::clamp(angle / step - 1, 0, table.last / step - 3);
    const double x = static_cast<double>(angle) / step - first;
    std::array<const float*, 4> rows{};
    std::array<float, 4> weight{};
    for (int i = 0; i < 4; ++i) {
        double lagrange = 1;
        for (int k = 0; k < 4; ++k) lagrange *= k == i ? 1.0 : (x - k) / (i - k);
        weight[static_cast<std::size_t>(i)] = static_cast<float>(lagrange);
        rows[static_cast<std::size_t>(i)] = table.row((first + i) * step).data();
    }
    const std::span<float> out = table.row(angle);
    for (std::size_t j = 0; j < out.size(); ++j)
        out[j] =
            weight[0] * rows[0][j] + weight[1] * rows[1][j] + weight[2] * rows[2][j] + weight[3] * rows[3][j];
}

// Interpolates the rows between multiples of `from`, at multiples of `to`.
void interpolate_between(const AngleTable& table, int from, int to) {
    tbb::parallel_for(1, table.last / to, [&](int i) {
        if (i * to % from != 0) interpolate(table, from, i * to);
    });
}

bool differ(std::span<const float> a, const float* b, float most) {
    for (std::size_t j = 0; j < a.size(); ++j)
        if (std::abs(a[j] - b[j]) > most) return true;
    return false;
}

}  // namespace

void fill_adaptively(const AngleTable& table,
                     const std::function<void(std::span<const int> angles)>& compute) {
    std::vector<int> angles;
    for (int angle = 0; angle <= table.last; angle += table.widest_step) angles.push_back(angle);
    compute(angles);
    float largest = 0;
    for (const int angle : angles)
        for (const float value : table.row(angle)) largest = std::max(largest, std::abs(value));

    if (largest == 0) {  // the table of a material that reflects nothing
        std::ranges::fill(table.data, 0.0F);
        return;
    }

    // Halving the step makes the error of cubics 16 times smaller.
    const float most = 16 * table.tolerance * largest;
    std::vector<bool> rough(static_cast<std::size_t>(table.last) + 1, true);
    for (int step = table.widest_step / 2; step >= table.least_step; step /= 2) {
        const auto is_rough = [&](int angle) {
            return angle > 0 && angle < table.last && rough[static_cast<std::size_t>(angle)];
        };
        angles.clear();
        for (int angle = step; angle < table.last; angle += 2 * step) {
            const bool compute_it = is_rough(angle - step) || is_rough(angle + step) ||
                                    is_rough(angle - 3 * step) || is_rough(angle + 3 * step);
            if (compute_it) angles.push_back(angle);
        }
        interpolate_between(table, 2 * step, step);
        std::vector<float> predicted;
        predicted.reserve(angles.size() * table.width());
        for (const int angle : angles) {
            const std::span<float> row = table.row(angle);
            predicted.insert(predicted.end(), row.begin(), row.end());
        }
        compute(angles);
        rough.assign(rough.size(), false);
        for (std::size_t i = 0; i < angles.size(); ++i)
            rough[static_cast<std::size_t>(angles[i])] =
                differ(table.row(angles[i]), predicted.data() + i * table.width(), most);
    }
    if (table.least_step > 1) interpolate_between(table, table.least_step, 1);
}

}  // namespace nicol
