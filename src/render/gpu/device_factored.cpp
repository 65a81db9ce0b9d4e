// SPDX-License-Identifier: MIT
#include "render/gpu/device_factored.hpp"

#include "gl/context.hpp"

namespace nicol {

void DeviceFactored::relight(const FactoredMethod& method, const TransferInput& input, Progress& progress,
                             VertexBuffers& buffers) {
    allocate_light(input);
    copy_shadows(method);
    set_light(input);
    const gl::Buffer& normals = *buffers.normals(input.geometry);
    for (DeviceLight& light : light_) {
        progress.report("relight", static_cast<double>(light.first()) /
                                       static_cast<double>(input.geometry.positions.size()));
        rotation_->run(normals, light);
        if (shadow_matrices_) shadow_matrices_->run(light);
        if (shadow_grid_) shadow_grid_->run(light);
        if (input.at_pixels) rotation_->into_world(normals, light);
    }
}

void DeviceFactored::set_light(const TransferInput& input) {
    if (!rotation_) rotation_.emplace(context_);
    rotation_->set_layout(input.layout);
    rotation_->set_light(input.light);
}

std::size_t DeviceFactored::most_points(const TransferInput& input) const {
    return DeviceLight::most_vertices(
        *context_, std::max(input.layout.size(), DeviceRotation::work_space(input.layout)));
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
    const std::size_t step = most_points(input);
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
                           const DevicePoints& vertices) {
    copy_tables(method, input);
    for (const DeviceLight& light : light_) {
        for (const VertexRange& range : input.geometry.ranges) {
            const std::size_t first = std::max(range.first, light.first());
            const std::size_t last = std::min(range.last, light.last());
            if (first >= last) continue;
            shade.run(tables_.at(range.material), light, first, last, vertices);
        }
    }
}

std::size_t DeviceFactored::prepare_pixels(const FactoredMethod& method, const PixelInput& input) {
    copy_tables(method, input);
    set_light(input);
    return most_points(input);
}

void DeviceFactored::light_pixels(const PixelInput& input, const PixelRun& run, DevicePixels& pixels) {
    const DevicePoints& points = pixels.points();
    DeviceLight& light = pixels.light(run, input.layout.size(), input.light.channels());
    if (run.occluded) {
        for (const DeviceLight& of_vertices : light_) pixels.interpolate(of_vertices, run, light);
        rotation_->into_frames(*points.normals, light);
    } else {
        rotation_->run(*points.normals, light);
    }
}

void DeviceFactored::shade_pixels(const MaterialPtr& material, const PixelInput& input, const PixelRun& run,
                                  DevicePixels& pixels, DeviceShade& shade, const DevicePoints& points) {
    const DeviceLight& light = pixels.light(run, input.layout.size(), input.light.channels());
    shade.run(tables_.at(material), light, run.first, run.last, points);
}

}  // namespace nicol
