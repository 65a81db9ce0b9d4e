// SPDX-License-Identifier: MIT
#include "devices/gl/device_factored.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "gl/context.hpp"
#include "gl/draw.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// Returns for each number of a light: the first element of its matrix, its row, the size of the matrix, and
// the index in a light where the numbers that it multiplies begin.
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
      rows_(gl::storage(context, matrix_rows(*shadows.matrices(), shadows.layout().size()))) {
    multiply_.set("numbers_of_block", static_cast<int>(shadows.numbers_of_vertex()));
    multiply_.set("scale", shadows.unit() / kFixedOne);
}

void DeviceShadowMatrices::run(DeviceLight& light) {
    const int most =
        gl::channels_at_once(*context_, light.channels(), light.channel_bytes(), DeviceLight::kWorkBytes);
    gl::make_room(context_, product_, static_cast<std::size_t>(most) * light.channel_bytes());
    const auto multiply = [&](std::size_t first, std::size_t last, std::size_t first_block,
                              const gl::Buffer& numbers) {
        for (gl::Program* program : {&multiply_, &store_}) {
            program->set("first", static_cast<int>(first));
            program->set("count", static_cast<int>(last - first));
            program->set("first_vertex", static_cast<int>(light.first()));
            program->set("stride", static_cast<int>(light.stride()));
            program->set("light_step", static_cast<int>(light.channel_step()));
        }
        multiply_.set("first_block", static_cast<int>(first_block));
        store_.set("gathered_stride", static_cast<int>(light.stride()));
        store_.set("gathered_step", static_cast<int>(light.channel_step()));
        numbers_.vertices().bind_storage(0);
        gl::for_channels(light.channels(), most, [&](gl::ChannelGroup channels) {
            const auto count = static_cast<unsigned>(channels.count);
            const auto coefficients = static_cast<unsigned>(light.coefficients());
            numbers.bind_storage(1);
            light.bind(2, channels);
            rows_.bind_storage(3);
            product_->bind_storage(4, 0, count * light.channel_bytes());
            gl::dispatch(multiply_, gl::groups_for(last - first), coefficients, count);
            product_->bind_storage(1, 0, count * light.channel_bytes());
            gl::dispatch(store_, gl::groups_for(last - first), coefficients, count);
        });
    };
    numbers_.for_chunks(light, light.count(), multiply);
}

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
        if (input.bounces > 0) add_bounced(method.bounces(), light);
    }
}

void DeviceFactored::add_bounced(const Bounces& bounces, DeviceLight& light) {
    if (!add_bounced_) add_bounced_ = gl::Program::compute(context_, "bounced.comp");
    const std::vector<std::uint32_t> numbers(bounces.places().begin(), bounces.places().end());
    const gl::Buffer places = gl::storage(context_, numbers);
    DeviceLight bounced(context_, light.first(), light.count(), numbers.size(), light.channels());
    std::vector<float> row(numbers.size());
    bounced.upload([&](std::size_t vertex, int channel) -> std::span<const float> {
        const std::span<const Lanes> from = bounces.light().block(vertex / kLanes, channel);
        for (std::size_t j = 0; j < row.size(); ++j) row[j] = from[j][vertex % kLanes];
        return row;
    });
    places.bind_storage(2);
    add_bounced_->set("count", static_cast<int>(light.count()));
    add_bounced_->set("stride", static_cast<int>(light.stride()));
    add_bounced_->set("from_step", static_cast<int>(bounced.channel_step()));
    add_bounced_->set("light_step", static_cast<int>(light.channel_step()));
    const std::size_t largest = std::max(bounced.channel_bytes(), light.channel_bytes());
    gl::for_independent_channels(*context_, light.channels(), largest, [&](gl::ChannelGroup channels) {
        bounced.bind(0, channels);
        light.bind(1, channels);
        gl::dispatch(*add_bounced_, gl::groups_for(light.count()), static_cast<unsigned>(numbers.size()),
                     static_cast<unsigned>(channels.count));
    });
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
    const std::size_t coefficients = input.layout.size();
    const std::size_t step = most_points(input);
    const bool same = !light_.empty() && light_.back().last() == vertices &&
                      light_.front().count() == std::min(step, vertices) &&
                      light_.front().coefficients() == coefficients &&
                      light_.front().channels() == input.light.channels();
    if (same) return;
    light_.clear();
    for (std::size_t first = 0; first < vertices; first += step) {
        light_.emplace_back(context_, first, std::min(step, vertices - first), coefficients,
                            input.light.channels());
    }
}

void DeviceFactored::shade(const FactoredMethod& method, const TransferInput& input, DeviceShade& shade,
                           const DevicePoints& vertices) {
    copy_tables(method, input);
    const gl::IndependentDispatches of_ranges(*context_);
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

void DeviceFactored::light_pixels(const PixelInput& input, const PixelStretch& stretch,
                                  DevicePixels& pixels) {
    DeviceLight& light =
        pixels.light(stretch.first(), stretch.last(), input.layout.size(), input.light.channels());
    const std::size_t occluded = stretch.occluded();
    if (occluded < stretch.last()) {
        for (const DeviceLight& of_vertices : light_)
            pixels.interpolate(of_vertices, of_vertices.first() > 0, occluded, light);
    }
    rotation_->into_frames(*pixels.points().normals, occluded, light);
}

void DeviceFactored::shade_pixels(const MaterialPtr& material, const PixelRun& run,
                                  const DevicePixels& pixels, DeviceShade& shade,
                                  const DevicePoints& points) {
    shade.run(tables_.at(material), pixels.light(), run.first, run.last, points);
}

}  // namespace nicol
