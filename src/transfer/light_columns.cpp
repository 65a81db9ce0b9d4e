// SPDX-License-Identifier: MIT
#include "transfer/light_columns.hpp"

#include <algorithm>

namespace nicol {

void get_columns(const LightColumns& from, std::size_t first, VertexLight& light, std::size_t block) {
    const std::size_t count = std::min(kLanes, from.points() - first);
    for (std::size_t c = 0; c < from.columns(); ++c) {
        const std::span<Lanes> numbers = light.block(block, static_cast<int>(c));
        for (std::size_t i = 0; i < count; ++i) {
            const Lanes* const lights = from.at(first + i) + c / kLanes;
            for (std::size_t j = 0; j < numbers.size(); ++j)
                numbers[j][i] = lights[j * from.lanes()][c % kLanes];
        }
    }
}

void put_columns(const VertexLight& light, std::size_t block, std::size_t first, LightColumns& out) {
    const std::size_t count = std::min(kLanes, out.points() - first);
    for (std::size_t c = 0; c < out.columns(); ++c) {
        const std::span<const Lanes> numbers = light.block(block, static_cast<int>(c));
        for (std::size_t i = 0; i < count; ++i) {
            Lanes* const to = out.at(first + i) + c / kLanes;
            for (std::size_t j = 0; j < numbers.size(); ++j) to[j * out.lanes()][c % kLanes] = numbers[j][i];
        }
    }
}

}  // namespace nicol
