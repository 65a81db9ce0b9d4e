// SPDX-License-Identifier: MIT
#include "render/gpu/device_factored.hpp"

#include "gl/context.hpp"

namespace nicol {

void DeviceFactored::relight(const FactoredMethod& method, const TransferInput& input, Progress& progress,
                             Statistics& statistics, VertexBuffers& buffers) {
    mirror_tables(method, input);
    const RelightKey key(input);
    if (lit_for_ == key) return;
    lit_for_ = {};
    allocate_light(input);
    mirror_shadows(method, input);
    const Stopwatch watch;
    if (!rotation_) rotation_.emplace(context_);
    rotation_->set_light(input.layout, input.light);
    for (DeviceLight& light : light_) {
        progress.report("relight", static_cast<double>(light.first()) /
                                       static_cast<double>(input.geometry.positions.size()));
        rotation_->run(input.geometry, buffers, light);
        if (shadow_matrices_) shadow_matrices_->run(light);
        if (shadow_grid_) shadow_grid_->run(light);
    }
    gl::finish(*context_);
    statistics.vertices_relit += input.geometry.positions.size();
    statistics.relight_ms += watch.milliseconds();
    lit_for_ = key;
}

void DeviceFactored::mirror_tables(const FactoredMethod& method, const TransferInput& input) {
    if (tables_revision_ == method.tables_revision()) return;
    tables_revision_ = 0;
    tables_.clear();
    for (const auto& [material, table] : method.tables()) {
        tables_.emplace(material, DeviceTable(context_, input.layout, table));
    }
    tables_revision_ = method.tables_revision();
}

void DeviceFactored::mirror_shadows(const FactoredMethod& method, const TransferInput& input) {
    const RelightKey key = RelightKey(input).without_light();
    if (shadows_for_ == key) return;
    shadows_for_ = {};
    shadow_matrices_.reset();
    shadow_grid_.reset();
    if (method.shadows()) {
        if (method.shadows()->matrices() != nullptr) shadow_matrices_.emplace(context_, *method.shadows());
        if (method.shadows()->grid() != nullptr) shadow_grid_.emplace(context_, *method.shadows());
    }
    shadows_for_ = key;
}

void DeviceFactored::allocate_light(const TransferInput& input) {
    const std::size_t vertices = input.geometry.positions.size();
    const std::size_t numbers = input.layout.size();
    const std::size_t step =
        DeviceLight::most_vertices(*context_, std::max(numbers, DeviceRotation::work_space(input.layout)));
    const bool same = !light_.empty() && light_.back().last() == vertices &&
                      light_.front().count() == std::min(step, vertices) &&
                      light_.front().numbers() == numbers &&
                      light_.front().channels() == input.light.channels();
    if (same) return;
    light_.clear();
    for (std::size_t first = 0; first < vertices; first += step) {
        light_.emplace_back(context_, first, std::min(step, vertices - first), numbers,
                            input.light.channels());
    }
}

void DeviceFactored::shade(const TransferInput& input, DeviceShade& shade, VertexBuffers& buffers) {
    for (const DeviceLight& light : light_) {
        for (const VertexRange& range : input.geometry.ranges) {
            const std::size_t first = std::max(range.first, light.first());
            const std::size_t last = std::min(range.last, light.last());
            if (first >= last) continue;
            shade.run(tables_.at(range.material), light, first, last, input.geometry, input.channels,
                      buffers);
        }
    }
}

}  // namespace nicol
