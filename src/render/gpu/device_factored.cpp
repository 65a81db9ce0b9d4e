// SPDX-License-Identifier: MIT
#include "render/gpu/device_factored.hpp"

#include "gl/context.hpp"

namespace nicol {

void DeviceFactored::relight(const FactoredMethod& method, const TransferInput& input, Progress& progress,
                             VertexBuffers& buffers) {
    allocate_light(input);
    copy_shadows(method);
    if (!rotation_) rotation_.emplace(context_);
    rotation_->set_light(input.layout, input.light);
    for (DeviceLight& light : light_) {
        progress.report("relight", static_cast<double>(light.first()) /
                                       static_cast<double>(input.geometry.positions.size()));
        rotation_->run(input.geometry, buffers, light);
        if (shadow_matrices_) shadow_matrices_->run(light);
        if (shadow_grid_) shadow_grid_->run(light);
    }
}

void DeviceFactored::copy_tables(const FactoredMethod& method, const TransferInput& input) {
    copying_tables_.run(method.tables().version(), [&] {
        tables_.clear();
        for (const auto& [material, table] : *method.tables()) {
            tables_.emplace(material, DeviceTable(context_, input.layout, table));
        }
    });
}

void DeviceFactored::copy_shadows(const FactoredMethod& method) {
    copying_shadows_.run(method.shadows().version(), [&] {
        shadow_matrices_.reset();
        shadow_grid_.reset();
        const std::optional<VisibilityProduct>& shadows = *method.shadows();
        if (!shadows) return;
        if (shadows->matrices() != nullptr) shadow_matrices_.emplace(context_, *shadows);
        if (shadows->grid() != nullptr) shadow_grid_.emplace(context_, *shadows);
    });
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

void DeviceFactored::shade(const FactoredMethod& method, const TransferInput& input, DeviceShade& shade,
                           VertexBuffers& buffers) {
    copy_tables(method, input);
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
