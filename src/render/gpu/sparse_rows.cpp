// SPDX-License-Identifier: MIT
#include "render/gpu/sparse_rows.hpp"

#include <cstdint>
#include <functional>
#include <vector>

#include "render/gpu/device_light.hpp"

namespace nicol {
namespace {

// As in glsl/sparse.glsl.
struct SparseRow {
    std::int32_t first = 0;
    std::int32_t second = 0;
    float first_factor = 0;
    float second_factor = 0;
};

using LinearMap = std::function<void(const float* in, float* out)>;

// A linear map as rows, found by asking what it makes of each number.
gl::Buffer rows_of(const std::shared_ptr<gl::Context>& context, std::size_t size_in, std::size_t size_out,
                   const LinearMap& map) {
    std::vector<SparseRow> rows(size_out);
    std::vector<float> in(size_in);
    std::vector<float> out(size_out);
    for (std::size_t i = 0; i < size_in; ++i) {
        in[i] = 1;
        map(in.data(), out.data());
        in[i] = 0;
        for (std::size_t row = 0; row < size_out; ++row) {
            const float factor = out[row];
            if (factor == 0) continue;
            const auto from = static_cast<std::int32_t>(i);
            SparseRow& sparse = rows[row];
            if (sparse.first_factor == 0) {
                sparse.first = from;
                sparse.first_factor = factor;
            } else {
                sparse.second = from;
                sparse.second_factor = factor;
            }
        }
    }
    return storage(context, rows);
}

}  // namespace

gl::Buffer split_rows(const std::shared_ptr<gl::Context>& context, const MirrorBasis& basis) {
    return rows_of(context, basis.packed_size(), basis.size(),
                   [&](const float* in, float* out) { basis.split(in, out); });
}

gl::Buffer join_rows(const std::shared_ptr<gl::Context>& context, const MirrorBasis& basis) {
    return rows_of(context, basis.size(), basis.packed_size(),
                   [&](const float* in, float* out) { basis.join(in, out); });
}

}  // namespace nicol
