// SPDX-License-Identifier: MIT
#include "render/compute/device_shadows.hpp"

#include <array>
#include <functional>

#include "gl/draw.hpp"
#include "transfer/lane_vector.hpp"
#include "transfer/shadow_matrix_kernel.hpp"

namespace nicol {
namespace {

// As in glsl/sparse.glsl.
struct SparseRow {
    std::int32_t first = 0;
    std::int32_t second = 0;
    float first_factor = 0;
    float second_factor = 0;
};

using LaneMap = std::function<void(const Lanes* in, Lanes* out)>;

// A linear map as rows, found by asking what it makes of each number.
std::vector<SparseRow> rows_of(std::size_t size_in, std::size_t size_out, const LaneMap& map) {
    std::vector<SparseRow> rows(size_out);
    std::vector<Lanes> in(size_in);
    std::vector<Lanes> out(size_out);
    for (std::size_t i = 0; i < size_in; ++i) {
        in[i][0] = 1;
        map(in.data(), out.data());
        in[i][0] = 0;
        for (std::size_t row = 0; row < size_out; ++row) {
            const float factor = out[row][0];
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
    return rows;
}

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

template <class Element>
gl::Buffer storage(const std::shared_ptr<gl::Context>& context, std::span<const Element> elements) {
    return {context, gl::BufferUse::storage, std::as_bytes(elements)};
}

}  // namespace

DeviceShadows::DeviceShadows(const std::shared_ptr<gl::Context>& context,
                             const ShadowProduct::Matrices& matrices)
    : context_(context),
      multiply_(gl::Program::compute(context, "shadow_multiply.comp")),
      join_(gl::Program::compute(context, "shadow_join.comp")),
      size_(matrices.basis.size()),
      numbers_of_block_(matrices.numbers_of_vertex),
      vertices_(matrices.vertices.begin(), matrices.vertices.end()),
      vertex_buffer_(storage(context, matrices.vertices)),
      split_terms_(storage<SparseRow>(
          context, rows_of(matrices.basis.packed_size(), size_,
                           [&](const Lanes* in, Lanes* out) { matrices.basis.split(in, out); }))),
      join_terms_(storage<SparseRow>(
          context, rows_of(size_, matrices.basis.packed_size(),
                           [&](const Lanes* in, Lanes* out) { matrices.basis.join(in, out); }))),
      rows_(storage<std::array<std::int32_t, 4>>(context, matrix_rows(matrices.basis))) {
    const std::size_t of_block = numbers_of_block_ * kLanes;
    const std::size_t blocks = matrices.numbers.size() / of_block;
    const std::size_t most = context->limits().storage_bytes / (of_block * sizeof(std::int16_t));
    for (std::size_t first = 0; first < blocks; first += most) {
        const std::size_t last = std::min(blocks, first + most);
        pieces_.push_back(
            {first, last,
             storage(context,
                     std::span(matrices.numbers).subspan(first * of_block, (last - first) * of_block))});
    }
    multiply_.set("numbers_of_block", static_cast<int>(numbers_of_block_));
    multiply_.set("scale", 1 / kFixedOne);
}

void DeviceShadows::run(DeviceLight& light) {
    const std::size_t bytes = size_ * light.stride() * sizeof(float);
    if (!work_ || work_->size() < bytes) {
        work_.reset();
        work_.emplace(context_, gl::BufferUse::storage, bytes, gl::BufferUpdate::fixed);
    }
    const auto rank = [&](std::size_t vertex) {
        return static_cast<std::size_t>(std::ranges::lower_bound(vertices_, vertex) - vertices_.begin());
    };
    for (const Piece& piece : pieces_) {
        const std::size_t first = std::max(rank(light.first()), piece.first_block * kLanes);
        const std::size_t last = std::min(rank(light.last()), piece.last_block * kLanes);
        if (first >= last) continue;
        for (gl::Program* program : {&multiply_, &join_}) {
            program->set("first", static_cast<int>(first));
            program->set("count", static_cast<int>(last - first));
            program->set("first_vertex", static_cast<int>(light.first()));
            program->set("stride", static_cast<int>(light.stride()));
        }
        multiply_.set("first_block", static_cast<int>(piece.first_block));
        vertex_buffer_.bind_storage(0);
        for (int c = 0; c < light.channels(); ++c) {
            piece.numbers.bind_storage(1);
            light.bind(2, c);
            split_terms_.bind_storage(3);
            rows_.bind_storage(4);
            work_->bind_storage(5, 0, bytes);
            gl::dispatch(multiply_, groups_for(last - first), static_cast<unsigned>(size_));
            work_->bind_storage(1, 0, bytes);
            join_terms_.bind_storage(3);
            gl::dispatch(join_, groups_for(last - first), static_cast<unsigned>(light.numbers()));
        }
    }
}

}  // namespace nicol
