// SPDX-License-Identifier: MIT
#include "dense_memory.hpp"

#include <cmath>

namespace {

constexpr int kMeasuredOrder = 2;

}

DenseMemory::DenseMemory(const SceneSource& source) {
    const Stage stage(source);
    const Framebuffer framebuffer = stage.framebuffer(8, 8);
    const Recipe recipe{.method = NICOL_METHOD_DENSE, .low = kMeasuredOrder, .shadows = false};
    const nicol_statistics statistics = stage.render(recipe.options(), framebuffer.get());
    per_entry_ = 1e-9 * static_cast<double>(statistics.transfer_bytes) / std::pow(kMeasuredOrder + 1, 4);
}

double DenseMemory::at(int order) const {
    return per_entry_ * std::pow(order + 1, 4);
}
