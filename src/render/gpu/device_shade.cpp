// SPDX-License-Identifier: MIT
#include "render/gpu/device_shade.hpp"

#include <algorithm>

#include "gl/draw.hpp"
#include "render/view_uniforms.hpp"

namespace nicol {

DeviceTable::DeviceTable(const std::shared_ptr<gl::Context>& context, const LightLayout& layout,
                         const ResponseTable& table)
    : layout_(layout),
      angles_(ResponseTable::kAngles),
      makes_linear_(table.makes(1) || table.makes(2)),
      makes_circular_(table.makes(3)) {
    std::vector<float> rows;
    for (int c = 0; c < table.channels(); ++c) {
        rows.clear();
        for (int angle = 0; angle < angles_; ++angle) {
            const std::span<const float> from = table.rows(angle, c);
            rows.insert(rows.end(), from.begin(), from.end());
        }
        upload(context, rows);
    }
}

DeviceTable::DeviceTable(const std::shared_ptr<gl::Context>& context, const LightLayout& layout,
                         std::span<const float> harmonics)
    : layout_(layout),
      angles_(static_cast<int>(harmonics.size() / layout.size())),
      makes_linear_(layout.kind() != LightKind::unpolarized),
      makes_circular_(layout.kind() == LightKind::full) {
    const std::size_t n = layout.size();
    std::vector<float> rows(4 * harmonics.size());
    for (std::size_t angle = 0; angle < static_cast<std::size_t>(angles_); ++angle) {
        for (std::size_t j = 0; j < n; ++j) {
            const float value = harmonics[angle * n + j];
            float* row = &rows[4 * n * angle + j];
            const LightKind part = layout.entries()[j].part;
            if (part == LightKind::unpolarized) row[0] = value;
            if (part == LightKind::linear) row[n] = row[2 * n] = value;
            if (part == LightKind::full) row[3 * n] = value;
        }
    }
    upload(context, rows);
}

void DeviceTable::upload(const std::shared_ptr<gl::Context>& context, std::span<const float> rows) {
    channels_.emplace_back(context, gl::BufferUse::storage, std::as_bytes(rows));
}

DeviceShade::DeviceShade(const std::shared_ptr<gl::Context>& context)
    : program_(gl::Program::compute(context, "shade.comp")) {}

void DeviceShade::set_view(const Viewpoint& view) {
    set_view_uniforms(program_, view);
}

void DeviceShade::run(const DeviceTable& table, const DeviceLight& light, std::size_t first, std::size_t last,
                      const WorldGeometry& geometry, int channels, VertexBuffers& buffers) {
    const std::size_t begin = bind_vertices(*buffers.positions(), 0, 3, first, last);
    std::ignore = bind_vertices(*buffers.normals(geometry), 1, 3, first, last);
    program_.set("first", static_cast<int>(first - begin));
    program_.set("light_first", static_cast<int>(first - light.first()));
    program_.set("count", static_cast<int>(last - first));
    program_.set("stride", static_cast<int>(light.stride()));
    program_.set("order", table.layout_.order());
    program_.set("entries", static_cast<int>(table.layout_.size()));
    program_.set("angles", table.angles_);
    program_.set("polarized", table.layout_.kind() != LightKind::unpolarized ? 1 : 0);
    program_.set("circular", table.layout_.kind() == LightKind::full ? 1 : 0);
    program_.set("makes_linear", table.makes_linear_ ? 1 : 0);
    program_.set("makes_circular", table.makes_circular_ ? 1 : 0);
    for (int c = 0; c < channels; ++c) {
        light.bind(2, light.channels() == 1 ? 0 : c);
        table.channels_[table.channels_.size() == 1 ? 0 : static_cast<std::size_t>(c)].bind_storage(3);
        std::ignore = bind_vertices(*buffers.stokes(c), 4, 4, first, last);
        gl::dispatch(program_, groups_for(last - first));
    }
}

}  // namespace nicol
