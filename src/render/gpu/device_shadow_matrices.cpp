// SPDX-License-Identifier: MIT
#include "render/gpu/device_shadow_matrices.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "gl/draw.hpp"
#include "render/gpu/sparse_rows.hpp"
#include "simd/lane_vector.hpp"
#include "visibility/shadow_matrix_kernel.hpp"

namespace nicol {
namespace {

// For each row of split light: where its numbers begin, the step from one to the next, how many columns it
// has and the first of them in split light. Matrices lie in tiles of a few rows, column after column.
std::vector<std::array<std::int32_t, 4>> matrix_rows(const MirrorBasis& basis) {
    std::vector<std::array<std::int32_t, 4>> rows(basis.size());
    std::size_t number = 0;
    const auto add = [&](std::size_t size, std::initializer_list<std::size_t> begins) {
        for (std::size_t row = 0; row < size; ++row) {
            const std::size_t tile = row / kShadowTile * kShadowTile;
            const std::size_t step = std::min(kShadowTile, size - tile);
            for (const std::size_t begin : begins) {
                rows[begin + row] = {static_cast<std::int32_t>(number + tile * size + row - tile),
                                     static_cast<std::int32_t>(step), static_cast<std::int32_t>(size),
                                     static_cast<std::int32_t>(begin)};
            }
        }
        number += size * size;
    };
    const std::size_t even = basis.even().size();
    const std::size_t odd = basis.odd().size();
    const std::size_t spin = basis.spin().size();
    const std::size_t s3 = basis.s3_begin();
    if (basis.kind() == LightKind::full) {
        add(even, {0, s3});
        add(odd, {even, s3 + even});
    } else {
        add(even, {0});
        add(odd, {even});
    }
    add(spin, {basis.spin_begin(), basis.spin_begin() + spin});
    return rows;
}

}  // namespace

DeviceShadowMatrices::DeviceShadowMatrices(const std::shared_ptr<gl::Context>& context,
                                           const VisibilityProduct::Matrices& matrices)
    : context_(context),
      multiply_(gl::Program::compute(context, "shadow_multiply.comp")),
      join_(gl::Program::compute(context, "shadow_join.comp")),
      size_(matrices.basis.size()),
      numbers_(context, matrices.vertices, matrices.numbers, matrices.numbers_of_vertex),
      split_terms_(split_rows(context, matrices.basis)),
      join_terms_(join_rows(context, matrices.basis)),
      rows_(storage(context, matrix_rows(matrices.basis))) {
    multiply_.set("numbers_of_block", static_cast<int>(matrices.numbers_of_vertex));
    multiply_.set("scale", matrices.unit / kFixedOne);
}

void DeviceShadowMatrices::run(DeviceLight& light) {
    const std::size_t bytes = size_ * light.stride() * sizeof(float);
    if (!work_ || work_->size() < bytes) {
        work_.reset();
        work_.emplace(context_, gl::BufferUse::storage, bytes, gl::BufferUpdate::fixed);
    }
    const auto multiply = [&](std::size_t first, std::size_t last, std::size_t first_block,
                              const gl::Buffer& numbers) {
        for (gl::Program* program : {&multiply_, &join_}) {
            program->set("first", static_cast<int>(first));
            program->set("count", static_cast<int>(last - first));
            program->set("first_vertex", static_cast<int>(light.first()));
            program->set("stride", static_cast<int>(light.stride()));
        }
        multiply_.set("first_block", static_cast<int>(first_block));
        join_.set("product_stride", static_cast<int>(light.stride()));
        numbers_.vertices().bind_storage(0);
        for (int c = 0; c < light.channels(); ++c) {
            numbers.bind_storage(1);
            light.bind(2, c);
            split_terms_.bind_storage(3);
            rows_.bind_storage(4);
            work_->bind_storage(5, 0, bytes);
            gl::dispatch(multiply_, groups_for(last - first), static_cast<unsigned>(size_));
            work_->bind_storage(1, 0, bytes);
            join_terms_.bind_storage(3);
            gl::dispatch(join_, groups_for(last - first), static_cast<unsigned>(light.numbers()));
        }
    };
    numbers_.for_chunks(light, light.count(), multiply);
}

}  // namespace nicol
