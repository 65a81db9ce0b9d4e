// SPDX-License-Identifier: MIT
// Shared helpers of the PSH function tests.
#pragma once

#include "capi.hpp"
#include "directions.hpp"
#include "harmonics/evaluate.hpp"

namespace capi_test {

using Doubles = std::vector<double>;

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline std::size_t vector_size(std::uint32_t order) {
    return 4 * std::size_t{order + 1} * (order + 1);
}

inline Doubles random_numbers(std::size_t count, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Doubles out(count);
    for (double& x : out) x = uniform(random);
    return out;
}
/// Returns random vectors without a spin-2 part below l = 2. The library and the interface use one layout.
inline nicol::PshVector random_fields(std::uint32_t order, int vectors = 1, unsigned seed = 1) {
    nicol::PshVector fields(static_cast<int>(order), vectors);
    std::ranges::copy(random_numbers(fields.data().size(), seed), fields.data().begin());
    for (int v = 0; v < vectors; ++v)
        for (std::size_t i = 0; i < std::min<std::size_t>(4, fields.channel(v).size() / 4); ++i)
            fields.channel(v)[4 * i + 1] = fields.channel(v)[4 * i + 2] = 0;
    return fields;
}

/// A rotation matrix in row-major order, as in the interface.
using Rotation = std::array<double, 9>;
inline Rotation rows_of(const glm::dmat3& m) {
    return {m[0].x, m[1].x, m[2].x, m[0].y, m[1].y, m[2].y, m[0].z, m[1].z, m[2].z};
}

/// An output buffer that must stay unchanged.
class Untouched {
public:
    explicit Untouched(std::size_t count) : values_(count, -7.5) {}
    ~Untouched() {
        for (const double x : values_) CHECK(x == -7.5);
    }
    Untouched(const Untouched&) = delete;
    Untouched& operator=(const Untouched&) = delete;
    double* data() { return values_.data(); }
    [[nodiscard]] std::size_t size() const { return values_.size(); }

private:
    Doubles values_;
};

inline nicol_psh_transform make_transform(nicol_psh_grid grid, std::uint32_t order, double phi0 = 0) {
    nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
    sampling.grid = grid;
    sampling.order = order;
    sampling.phi0 = phi0;
    return make(nicol_psh_transform_create, &sampling);
}

}  // namespace capi_test
