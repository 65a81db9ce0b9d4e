// SPDX-License-Identifier: MIT
#include "render/gpu/device_shadow_matrices.hpp"

#include <array>
#include <vector>

#include "gl/draw.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// For each number of a light: the first element of its matrix, its row, the size of the matrix and where the
// numbers that it multiplies begin in a light.
std::vector<std::array<std::int32_t, 4>> matrix_rows(const ShadowMatrices& matrices, std::size_t numbers) {
    std::vector<std::array<std::int32_t, 4>> rows(numbers);
    std::size_t element = 0;
    for (const ShadowMatrices::Block& block : matrices.blocks()) {
        const std::size_t size = block.triples.size();
        for (std::size_t part = 0; part < block.parts; ++part) {
            for (std::size_t row = 0; row < size; ++row) {
                rows[block.begin[part] + row] = {
                    static_cast<std::int32_t>(element), static_cast<std::int32_t>(row),
                    static_cast<std::int32_t>(size), static_cast<std::int32_t>(block.begin[part])};
            }
        }
        element += block.triples.elements();
    }
    return rows;
}

}  // namespace

DeviceShadowMatrices::DeviceShadowMatrices(const std::shared_ptr<gl::Context>& context,
                                           const VisibilityProduct& shadows)
    : context_(context),
      multiply_(gl::Program::compute(context, "shadow_multiply.comp")),
      store_(gl::Program::compute(context, "shadow_store.comp")),
      numbers_(context, shadows),
      rows_(storage(context, matrix_rows(*shadows.matrices(), shadows.layout().size()))) {
    multiply_.set("numbers_of_block", static_cast<int>(shadows.numbers_of_vertex()));
    multiply_.set("scale", shadows.unit() / kFixedOne);
}

void DeviceShadowMatrices::run(DeviceLight& light) {
    const std::size_t bytes = light.numbers() * light.stride() * sizeof(float);
    if (!product_ || product_->size() < bytes) {
        product_.reset();
        product_.emplace(context_, gl::BufferUse::storage, bytes, gl::BufferUpdate::fixed);
    }
    const auto multiply = [&](std::size_t first, std::size_t last, std::size_t first_block,
                              const gl::Buffer& numbers) {
        for (gl::Program* program : {&multiply_, &store_}) {
            program->set("first", static_cast<int>(first));
            program->set("count", static_cast<int>(last - first));
            program->set("first_vertex", static_cast<int>(light.first()));
            program->set("stride", static_cast<int>(light.stride()));
        }
        multiply_.set("first_block", static_cast<int>(first_block));
        store_.set("gathered_stride", static_cast<int>(light.stride()));
        numbers_.vertices().bind_storage(0);
        for (int c = 0; c < light.channels(); ++c) {
            numbers.bind_storage(1);
            light.bind(2, c);
            rows_.bind_storage(3);
            product_->bind_storage(4, 0, bytes);
            gl::dispatch(multiply_, groups_for(last - first), static_cast<unsigned>(light.numbers()));
            product_->bind_storage(1, 0, bytes);
            gl::dispatch(store_, groups_for(last - first), static_cast<unsigned>(light.numbers()));
        }
    };
    numbers_.for_chunks(light, light.count(), multiply);
}

}  // namespace nicol
